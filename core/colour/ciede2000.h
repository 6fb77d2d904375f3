#pragma once
#include <Eigen/Core>

namespace ostraka::colour {

/// CIE L*, a*, b* of illuminant D50, 2 degree observer.
using Lab = Eigen::Vector3d;

/// XYZ of the white of D50, and the Lab of XYZ under it.
inline const Eigen::Vector3d kWhite(0.96422, 1, 0.82521);
Lab labOfXyz(const Eigen::Vector3d& xyz);

/// Of linear sRGB (D65; red, green, blue, 1 is white), adapted to D50 by Bradford's matrix.
Lab labOf(const Eigen::Vector3d& light);
/// The inverse: what lies outside sRGB has negative parts.
Eigen::Vector3d lightOf(const Lab& lab);

/// The colour difference CIEDE2000 with all three weights 1; 1 is about what an eye just notices.
/// Sharma, Wu, Dalal, Color Research and Application 30, 2005.
double ciede2000(const Lab& one, const Lab& other);

}  // namespace ostraka::colour
