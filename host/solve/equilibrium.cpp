#include "solve/equilibrium.h"

namespace morphgrid {

std::string toString(StopReason reason) {
  switch (reason) {
    case StopReason::residual:
      return "residual";
    case StopReason::energy:
      return "energy";
    case StopReason::iterationLimit:
      return "iteration limit";
    case StopReason::stagnated:
      return "stagnated";
    case StopReason::interrupted:
      return "interrupted";
    case StopReason::deviceFailure:
      return "device failure";
    case StopReason::laidOut:
      return "laid out";
  }
  return "unknown";
}

Verdict verdictOf(const Equilibrium& equilibrium) {
  return equilibrium.converged && equilibrium.smallestEigenvalue
             ? verdictOf(*equilibrium.smallestEigenvalue)
             : Verdict::undecided;
}

}  // namespace morphgrid
