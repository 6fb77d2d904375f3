#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace ostraka::rig {

/// How a printed sheet leaves its plane: a polynomial of degree 2 to 4 without tilt or offset.
struct SheetBend {
  static constexpr int kTerms = 12;
  static constexpr double kInscribed = 0.577;  ///< half an A4 sheet's width, in half diagonals
  double reach_mm = 1;  ///< unit of x and y in the polynomial: the sheet's half diagonal
  std::array<double, kTerms> coefficients_mm{};

  /// z of the paper at (x, y), sheet frame, mm; a point beyond reach_mm lies as high as one there.
  double at(double x_mm, double y_mm) const {
    if (flat()) return 0;
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
  /// How far the paper at (x, y) lies above its lowest place in the disc that any sheet holds, mm.
  double rise(double x_mm, double y_mm) const {
    if (flat()) return 0;
    double lowest = 0;
    for (int x = -4; x <= 4; ++x)
      for (int y = -4; y <= 4; ++y)
        if (x * x + y * y <= 16)
          lowest = std::min(lowest,
                            height(coefficients_mm.data(), kInscribed * x / 4, kInscribed * y / 4));
    return std::max(0.0, at(x_mm, y_mm) - lowest);
  }
  bool flat() const {
    for (const double c : coefficients_mm)
      if (c != 0) return false;
    return true;
  }

  /// coefficients: kTerms; x, y in units of reach_mm. T: double or a dual number.
  template <class T>
  static T height(const T* coefficients, double x, double y) {
    std::array<double, 5> xs{1}, ys{1};  // powers
    for (std::size_t k = 1; k < xs.size(); ++k) xs[k] = xs[k - 1] * x, ys[k] = ys[k - 1] * y;
    T z(0);
    int term = 0;
    for (std::size_t degree = 2; degree < xs.size(); ++degree)
      for (std::size_t k = 0; k <= degree; ++k)
        z += coefficients[term++] * (xs[degree - k] * ys[k]);
    return z;
  }
};

/// What carries a sherd, in the plate's frame: z = 0 but for a sheet's bend. Absent: not known.
using Support = std::optional<SheetBend>;

/// {"reach": mm, "coefficients": [12], mm}.
nlohmann::ordered_json toJson(const SheetBend& bend);
/// Absent where the value describes none.
std::optional<SheetBend> sheetBendFrom(const nlohmann::json& value);

}  // namespace ostraka::rig
