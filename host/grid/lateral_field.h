#pragma once
#include <cassert>
#include <vector>

#include "grid/grid_topology.h"

namespace morphgrid {

/// One value per lateral strut of a layer of nodesU x nodesV nodes.
/// u struts: nodesU x (nodesV+1) of them, along +u; v struts: (nodesU+1) x nodesV, along +v.
template <typename T>
class LateralField {
 public:
  LateralField() = default;
  LateralField(int nodesU, int nodesV, T value = {})
      : nodesU_(nodesU),
        nodesV_(nodesV),
        u_(static_cast<std::size_t>(nodesU) * (nodesV + 1), value),
        v_(static_cast<std::size_t>(nodesU + 1) * nodesV, value) {}

  int nodesU() const { return nodesU_; }
  int nodesV() const { return nodesV_; }
  /// The layer, for forEachLateralStrut().
  GridShape shape() const { return {nodesU_ + 1, nodesV_ + 1, 1}; }

  /// The strut from vertex (i, j) to (i+1, j); 0 <= i < nodesU, 0 <= j <= nodesV.
  T& u(int i, int j) { return u_[indexU(i, j)]; }
  const T& u(int i, int j) const { return u_[indexU(i, j)]; }
  /// The strut from vertex (i, j) to (i, j+1); 0 <= i <= nodesU, 0 <= j < nodesV.
  T& v(int i, int j) { return v_[indexV(i, j)]; }
  const T& v(int i, int j) const { return v_[indexV(i, j)]; }

  /// A lateral strut of shape(), or of any layer of it.
  T& at(const Strut& strut) { return at(*this, strut); }
  const T& at(const Strut& strut) const { return at(*this, strut); }

  const std::vector<T>& allU() const { return u_; }
  const std::vector<T>& allV() const { return v_; }

 private:
  template <typename Field>  // LateralField or const LateralField
  static auto& at(Field& field, const Strut& strut) {
    assert(strut.isLateral());
    const GridPlace place = field.shape().place(strut.from);
    return strut.direction == Strut::Direction::u ? field.u(place.i, place.j)
                                                  : field.v(place.i, place.j);
  }
  std::size_t indexU(int i, int j) const {
    assert(i >= 0 && i < nodesU_ && j >= 0 && j <= nodesV_);
    return static_cast<std::size_t>(j) * nodesU_ + i;
  }
  std::size_t indexV(int i, int j) const {
    assert(i >= 0 && i <= nodesU_ && j >= 0 && j < nodesV_);
    return static_cast<std::size_t>(j) * (nodesU_ + 1) + i;
  }

  int nodesU_ = 0;
  int nodesV_ = 0;
  std::vector<T> u_;
  std::vector<T> v_;
};

}  // namespace morphgrid
