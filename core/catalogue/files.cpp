#include "catalogue/files.h"

#include "catalogue/file_places.h"
#include "catalogue/history.h"
#include "catalogue/stamped_rows.h"
#include "records/sherd.h"
#include "records/words.h"
#include "store/database.h"

namespace ostraka::catalogue {
namespace {

constexpr const char* kFiles =
    "SELECT row, id, path, sha256, media_type, role, bytes, state, sherd, batch FROM file ";

std::vector<records::FileRecord> readFiles(store::Statement rows) {
  using F = records::FileRecord;
  return rows.all(&F::row, &F::id, &F::path, &F::sha256, &F::media_type, &F::role, &F::bytes,
                  &F::state, &F::sherd, &F::batch);
}

}  // namespace

Result<store::FileRow> Files::save(const records::FileRecord& f,
                                   const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    const std::string path = store::valueOrThrow(recordedPath(f.path));
    const std::int64_t row =
        f.row ? f.row.value
              : database_->sql("SELECT row FROM file WHERE path = ?", path).one<std::int64_t>();
    return store::FileRow{saveRow(catalogue_, provenance, "file", row, f.id,
                                  {{"path", path},
                                   {"sha256", f.sha256},
                                   {"bytes", f.bytes},
                                   {"media_type", f.media_type},
                                   {"role", f.role},
                                   {"state", records::wordOf(f.state)},
                                   {"sherd", f.sherd},
                                   {"batch", f.batch}})};
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
