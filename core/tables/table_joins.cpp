#include "tables/table_joins.h"

#include <algorithm>

#include "base/message.h"
#include "records/sherd.h"
#include "sherds/sherds.h"
#include "store/names.h"
#include "store/values.h"

namespace ostraka::tables {
namespace {

using catalogue::Catalogue;
using records::SherdRecord;
using store::SherdRow;

Result<SherdRow> byName(const std::string& name, const Catalogue& catalogue) {
  const Result<SherdRow> sherd = sherds::Sherds(catalogue).byNumber(name);
  return !sherd || *sherd ? sherd : sherds::Sherds(catalogue).byId(name);
}

}  // namespace

TableJoins::TableJoins(const std::vector<ImportRow>& rows) {
  rows_.reserve(rows.size());
  for (const ImportRow& row : rows) {
    Row& kept = rows_.emplace_back();
    const auto valueOf = [&row](const char* name) {
      const auto found = row.values.find(name);
      return found == row.values.end() || found->second == kClear ? std::string() : found->second;
    };
    kept.number = valueOf("number");
    kept.uuid = valueOf("uuid");
    for (const std::string& name : {kept.number, kept.uuid})
      if (!name.empty()) by_name_.emplace(store::uniqueKey(name), rows_.size() - 1);
    const auto joins = row.values.find("joins");
    if (joins != row.values.end() && !joins->second.empty())
      kept.named = store::splitTerms(valueOf("joins"));
  }
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (rows_[i].named)
      for (const std::string& name : *rows_[i].named)
        if (const auto other = rowOf(name); other && *other != i)
          rows_[*other].named_by.push_back(i);
}

std::optional<std::size_t> TableJoins::rowOf(const std::string& name) const {
  const auto found = by_name_.find(store::uniqueKey(name));
  return found == by_name_.end() ? std::nullopt : std::optional(found->second);
}

Result<SherdRow> TableJoins::sherdOf(std::size_t i, const Catalogue& catalogue) const {
  const Row& row = rows_[i];
  if (row.sherd) return row.sherd;
  const Result<SherdRow> sherd =
      row.uuid.empty() ? SherdRow() : sherds::Sherds(catalogue).byId(row.uuid);
  return !sherd || *sherd || row.number.empty() ? sherd
                                                : sherds::Sherds(catalogue).byNumber(row.number);
}

Result<std::optional<std::vector<SherdRow>>> TableJoins::of(std::size_t i, const SherdRecord& now,
                                                            const Catalogue& catalogue) const {
  const Row& row = rows_[i];
  if (!row.named && row.named_by.empty()) return std::optional<std::vector<SherdRow>>();
  std::vector<SherdRow> joins;
  if (!row.named) joins = now.joins;
  for (const std::string& name : row.named.value_or(std::vector<std::string>())) {
    const std::optional<std::size_t> other = rowOf(name);
    const Result<SherdRow> partner = other ? sherdOf(*other, catalogue) : byName(name, catalogue);
    if (!partner) return partner.error();
    if (other == i || *partner == now.row)
      return Error::unusable(message("A sherd cannot join itself."));
    if (*partner)
      joins.push_back(*partner);
    else if (!other)
      return Error::unusable(message("There is no sherd %1 to join.", name));
  }
  for (const std::size_t other : row.named_by) {
    const Result<SherdRow> partner = sherdOf(other, catalogue);
    if (!partner) return partner.error();
    const bool joined = std::find(now.joins.begin(), now.joins.end(), *partner) != now.joins.end();
    // A row that comes later says it itself, unless it is refused.
    if (rows_[other].sherd || joined) joins.push_back(*partner);
  }
  std::sort(joins.begin(), joins.end());
  joins.erase(std::unique(joins.begin(), joins.end()), joins.end());
  return std::optional(joins);
}

Result<std::vector<std::string>> TableJoins::lost(const Catalogue& catalogue) const {
  std::vector<std::string> lost;
  for (const Row& row : rows_) {
    if (!row.sherd || !row.named) continue;
    for (const std::string& name : *row.named)
      if (const auto other = rowOf(name)) {
        const Result<SherdRow> partner = sherdOf(*other, catalogue);
        if (!partner) return partner.error();
        if (!*partner) lost.push_back((row.number.empty() ? row.uuid : row.number) + " – " + name);
      }
  }
  return lost;
}

}  // namespace ostraka::tables
