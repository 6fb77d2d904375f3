#pragma once
#include <compare>
#include <cstdint>

namespace ostraka::store {

/// Which row of a table; 0 is none. Rows keep their number as long as the project lives.
template <class Tag>
struct RowOf {
  std::int64_t value = 0;
  explicit operator bool() const { return value > 0; }
  auto operator<=>(const RowOf&) const = default;
};
using PersonRow = RowOf<struct PersonTag>;
using SiteRow = RowOf<struct SiteTag>;
using TrenchRow = RowOf<struct TrenchTag>;
using ContextRow = RowOf<struct ContextTag>;
using BagRow = RowOf<struct BagTag>;
using BatchRow = RowOf<struct BatchTag>;
using PhotographRow = RowOf<struct PhotographTag>;
using ScanRow = RowOf<struct ScanTag>;
using DecisionRow = RowOf<struct DecisionTag>;
using SherdRow = RowOf<struct SherdTag>;
using FileRow = RowOf<struct FileTag>;

}  // namespace ostraka::store
