#include "records/plausibility.h"

#include <algorithm>
#include <optional>
#include <set>

#include "records/sherd.h"

namespace ostraka::records {
namespace {

constexpr double kFar = 3;                              // callipers and models differ by far less
constexpr double kTenTimesLow = 8, kTenTimesHigh = 12;  // a slip of the unit, measured roughly

struct Order {
  const char *smaller, *larger;
};
constexpr Order kOrders[] = {{"width", "length"},
                             {"thickness_mean", "width"},
                             {"thickness_mean", "length"},
                             {"thickness_min", "thickness_mean"},
                             {"thickness_min", "thickness_max"},
                             {"thickness_mean", "thickness_max"}};

std::optional<double> valueOf(const MeasureValues& values, const std::string& kind) {
  const auto found = values.find(kind);
  return found == values.end() ? std::nullopt : std::optional(found->second);
}

Message withUnit(double value, const std::string& kind) {
  const std::string unit = unitOf(kind);
  return {"%1 " + (unit == "pct" ? "%" : unit), {shortDecimal(value, 2)}};
}

// Within a sentence.
Message nameOf(const std::string& kind) {
  if (kind == "length") return message("the length");
  if (kind == "width") return message("the width");
  if (kind == "thickness_min") return message("the minimum thickness");
  if (kind == "thickness_max") return message("the maximum thickness");
  return message("the thickness");
}

}  // namespace

std::vector<MeasureFinding> implausible(const std::vector<std::string>& kinds,
                                        const MeasureValues& measured,
                                        const MeasureValues& computed) {
  std::vector<MeasureFinding> findings;
  const std::set<std::string> asked(kinds.begin(), kinds.end());
  for (const std::string& kind : asked) {
    const std::optional<double> value = valueOf(measured, kind), model = valueOf(computed, kind);
    if (!value || !model || !(*value > 0) || !(*model > 0)) continue;
    const double factor = std::max(*value / *model, *model / *value);
    if (factor < kFar) continue;
    const bool ten_times = factor >= kTenTimesLow && factor <= kTenTimesHigh;
    findings.push_back({ten_times ? MeasureDoubt::TenTimesComputed : MeasureDoubt::FarFromComputed,
                        kind,
                        *value,
                        {},
                        *model});
  }
  for (const Order& order : kOrders) {
    const std::optional<double> smaller = valueOf(measured, order.smaller),
                                larger = valueOf(measured, order.larger);
    if (!asked.contains(order.smaller) && !asked.contains(order.larger)) continue;
    if (!smaller || !larger || *larger >= *smaller) continue;
    findings.push_back(
        {MeasureDoubt::OrderReversed, order.larger, *larger, order.smaller, *smaller});
  }
  return findings;
}

Message sentenceOf(const MeasureFinding& finding) {
  const Message value = withUnit(finding.value, finding.kind);
  const Message reference = withUnit(finding.reference, finding.kind);
  switch (finding.doubt) {
    case MeasureDoubt::TenTimesComputed:
      return finding.value > finding.reference
                 ? message("Check the unit: %1 is about ten times the computed value.", value)
                 : message("Check the unit: %1 is about a tenth of the computed value.", value);
    case MeasureDoubt::FarFromComputed:
      return message(
          "Check the value: %1 differs from the computed value by a factor of three or more.",
          value);
    case MeasureDoubt::OrderReversed:
      return message("Check the values: %1 (%2) is below %3 (%4).", nameOf(finding.kind), value,
                     nameOf(finding.than), reference);
    case MeasureDoubt::DeletesComputed:
      return message("The computed value is %1. Delete it?", reference);
    case MeasureDoubt::ReplacesComputed:
      break;
  }
  return message("The computed value is %1. Replace it with the measured value?", reference);
}

}  // namespace ostraka::records
