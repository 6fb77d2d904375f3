#include "records/sherd_comparison.h"

#include <algorithm>
#include <cmath>

#include "store/values.h"

namespace ostraka::records {
namespace {

constexpr double kLeastDifference = 0.01;

std::vector<std::string> sortedTerms(const std::string& text) {
  std::vector<std::string> terms = store::splitTerms(text);
  std::sort(terms.begin(), terms.end());
  return terms;
}

}  // namespace

Agreement compareTexts(FieldKind kind, const std::string& a, const std::string& b) {
  if (a == b) return Agreement::Same;
  if (a.empty() || b.empty()) return Agreement::OneBlank;
  const bool list = kind == FieldKind::Terms || kind == FieldKind::Joins;
  return list && sortedTerms(a) == sortedTerms(b) ? Agreement::Same : Agreement::Differs;
}

Agreement compareMeasurements(const Measurement& a, const Measurement& b) {
  const double apart = std::abs(b.value - a.value);
  if (apart < kLeastDifference) return Agreement::Same;
  return apart > std::hypot(a.uncertainty.value_or(0), b.uncertainty.value_or(0))
             ? Agreement::Differs
             : Agreement::WithinUncertainty;
}

}  // namespace ostraka::records
