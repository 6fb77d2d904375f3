#pragma once
#include <filesystem>

#include "base/result.h"
#include "store/database.h"

namespace ostraka::store {

/// A catalogue from elsewhere, before anything asks its tables: they, their indexes, views and
/// triggers are those that the migrations up to its version make, and no others. SQLite runs what
/// stands in a schema: a view in place of a table, a check or a trigger can delete, or never end.
/// One of a newer version is left to migrate(), which refuses it. Nothing may be using the file.
/// Errors: UnusableInput, which names the part; Damaged where the file cannot be read.
Result<void> checkSchema(const std::filesystem::path& file);
/// The same of one that is open, before it is asked anything else.
Result<void> checkSchema(Database& database);

}  // namespace ostraka::store
