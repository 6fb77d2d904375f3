#include "catalogue/catalogue.h"

#include "base/message.h"
#include "store/database.h"
#include "store/file_header.h"
#include "store/migrations.h"
#include "store/partial_file.h"

namespace ostraka::catalogue {
namespace {

namespace fs = std::filesystem;

std::string firstText(store::Database& database, const char* sql) {
  return database.sql(sql).one<std::string>();
}

int historyRows(store::Database& database) {
  return std::stoi(firstText(database, "SELECT count(*) FROM history"));
}

}  // namespace

Catalogue::Catalogue(std::unique_ptr<store::Database> database, Clock clock)
    : database_(std::move(database)), clock_(std::move(clock)) {}
Catalogue::Catalogue(Catalogue&&) noexcept = default;
Catalogue& Catalogue::operator=(Catalogue&&) noexcept = default;
Catalogue::~Catalogue() = default;

Result<void> Catalogue::checkIntegrity() const {
  const Result<Message> found = database_->asResult([&]() -> Message {
    const std::string check = firstText(*database_, "PRAGMA integrity_check(1)");
    if (check != "ok") return check;
    const std::string foreign = firstText(*database_, "PRAGMA foreign_key_check");
    if (!foreign.empty()) return message("a row of %1 refers to a missing row", foreign);
    if (firstText(*database_, "SELECT id FROM project").empty())
      return message("it contains no project");
    if (firstText(*database_,
                  "SELECT count(*) FROM sherd WHERE row NOT IN (SELECT sherd FROM sherd_measure) "
                  "OR (number <> '' AND row NOT IN (SELECT sherd FROM given_number))") != "0")
      return message("the sherd tables are inconsistent");
    if (firstText(*database_,
                  "SELECT count(*) FROM sherd WHERE row NOT IN (SELECT id FROM "
                  "sherd_text_content)") != "0")
      return message("the search index is incomplete");
    return {};
  });
  if (!found) return found.error();
  if (!found->empty()) return store::damagedCatalogue(*found, database_->file());
  // FTS5 compares its index with its texts in the form of an insertion.
  if (readOnly()) return {};
  return database_->asResult([&] {
    database_->run("INSERT INTO sherd_text(sherd_text, rank) VALUES('integrity-check', 0)");
  });
}

Result<void> Catalogue::backup(const fs::path& file) const {
  Result<store::PartialFile> copy = store::PartialFile::beside(file);
  if (!copy) return copy.error();
  const Result<int> written = database_->asResult([&] {
    const int rows = historyRows(*database_);
    database_->copyTo(copy->path());
    return rows;
  });
  if (!written) return written.error();
  {
    Result<std::unique_ptr<store::Database>> opened =
        store::Database::open(copy->path(), store::Database::Mode::ReadOnly);
    if (!opened) return opened.error();
    const Catalogue read_back(std::move(*opened), clock_);
    if (const Result<void> good = read_back.checkIntegrity(); !good) return good;
    const Result<int> found =
        read_back.database().asResult([&] { return historyRows(read_back.database()); });
    if (!found) return found.error();
    if (*found < *written)  // others may have written meanwhile, so more is all right
      return Error{ErrorCode::CannotWrite,
                   message("The backup does not contain the saved data; try again."),
                   file.string()};
  }
  return copy->become(file, store::PartialFile::Existing::Replaced);
}

bool Catalogue::readOnly() const {
  return database_->readOnly();
}

Result<std::int64_t> Catalogue::writesOfOthers() const {
  return database_->asResult(
      [&] { return database_->sql("PRAGMA data_version").one<std::int64_t>(); });
}

int Catalogue::schemaVersion() const {
  return store::schemaVersion(*database_);
}

Result<void> Catalogue::together(const std::function<Result<void>()>& work) {
  return database_->inTransaction([&] {
    if (const Result<void> done = work(); !done) throw store::Refused(done.error());
  });
}

Result<void> Catalogue::inSnapshot(const std::function<Result<void>()>& work) const {
  return database_->inSnapshot([&] {
    if (const Result<void> done = work(); !done) throw store::Refused(done.error());
  });
}

}  // namespace ostraka::catalogue
