#include "catalogue/batches.h"

#include <charconv>
#include <filesystem>
#include <set>

#include "base/message.h"
#include "base/uuid.h"
#include "catalogue/file_places.h"
#include "catalogue/history.h"
#include "catalogue/stamped_rows.h"
#include "files/json_message.h"
#include "records/words.h"
#include "store/database.h"
#include "store/values.h"

namespace ostraka::catalogue {
namespace {

// After B, as far as there are digits; nothing of more than a batch can have.
std::optional<std::int64_t> countedBatch(std::string_view number) {
  std::int64_t value = 0;
  const char* begin = number.data() + 1;
  const char* end = std::from_chars(begin, number.data() + number.size(), value).ptr;
  const auto digits = static_cast<std::size_t>(end - begin);
  if (digits == 0 || digits > store::kBatchDigits) return std::nullopt;
  return value;
}

std::string batchNumber(std::int64_t number) {
  std::string digits = std::to_string(number);
  if (digits.size() < 4) digits.insert(0, 4 - digits.size(), '0');
  return "B" + digits;
}

// What somebody put there belongs to no batch, and must not become part of one.
bool hasFolderOfBatch(const store::Database& database, const std::string& number) {
  const std::filesystem::path project = database.file().parent_path();
  for (const char* all : {"batches", "results", "models"}) {
    std::error_code failed;
    if (std::filesystem::exists(std::filesystem::symlink_status(project / all / number, failed)))
      return true;
  }
  return false;
}

// B0009, B0010, ... B9999, B10000: by value, not by letters.
std::set<std::int64_t> givenNumbers(store::Database& database) {
  std::set<std::int64_t> given;
  store::Statement rows = database.sql("SELECT number FROM batch WHERE number GLOB 'B[0-9]*'");
  for (std::string number; rows.read(number);)
    if (const auto value = countedBatch(number)) given.insert(*value);
  return given;
}

std::string nextNumber(store::Database& database) {
  const std::set<std::int64_t> given = givenNumbers(database);
  const auto taken = [&](std::int64_t number) {
    return given.contains(number) || hasFolderOfBatch(database, batchNumber(number));
  };
  std::int64_t next = given.empty() ? 1 : *given.rbegin() + 1;
  while (taken(next)) ++next;
  // Somebody gave the last that there is: the first that is free.
  if (std::to_string(next).size() > store::kBatchDigits)
    for (next = 1; taken(next);) ++next;
  return batchNumber(next);
}

void setBags(store::Database& database, store::BatchRow batch,
             const std::vector<store::BagRow>& bags) {
  database.run("DELETE FROM batch_bag WHERE batch = ?", batch);
  for (std::size_t i = 0; i < bags.size(); ++i)
    database.run("INSERT OR IGNORE INTO batch_bag VALUES (?, ?, ?)", batch,
                 static_cast<std::int64_t>(i), bags[i]);
}

std::vector<store::BagRow> bagsOf(store::Database& database, store::BatchRow batch) {
  return database.sql("SELECT bag FROM batch_bag WHERE batch = ? ORDER BY position", batch)
      .all<store::BagRow>();
}

std::string bagsText(const std::vector<store::BagRow>& bags) {
  std::vector<std::string> words;
  for (const store::BagRow& bag : bags) words.push_back(std::to_string(bag.value));
  return store::joinTerms(words);
}

void checkBatch(const records::BatchRecord& b) {
  if (b.counted < 0 || b.counted > 60)
    store::refuse(message("A plate holds 1 to 60 sherds; 0 means not counted."), b.number);
}

// Of what a record may change.
std::vector<Column> columnsOf(const records::BatchRecord& b) {
  return {{"operator", b.operator_},
          {"counted", b.counted},
          {"state", records::wordOf(b.state)},
          {"started_ms", b.started_ms},
          {"ended_ms", b.ended_ms},
          {"reprojection_px", b.reprojection_px},
          {"scale_error_pct", b.scale_error_pct},
          {"scale", b.scale.empty() ? std::string() : textOf({b.scale})},
          {"scale_doubts", textOf(b.scale_doubts)},
          {"rig_sha256", b.rig_sha256},
          {"program", b.program},
          {"settings_sha256", b.settings_sha256},
          {"note", b.note}};
}

constexpr const char* kBatches =
    "SELECT row, id, number, operator, counted, state, started_ms, ended_ms, reprojection_px, "
    "scale_error_pct, scale, scale_doubts, rig_sha256, program, settings_sha256, note FROM batch ";

records::BatchRecord readBatchRow(store::Database& database, store::Statement& row) {
  records::BatchRecord b;
  std::string scale, doubts;
  row >> b.row >> b.id >> b.number >> b.operator_ >> b.counted >> b.state >> b.started_ms >>
      b.ended_ms >> b.reprojection_px >> b.scale_error_pct >> scale >> doubts >> b.rig_sha256 >>
      b.program >> b.settings_sha256 >> b.note;
  for (Message& source : messagesFromText(scale, b.number)) b.scale = std::move(source);
  b.scale_doubts = messagesFromText(doubts, b.number);
  b.bags = bagsOf(database, b.row);
  return b;
}

}  // namespace

Result<std::string> Batches::nextNumber() const {
  return database_->asResult([&] { return catalogue::nextNumber(*database_); });
}

Result<std::string> Batches::lowestFreeNumber() const {
  return database_->asResult([&] {
    const std::set<std::int64_t> given = givenNumbers(*database_);
    std::int64_t lowest = 1;
    while (given.contains(lowest)) ++lowest;
    return batchNumber(lowest);
  });
}

Result<store::BatchRow> Batches::add(const records::BatchRecord& wanted,
                                     const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    records::BatchRecord b = wanted;
    if (b.number.empty()) b.number = catalogue::nextNumber(*database_);
    checkBatch(b);
    store::valueOrThrow(store::checkedBatchNumber(b.number));
    if (!b.id.empty() && !isUuid(b.id))
      store::refuse(message("The uuid of a batch is not well formed."), b.id);
    store::Statement same = database_->sql("SELECT 1 FROM batch WHERE number = ?", b.number);
    if (same.next()) store::refuse(message("The batch %1 already exists.", b.number));
    std::vector<Column> columns = columnsOf(b);
    const Column number{"number", b.number};
    columns.push_back(number);
    const store::BatchRow row{saveRow(catalogue_, provenance, "batch", 0, b.id, columns)};
    setBags(*database_, row, b.bags);
    remember(catalogue_, provenance, "batch", row.value, "", "", b.number);
    remember(catalogue_, provenance, "batch", row.value, "bags", "", bagsText(b.bags));
    return row;
  });
}

