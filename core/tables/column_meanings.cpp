#include "tables/column_meanings.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "store/values.h"

namespace ostraka::tables {
namespace {

constexpr double kPerStep = 1000;  // three decimals: a micrometre, a milligram

}  // namespace

std::string tableNumber(double value) {
  // Adding 0 takes the sign off a zero.
  const double rounded = std::round(kPerStep * value) / kPerStep + 0.0;
  std::array<char, std::numeric_limits<double>::max_exponent10 + 20> buffer{};
  char* const end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), rounded, std::chars_format::fixed)
          .ptr;
  return {buffer.data(), end};
}

bool showsInTable(std::string_view typed, double value) {
  const Result<double> number = store::parsedNumber(typed);
  // A rounding of binary numbers beside the half of a step.
  return number && std::abs(*number - value) <= 0.5 / kPerStep + 1e-12 * std::abs(value);
}

const std::vector<ColumnMeaning>& columnMeanings() {
  static const std::vector<ColumnMeaning> all = {
      {"number", "", "the number written on the sherd; unique in the project"},
      {"uuid", "", "the sherd's identifier, the same on every computer"},
      {"state", "", "draft (no number yet), numbered or void"},
      {"void_reason", "", "why a number is void"},
      {"site", "", "code of the site"},
      {"trench", "", "code of the trench"},
      {"context", "", "number of the context within its trench or site"},
      {"bag", "", "number of the bag within its context"},
      {"part", "", "parts of the vessel that the sherd shows, separated by '; '"},
      {"ware", "", "ware"},
      {"fabric", "", "fabric"},
      {"inclusions", "", "inclusions"},
      {"manufacture", "", "how the vessel was formed"},
      {"firing", "", "oxidised, reduced or mixed"},
      {"surface_out", "", "treatment of the outer surface"},
      {"surface_in", "", "treatment of the inner surface"},
      {"decoration", "", "kinds of decoration; none: looked for and absent"},
      {"munsell_out", "", "Munsell colour of the outer surface, as a person entered it"},
      {"munsell_in", "", "Munsell colour of the inner surface, as a person entered it"},
      {"munsell_core", "", "Munsell colour of the break, as a person entered it"},
      {"condition", "", "state of preservation"},
      {"joins", "", "numbers of the sherds that fit this one"},
      {"vessel", "", "vessel that the sherd belongs to"},
      {"period", "", "period"},
      {"date_edtf", "", "date after EDTF; -0599 is 600 BC"},
      {"length_mm", "mm", "longer side of the smallest rectangle around the sherd seen from above"},
      {"width_mm", "mm", "shorter side of that rectangle"},
      {"thickness_min_mm", "mm", "wall thickness that 2 % of the wall are below"},
      {"thickness_mean_mm", "mm", "mean wall thickness, broken edges aside"},
      {"thickness_max_mm", "mm", "wall thickness that 2 % of the wall are above"},
      {"area_mm2", "mm2", "area of the whole surface, broken edges included"},
      {"volume_mm3", "mm3", "volume of the closed model"},
      {"filled_pct", "%", "share of the surface that no camera saw and that was closed"},
      {"rim_diameter_mm", "mm", "rim diameter of the vessel, estimated from a rim sherd"},
      {"rim_pct", "%", "share of the rim's circle that is preserved"},
      {"weight_g", "g", "weight, typed in"},
      {"batch", "", "batch of photographs that the sherd was measured in"},
      {"scale", "",
       "doubtful: known lengths other than the plate's contradict the scale, so all measurements "
       "by the program may be wrong by the same factor"},
      {"note", "", "note"},
      {"measured_by_hand", "",
       "columns whose measurements a person took, estimated or entered, separated by '; '; the "
       "program "
       "measured the others"},
      {"mass_centre_x_mm", "mm", "centre of mass of the model, in the coordinates of its PLY file"},
      {"mass_centre_y_mm", "mm", "the same, second coordinate"},
      {"mass_centre_z_mm", "mm", "the same, third coordinate, upwards from the plate"},
      {"model_file", "", "the sherd's model in this folder"},
      {"image_file", "", "the model's picture in this folder"},
      {"drawing_file", "", "the sherd's drawing in this folder"},
      {"licence", "", "licence of the project"},
      {"kind", "", "kind of context"},
      {"excavated_on", "", "day of the excavation"},
      {"closed", "", "yes: the context is finished; no: it is not; empty: nobody said"},
      {"collected_on", "", "day on which the bag was filled"},
      {"count_written", "", "number of sherds written on the bag"},
      {"storage", "", "where the bag is kept"}};
  return all;
}

}  // namespace ostraka::tables
