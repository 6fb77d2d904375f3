#include "colour/munsell.h"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "colour/munsell_table.h"

namespace ostraka::colour {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const Vector2d kGrey(0.31006, 0.31616);  // illuminant C, 2 degrees
constexpr double kDark = 2.5;            // the soil books' half value

const std::set<std::string>& soilHues() {
  static const std::set<std::string> hues = {"10R", "2.5YR", "5YR", "7.5YR", "10YR", "2.5Y", "5Y"};
  return hues;
}

// ASTM D1535: luminous reflectance, 0 to 1, of a value. The table's own Y is that over magnesium
// oxide, 1 / 0.975 of it.
double reflectanceOf(double value) {
  const std::array<double, 5> factors = {1.1914, -0.22533, 0.23352, -0.020484, 0.00081939};
  double sum = 0, power = 1;
  for (const double factor : factors) sum += factor * (power *= value);
  return sum / 100;
}

Vector3d xyzOf(const Vector2d& xy, double reflectance) {
  return Vector3d(xy.x(), xy.y(), 1 - xy.sum()) * (reflectance / xy.y());
}

// Lindbloom's form of Bradford's adaptation, C to D50.
const Eigen::Matrix3d& d50FromC() {
  static const Eigen::Matrix3d matrix = [] {
    const Eigen::Matrix3d cones{
        {0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}};
    const Vector3d from = cones * xyzOf(kGrey, 1), to = cones * kWhite;
    return Eigen::Matrix3d(cones.inverse() * to.cwiseQuotient(from).asDiagonal() * cones);
  }();
  return matrix;
}

std::string written(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

// The chips of one hue and value, by chroma.
using Row = std::map<int, Vector2d>;

Row withOddChromas(Row row) {
  const auto first = row.find(2), second = row.find(4);
  if (first != row.end()) row[1] = (kGrey + first->second) / 2;
  if (first != row.end() && second != row.end()) row[3] = (first->second + second->second) / 2;
  return row;
}

class Book {
 public:
  std::vector<MunsellChip> made() {
    read();
    for (auto& [hue, values] : hues_) {
      if (soilHues().contains(hue)) {
        for (auto& [value, row] : values) row = withOddChromas(row);
        addDark(hue, values);
      }
      for (const auto& [value, row] : values)
        for (const auto& [chroma, xy] : row)
          add(hue + ' ' + written(value) + '/' + std::to_string(chroma), xy, value);
    }
    for (const double value : {2.0, kDark, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0})
      add("N " + written(value) + '/', kGrey, value);
    return std::move(chips_);
  }

 private:
  using Values = std::map<double, Row>;

  void read() {
    std::istringstream table{std::string(munsellTable())};
    std::string line;
    while (std::getline(table, line)) {
      std::istringstream words(line);
      std::string hue;
      double value = 0;
      words >> hue >> value;
      Row& row = hues_[hue][value];
      Vector2d xy;
      for (int chroma = 2; words >> xy.x() >> xy.y(); chroma += 2) row[chroma] = xy;
    }
  }

  // Half-way between values 2 and 3, up to chroma 4; the page of 10YR has 2 itself.
  static void addDark(const std::string& hue, Values& values) {
    if (hue == "10YR") return;
    Row dark;
    for (int chroma = 1; chroma <= 4; ++chroma) {
      const auto low = values[2].find(chroma), high = values[3].find(chroma);
      if (low != values[2].end() && high != values[3].end())
        dark[chroma] = (low->second + high->second) / 2;
    }
    values[kDark] = std::move(dark);
  }

  void add(const std::string& notation, const Vector2d& xy, double value) {
    chips_.push_back({notation, labOfXyz(d50FromC() * xyzOf(xy, reflectanceOf(value)))});
  }

  std::map<std::string, Values> hues_;
  std::vector<MunsellChip> chips_;
};

}  // namespace

const std::vector<MunsellChip>& munsellChips() {
  static const std::vector<MunsellChip> chips = Book().made();
  return chips;
}

MunsellMatch nearestMunsell(const Lab& lab) {
  MunsellMatch match{{}, {}, INFINITY, INFINITY};
  for (const MunsellChip& chip : munsellChips()) {
    const double difference = ciede2000(lab, chip.lab);
    if (difference < match.difference) {
      match = {chip.notation, match.notation, difference, match.difference};
    } else if (difference < match.second_difference) {
      match.second = chip.notation;
      match.second_difference = difference;
    }
  }
  return match;
}

}  // namespace ostraka::colour
