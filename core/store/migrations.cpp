#include "store/migrations.h"

#include <string>

#include "base/message.h"

namespace ostraka::store {

int schemaVersion(Database& database) {
  int version = 0;
  Statement statement = database.sql("PRAGMA user_version");
  statement.read(version);
  return version;
}

Result<void> migrate(Database& database, std::span<const Migration> steps,
                     const std::function<Result<void>()>& backup) {
  const Result<int> found = database.asResult([&] { return schemaVersion(database); });
  if (!found) return found.error();
  const int newest = steps.empty() ? 0 : steps.back().number;
  if (*found > newest)
    return Error::unusable(
        message("A newer Ostraka made this project (catalogue version %1, this program supports "
                "%2). Nothing was changed. Install the newer version.",
                *found, newest),
        database.file().string());
  if (*found == newest) return {};
  if (*found > 0)
    if (Result<void> saved = backup(); !saved) return saved;
  for (const Migration& step : steps) {
    const Result<void> done = database.inTransaction([&] {
      // Another program may have been faster.
      if (schemaVersion(database) >= step.number) return;
      database.script(std::string(step.sql));
      database.script("PRAGMA user_version = " + std::to_string(step.number));
    });
    if (!done) return done;
  }
  return {};
}

}  // namespace ostraka::store
