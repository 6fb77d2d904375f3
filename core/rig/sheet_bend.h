#pragma once
#include <algorithm>
#include <array>
#include <cmath>

namespace ostraka::rig {

/// How a printed sheet leaves its plane: a polynomial of degree 2 to 4 without tilt or offset.
struct SheetBend {
  static constexpr int kTerms = 12;
  double reach_mm = 1;  ///< unit of x and y in the polynomial: the sheet's half diagonal
  std::array<double, kTerms> coefficients_mm{};

  /// z of the paper at (x, y), sheet frame, mm; a point beyond reach_mm lies as high as one there.
  double at(double x_mm, double y_mm) const {
    const double reach = std::max(reach_mm, std::hypot(x_mm, y_mm));
    return height(coefficients_mm.data(), x_mm / reach, y_mm / reach);
  }
  /// The largest height or depth within a reach.
  double most() const {
    double most = 0;
    for (int x = -8; x <= 8; ++x)
      for (int y = -8; y <= 8; ++y)
        if (x * x + y * y <= 64)
          most = std::max(most, std::abs(height(coefficients_mm.data(), x / 8.0, y / 8.0)));
    return most;
  }
  bool flat() const {
    for (const double c : coefficients_mm)
      if (c != 0) return false;
    return true;
  }

  /// coefficients: kTerms; x, y in units of reach_mm. T: double or a dual number.
  template <class T>
  static T height(const T* coefficients, double x, double y) {
    T z(0);
    int term = 0;
    for (int degree = 2; degree <= 4; ++degree)
      for (int k = 0; k <= degree; ++k)
        z += coefficients[term++] * (std::pow(x, degree - k) * std::pow(y, k));
    return z;
  }
};

}  // namespace ostraka::rig