Result<void> Batches::save(const records::BatchRecord& b, const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    checkBatch(b);
    const std::string old_bags = bagsText(bagsOf(*database_, b.row));
    bool changed = rememberDifferences(catalogue_, provenance, "batch", b.row.value, columnsOf(b));
    if (old_bags != bagsText(b.bags)) {
      remember(catalogue_, provenance, "batch", b.row.value, "bags", old_bags, bagsText(b.bags));
      setBags(*database_, b.row, b.bags);
      changed = true;
    }
    if (!changed) return;
    changeRow(catalogue_, provenance, "batch", b.row.value, columnsOf(b));
  });
}

Result<void> Batches::setState(store::BatchRow row, records::BatchState state,
                               const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    const std::vector<Column> columns = {{"state", records::wordOf(state)}};
    if (rememberDifferences(catalogue_, provenance, "batch", row.value, columns))
      changeRow(catalogue_, provenance, "batch", row.value, columns);
  });
}

Result<std::vector<records::BatchRecord>> Batches::all() const {
  return database_->asResult([&] {
    std::vector<records::BatchRecord> all;
    store::Statement rows = database_->sql(std::string(kBatches) + "ORDER BY row DESC");
    while (rows.next()) all.push_back(readBatchRow(*database_, rows));
    return all;
  });
}

Result<records::BatchRecord> Batches::get(store::BatchRow row) const {
  return database_->asResult([&] {
    store::Statement rows = database_->sql(std::string(kBatches) + "WHERE row = ?", row);
    if (!rows.next()) store::refuse(message("This batch is not in the catalogue."));
    return readBatchRow(*database_, rows);
  });
}

Result<records::BatchRecord> Batches::byNumber(const std::string& number) const {
  return database_->asResult([&] {
    store::Statement rows = database_->sql(std::string(kBatches) + "WHERE number = ?", number);
    if (!rows.next()) store::refuse(message("This batch is not in the catalogue."), number);
    return readBatchRow(*database_, rows);
  });
}

