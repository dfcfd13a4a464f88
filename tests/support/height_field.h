#pragma once
#include <functional>
#include <string>

namespace morphgrid {

/// An OBJ file of x(y, z) over [-1, 1]^2 in 20 x 20 cells of two triangles; cells whose middle
/// `cut` names are left out.
std::string heightFieldObj(const std::function<double(double, double)>& x,
                           const std::function<bool(double, double)>& cut = nullptr);

/// It curves by 0.4 along y and z at its middle, towards +x.
inline double dome(double y, double z) { return 0.2 * (y * y + z * z); }

}  // namespace morphgrid
