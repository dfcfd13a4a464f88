#pragma once
#include <cassert>
#include <vector>

namespace morphgrid {

/// The strut from vertex (i, j) to the next along u or v.
struct LateralStrut {
  bool alongU;
  int i;
  int j;

  int toI() const { return alongU ? i + 1 : i; }
  int toJ() const { return alongU ? j : j + 1; }
};

/// visit(LateralStrut) for all struts of a layer of nodesU x nodesV nodes, those along u first.
template <typename Visit>
void forEachLateralStrut(int nodesU, int nodesV, Visit visit) {
  for (int j = 0; j <= nodesV; ++j) {
    for (int i = 0; i < nodesU; ++i) {
      visit(LateralStrut{true, i, j});
    }
  }
  for (int j = 0; j < nodesV; ++j) {
    for (int i = 0; i <= nodesU; ++i) {
      visit(LateralStrut{false, i, j});
    }
  }
}

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

  /// The strut from vertex (i, j) to (i+1, j); 0 <= i < nodesU, 0 <= j <= nodesV.
  T& u(int i, int j) { return u_[indexU(i, j)]; }
  const T& u(int i, int j) const { return u_[indexU(i, j)]; }
  /// The strut from vertex (i, j) to (i, j+1); 0 <= i <= nodesU, 0 <= j < nodesV.
  T& v(int i, int j) { return v_[indexV(i, j)]; }
  const T& v(int i, int j) const { return v_[indexV(i, j)]; }

  T& at(const LateralStrut& strut) {
    return strut.alongU ? u(strut.i, strut.j) : v(strut.i, strut.j);
  }
  const T& at(const LateralStrut& strut) const {
    return strut.alongU ? u(strut.i, strut.j) : v(strut.i, strut.j);
  }

  const std::vector<T>& allU() const { return u_; }
  const std::vector<T>& allV() const { return v_; }

 private:
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
