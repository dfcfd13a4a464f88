#include "target/target.h"

namespace morphgrid {

const ClosestPointQuery& Target::closestPoints() const {
  std::call_once(closestPointsMade_, [this] { closestPoints_.emplace(makeClosestPoints()); });
  return *closestPoints_;
}

}  // namespace morphgrid
