#pragma once
#include <random>

#include "print/lay_struts.h"

namespace morphgrid {

/// Rest lengths of a print that is laid as planned, but shrinks otherwise.
class DisturbedRest {
 public:
  /// Keeps references. grid: as designed.
  DisturbedRest(const StrutGrid& grid, const PrintPlan& plan);

  /// What each lateral strut loses, times a factor; in the order of forEachLateralStrut().
  StrutValues withShrinks(const Eigen::VectorXd& factors) const;
  /// All lose that many times as much.
  StrutValues withAllShrinks(double factor) const {
    return withShrinks(Eigen::VectorXd::Constant(losses_.size(), factor));
  }
  /// Posts that many times as long.
  StrutValues withPosts(double factor) const;
  /// Lays, hubs and tubes that change otherwise than the material says.
  StrutValues withMaterial(const PrintMaterial& material) const;

  /// What each lateral strut loses, in the scene's unit.
  const Eigen::VectorXd& losses() const { return losses_; }
  const std::vector<DesignedStrut>& struts() const { return struts_; }

 private:
  const PrintPlan& plan_;
  std::vector<DesignedStrut> struts_;
  Eigen::VectorXd printed_, losses_;
};

/// The material with changes drawn at random, one sigma the errors that it names.
PrintMaterial drawnMaterial(const PrintMaterial& material, std::mt19937_64& generator);

/// Whether it names any.
bool hasErrors(const PrintMaterial& material);

}  // namespace morphgrid
