#include "catalogue/files.h"

#include "catalogue/history.h"
#include "catalogue/stamped_rows.h"
#include "records/sherd.h"
#include "records/words.h"
#include "store/database.h"
#include "store/values.h"

namespace ostraka::catalogue {
namespace {

constexpr const char* kFiles =
    "SELECT row, id, path, sha256, media_type, role, bytes, state, sherd, batch FROM file ";
constexpr const char* kColumns = "path sha256 bytes media_type role state sherd batch";

std::vector<records::FileRecord> readFiles(store::Statement rows) {
  std::vector<records::FileRecord> all;
  records::FileRecord f;
  std::string state;
  while (rows.read(f.row, f.id, f.path, f.sha256, f.media_type, f.role, f.bytes, state, f.sherd,
                   f.batch)) {
    f.state = records::fromWord<records::FileState>(state);
    all.push_back(f);
  }
  return all;
}

}  // namespace

Result<store::FileRow> Files::save(const records::FileRecord& f,
                                   const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    const Result<std::string> path = store::checkedPath(f.path);
    if (!path) throw store::Refused(path.error());
    std::int64_t row = f.row.value;
    if (row == 0) {
      store::Statement same = database_->sql("SELECT row FROM file WHERE path = ?", *path);
      same.read(row);
    }
    if (row == 0) {
      return store::FileRow{addRow(catalogue_, provenance, "file", f.id, kColumns, *path, f.sha256,
                                   f.bytes, f.media_type, f.role, records::wordOf(f.state), f.sherd,
                                   f.batch)};
    }
    if (rememberDifferences(catalogue_, provenance, "file", row,
                            {{"path", *path},
                             {"sha256", f.sha256},
                             {"bytes", std::to_string(f.bytes)},
                             {"media_type", f.media_type},
                             {"role", f.role},
                             {"state", records::wordOf(f.state)},
                             {"sherd", rowText(f.sherd.value)},
                             {"batch", rowText(f.batch.value)}}))
      changeRow(catalogue_, provenance, "file", row, kColumns, *path, f.sha256, f.bytes,
                f.media_type, f.role, records::wordOf(f.state), f.sherd, f.batch);
    return store::FileRow{row};
  });
}

Result<std::vector<records::FileRecord>> Files::of(store::SherdRow sherd) const {
  return database_->asResult([&] {
    return readFiles(database_->sql(std::string(kFiles) + "WHERE sherd = ? ORDER BY path", sherd));
  });
}

Result<std::vector<records::FileRecord>> Files::of(store::BatchRow batch) const {
  return database_->asResult([&] {
    return readFiles(database_->sql(std::string(kFiles) + "WHERE batch = ? ORDER BY path", batch));
  });
}

Result<std::vector<records::FileRecord>> Files::all() const {
  return database_->asResult(
      [&] { return readFiles(database_->sql(std::string(kFiles) + "ORDER BY path")); });
}

}  // namespace ostraka::catalogue
