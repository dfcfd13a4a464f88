#include "inverse/inverse_checkpoint.h"

#include "core/error.h"

namespace morphgrid {

std::string toString(InverseStep::Kind kind) {
  switch (kind) {
    case InverseStep::Kind::design:
      return "design";
    case InverseStep::Kind::compensate:
      return "compensate";
    case InverseStep::Kind::optimise:
      break;
  }
  return "optimise";
}

void requireSizes(const InverseCheckpoint& checkpoint, Eigen::Index lateralStruts,
                  Eigen::Index vertices) {
  bool fits = checkpoint.keptSteps <= checkpoint.steps.size() && !checkpoint.steps.empty();
  for (const InverseCheckpoint::Design* design : {&checkpoint.present, &checkpoint.kept}) {
    fits = fits && design->rest.size() == lateralStruts &&
           design->equilibrium.positions.cols() == vertices;
  }
  for (const BoundedLbfgs::Pair& pair : checkpoint.pairs) {
    fits = fits && pair.step.size() == lateralStruts && pair.change.size() == lateralStruts;
  }
  if (!fits) {
    throw InputError("the checkpoint's inverse design is not of this grid");
  }
}

}  // namespace morphgrid
