#pragma once
#include <functional>
#include <span>
#include <string_view>

#include "base/result.h"
#include "store/database.h"

namespace ostraka::store {

/// One step of the schema: resources/migrations/0002_what_it_does.sql, compiled in.
struct Migration {
  int number = 0;
  std::string_view name, sql;
};
/// In their order, without gaps.
std::span<const Migration> migrations();

int schemaVersion(Database& database);
/// Brings the schema up to the last of `steps`, each in one transaction, after `backup` (not called
/// for a new catalogue). A newer schema is refused. Errors leave the schema at the last whole step.
Result<void> migrate(Database& database, std::span<const Migration> steps,
                     const std::function<Result<void>()>& backup);

}  // namespace ostraka::store