Result<std::optional<records::BatchRecord>> Batches::byId(const std::string& id) const {
  return database_->asResult([&]() -> std::optional<records::BatchRecord> {
    store::Statement rows = database_->sql(std::string(kBatches) + "WHERE id = ?", id);
    if (!rows.next()) return std::nullopt;
    return readBatchRow(*database_, rows);
  });
}

Result<store::PhotographRow> Batches::save(const records::PhotographRecord& p,
                                           const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    const std::string path = store::valueOrThrow(recordedPath(p.path));
    const std::string camera(1, p.camera), exif = p.exif_json.empty() ? "{}" : p.exif_json;
    const std::int64_t row =
        p.row ? p.row.value
              : database_
                    ->sql(
                        "SELECT row FROM photograph WHERE batch = ? AND side = ? AND camera = ? "
                        "AND stop = ? AND take = ?",
                        p.batch, records::wordOf(p.side), camera, p.stop, p.take)
                    .one<std::int64_t>();
    constexpr auto kKey = Column::Changes::Never;
    return store::PhotographRow{saveRow(catalogue_, provenance, "photograph", row, p.id,
                                        {{"batch", p.batch, kKey},
                                         {"side", records::wordOf(p.side), kKey},
                                         {"camera", camera, kKey},
                                         {"stop", p.stop, kKey},
                                         {"take", p.take, kKey},
                                         {"path", path},
                                         {"serial", p.serial},
                                         {"exif", exif},
                                         {"angle_deg", p.angle_deg},
                                         {"sharpness", p.sharpness},
                                         {"used", p.used},
                                         {"reason", p.reason}})};
  });
}

Result<std::vector<records::PhotographRecord>> Batches::photographs(store::BatchRow batch) const {
  return database_->asResult([&] {
    using P = records::PhotographRecord;
    return database_
        ->sql(
            "SELECT row, id, batch, side, camera, stop, take, path, serial, exif, angle_deg, "
            "sharpness, used, reason FROM photograph WHERE batch = ? ORDER BY side DESC, camera, "
            "stop, take",
            batch)
        .all(&P::row, &P::id, &P::batch, &P::side, &P::camera, &P::stop, &P::take, &P::path,
             &P::serial, &P::exif_json, &P::angle_deg, &P::sharpness, &P::used, &P::reason);
  });
}

Result<bool> Batches::isInvented(store::BatchRow batch) const {
  return firstOf<bool>("SELECT EXISTS (SELECT 1 FROM photograph WHERE batch = ? AND serial GLOB ?)",
                       batch, std::string(batch::kVirtualSerial) + "*");
}

Result<store::ScanRow> Batches::save(const records::ScanRecord& s,
                                     const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    const std::string path = store::valueOrThrow(recordedPath(s.path));
    const std::int64_t row =
        s.row ? s.row.value
              : database_
                    ->sql("SELECT row FROM scan WHERE batch = ? AND side = ? AND position = ?",
                          s.batch, records::wordOf(s.side), s.index)
                    .one<std::int64_t>();
    return store::ScanRow{saveRow(catalogue_, provenance, "scan", row, s.id,
                                  {{"batch", s.batch, Column::Changes::Never},
                                   {"side", records::wordOf(s.side), Column::Changes::Never},
                                   {"position", s.index, Column::Changes::Untold},
                                   {"name", s.name},
                                   {"path", path},
                                   {"points", s.points},
                                   {"coverage_pct", s.coverage_pct},
                                   {"plate_x_mm", s.plate_x_mm},
                                   {"plate_y_mm", s.plate_y_mm}})};
  });
}

Result<std::vector<records::ScanRecord>> Batches::scans(store::BatchRow batch) const {
  return database_->asResult([&] {
    using S = records::ScanRecord;
    return database_
        ->sql(
            "SELECT row, id, batch, side, position, name, path, points, coverage_pct, plate_x_mm, "
            "plate_y_mm, state FROM scan WHERE batch = ? ORDER BY side DESC, position",
            batch)
        .all(&S::row, &S::id, &S::batch, &S::side, &S::index, &S::name, &S::path, &S::points,
             &S::coverage_pct, &S::plate_x_mm, &S::plate_y_mm, &S::state);
  });
}

}  // namespace ostraka::catalogue
