#include "app/disturbed_rest.h"

namespace morphgrid {

DisturbedRest::DisturbedRest(const StrutGrid& grid, const PrintPlan& plan)
    : plan_(plan), struts_(designedStruts(grid)) {
  const auto count = static_cast<Eigen::Index>(struts_.size());
  printed_.resize(count);
  losses_.resize(count);
  for (Eigen::Index n = 0; n < count; ++n) {
    printed_[n] = plan.enlargement * struts_[n].printed;
    losses_[n] = printed_[n] - valueAt(plan.rest, struts_[n].strut);
  }
}

StrutValues DisturbedRest::withShrinks(const Eigen::VectorXd& factors) const {
  // Of its printed length something is always left.
  constexpr double kLeastLeft = 0.02;
  StrutValues rest = plan_.rest;
  for (std::size_t n = 0; n < struts_.size(); ++n) {
    const auto at = static_cast<Eigen::Index>(n);
    valueAt(rest, struts_[n].strut) =
        std::max(kLeastLeft * printed_[at], printed_[at] - factors[at] * losses_[at]);
  }
  return rest;
}

StrutValues DisturbedRest::withPosts(double factor) const {
  constexpr double kLeastPost = 0.02;
  StrutValues rest = plan_.rest;
  for (double& post : rest.w) post *= std::max(kLeastPost, factor);
  return rest;
}

StrutValues DisturbedRest::withMaterial(const PrintMaterial& material) const {
  const StrutLay lay = strutLayOf(material, plan_.hub.diameter);
  Eigen::VectorXd factors = Eigen::VectorXd::Ones(losses_.size());
  for (std::size_t n = 0; n < struts_.size(); ++n) {
    const auto at = static_cast<Eigen::Index>(n);
    const double shrink =
        lay.shrinkAt(valueAt(plan_.shareAlong, struts_[n].strut), plan_.scale * printed_[at]);
    if (losses_[at] != 0) factors[at] = shrink * printed_[at] / losses_[at];
  }
  StrutValues rest = withShrinks(factors);
  const double taller = plan_.heights.tube * (material.tube.change - plan_.material.tube.change);
  if (plan_.heights.spacing > 0) {
    for (double& post : rest.w) post *= 1 + taller / plan_.heights.spacing;
  }
  return rest;
}

PrintMaterial drawnMaterial(const PrintMaterial& material, std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  PrintMaterial drawn = material;
  drawn.along.change += material.along.error * normal(generator);
  drawn.across.change += material.across.error * normal(generator);
  drawn.hub.change += material.hub.error * normal(generator);
  drawn.tube.change += material.tube.error * normal(generator);
  return drawn;
}

bool hasErrors(const PrintMaterial& material) {
  return material.along.error > 0 || material.across.error > 0 || material.hub.error > 0 ||
         material.tube.error > 0;
}

}  // namespace morphgrid
