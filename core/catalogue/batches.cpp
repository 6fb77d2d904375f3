// Batches, their photographs and their scans.
#include <algorithm>
#include <cstdlib>

#include "catalogue/catalogue.h"
#include "catalogue/history.h"
#include "records/words.h"
#include "store/database.h"
#include "store/names.h"
#include "store/values.h"

namespace ostraka::catalogue {
namespace {

std::string nextNumber(Database& database) {
  // B0009, B0010, ... B9999, B10000: by value, not by letters.
  std::int64_t last = 0;
  Statement rows = database.sql(
      "SELECT ifnull(max(CAST(substr(number, 2) AS INTEGER)), 0) FROM batch WHERE number GLOB "
      "'B[0-9]*'");
  if (rows.next()) rows >> last;
  std::string digits = std::to_string(last + 1);
  if (digits.size() < 4) digits.insert(0, 4 - digits.size(), '0');
  return "B" + digits;
}

void setBags(Database& database, BatchRow batch, const std::vector<BagRow>& bags) {
  database.sql("DELETE FROM batch_bag WHERE batch = ?").with(batch).run();
  for (std::size_t i = 0; i < bags.size(); ++i)
    database.sql("INSERT OR IGNORE INTO batch_bag VALUES (?, ?, ?)")
        .with(batch, static_cast<std::int64_t>(i), bags[i])
        .run();
}

std::vector<BagRow> bagsOf(Database& database, BatchRow batch) {
  std::vector<BagRow> bags;
  Statement rows = database.sql("SELECT bag FROM batch_bag WHERE batch = ? ORDER BY position");
  rows.with(batch);
  while (rows.next()) {
    BagRow bag;
    rows >> bag;
    bags.push_back(bag);
  }
  return bags;
}

std::string bagsText(const std::vector<BagRow>& bags) {
  std::vector<std::string> words;
  for (const BagRow& bag : bags) words.push_back(std::to_string(bag.value));
  return joinTerms(words);
}

void checkBatch(const BatchRecord& b) {
  if (b.counted < 0 || b.counted > 60)
    refuse("A plate holds 1 to 60 sherds; 0 means not counted.", b.number);
  if (b.number.empty() || slug(b.number) != b.number)
    refuse("The number of a batch is also the name of its folder; use letters and digits.",
           b.number);
}

constexpr const char* kBatches =
    "SELECT row, id, number, operator, counted, state, started_ms, ended_ms, reprojection_px, "
    "scale_error_pct, scale_doubts, rig_sha256, program, settings_sha256, note FROM batch ";

BatchRecord readBatchRow(Database& database, Statement& row) {
  BatchRecord b;
  std::string state;
  row >> b.row >> b.id >> b.number >> b.operator_ >> b.counted >> state >> b.started_ms >>
      b.ended_ms >> b.reprojection_px >> b.scale_error_pct >> b.scale_doubts >> b.rig_sha256 >>
      b.program >> b.settings_sha256 >> b.note;
  b.state = fromWord<BatchState>(state);
  b.bags = bagsOf(database, b.row);
  return b;
}

std::string opt(const std::optional<double>& value) {
  return value ? numberText(*value) : std::string();
}
std::string opt(const std::optional<std::int64_t>& value) {
  return value ? std::to_string(*value) : std::string();
}

}  // namespace

Result<std::string> Catalogue::nextBatchNumber() const {
  return database_->door([&] { return nextNumber(*database_); });
}

Result<BatchRow> Catalogue::addBatch(const BatchRecord& wanted, const Provenance& provenance) {
  return database_->inTransaction([&] {
    BatchRecord b = wanted;
    if (b.number.empty()) b.number = nextNumber(*database_);
    checkBatch(b);
    if (!b.id.empty() && !isUuid(b.id)) refuse("The uuid of a batch is not well formed.", b.id);
    Statement same = database_->sql("SELECT 1 FROM batch WHERE number = ?");
    if (same.with(b.number).next()) refuse("The batch " + b.number + " already exists.");
    database_
        ->sql(
            "INSERT INTO batch (id, created_at, created_by, updated_at, updated_by, number, "
            "operator, counted, state, started_ms, ended_ms, reprojection_px, scale_error_pct, "
            "scale_doubts, rig_sha256, program, settings_sha256, note) VALUES (?, ?, ?, ?, ?, ?, "
            "?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .with(b.id.empty() ? newId(now()) : b.id, now(), provenance.person, now(),
              provenance.person, b.number, b.operator_, b.counted, wordOf(b.state), b.started_ms,
              b.ended_ms, b.reprojection_px, b.scale_error_pct, b.scale_doubts, b.rig_sha256,
              b.program, b.settings_sha256, b.note)
        .run();
    const BatchRow row{database_->lastRow()};
    setBags(*database_, row, b.bags);
    remember(*this, provenance, "batch", row.value, "", "", b.number);
    return row;
  });
}

Result<void> Catalogue::saveBatch(const BatchRecord& b, const Provenance& provenance) {
  return database_->inTransaction([&] {
    checkBatch(b);
    const std::string old_bags = bagsText(bagsOf(*database_, b.row));
    bool changed =
        rememberDifferences(*this, provenance, "batch", b.row.value,
                            {{"operator", b.operator_ ? std::to_string(b.operator_.value) : ""},
                             {"counted", std::to_string(b.counted)},
                             {"state", wordOf(b.state)},
                             {"started_ms", opt(b.started_ms)},
                             {"ended_ms", opt(b.ended_ms)},
                             {"reprojection_px", opt(b.reprojection_px)},
                             {"scale_error_pct", opt(b.scale_error_pct)},
                             {"scale_doubts", b.scale_doubts},
                             {"rig_sha256", b.rig_sha256},
                             {"program", b.program},
                             {"settings_sha256", b.settings_sha256},
                             {"note", b.note}});
    if (old_bags != bagsText(b.bags)) {
      remember(*this, provenance, "batch", b.row.value, "bags", old_bags, bagsText(b.bags));
      setBags(*database_, b.row, b.bags);
      changed = true;
    }
    if (!changed) return;
    database_
        ->sql(
            "UPDATE batch SET operator = ?, counted = ?, state = ?, started_ms = ?, ended_ms = "
            "?, reprojection_px = ?, scale_error_pct = ?, scale_doubts = ?, rig_sha256 = ?, "
            "program = ?, "
            "settings_sha256 = ?, note = ?, updated_at = ?, updated_by = ?, revision = revision "
            "+ 1 WHERE row = ?")
        .with(b.operator_, b.counted, wordOf(b.state), b.started_ms, b.ended_ms, b.reprojection_px,
              b.scale_error_pct, b.scale_doubts, b.rig_sha256, b.program, b.settings_sha256, b.note,
              now(), provenance.person, b.row)
        .run();
  });
}

Result<void> Catalogue::setBatchState(BatchRow row, BatchState state,
                                      const Provenance& provenance) {
  return database_->inTransaction([&] {
    if (!rememberDifferences(*this, provenance, "batch", row.value, {{"state", wordOf(state)}}))
      return;
    database_
        ->sql(
            "UPDATE batch SET state = ?, updated_at = ?, updated_by = ?, revision = revision + 1 "
            "WHERE row = ?")
        .with(wordOf(state), now(), provenance.person, row)
        .run();
  });
}

Result<std::vector<BatchRecord>> Catalogue::batches() const {
  return database_->door([&] {
    std::vector<BatchRecord> all;
    Statement rows = database_->sql(std::string(kBatches) + "ORDER BY row DESC");
    while (rows.next()) all.push_back(readBatchRow(*database_, rows));
    return all;
  });
}

Result<BatchRecord> Catalogue::batch(BatchRow row) const {
  return database_->door([&] {
    Statement rows = database_->sql(std::string(kBatches) + "WHERE row = ?");
    if (!rows.with(row).next()) refuse("This batch is not in the catalogue.");
    return readBatchRow(*database_, rows);
  });
}

Result<BatchRecord> Catalogue::batchByNumber(const std::string& number) const {
  return database_->door([&] {
    Statement rows = database_->sql(std::string(kBatches) + "WHERE number = ?");
    if (!rows.with(number).next()) refuse("This batch is not in the catalogue.", number);
    return readBatchRow(*database_, rows);
  });
}

Result<std::optional<BatchRecord>> Catalogue::batchById(const std::string& id) const {
  return database_->door([&]() -> std::optional<BatchRecord> {
    Statement rows = database_->sql(std::string(kBatches) + "WHERE id = ?");
    if (!rows.with(id).next()) return std::nullopt;
    return readBatchRow(*database_, rows);
  });
}

Result<PhotographRow> Catalogue::save(const PhotographRecord& p, const Provenance& provenance) {
  return database_->inTransaction([&] {
    const Result<std::string> path = checkedPath(p.path);
    if (!path) throw Refused(path.error());
    const std::string camera(1, p.camera), exif = p.exif_json.empty() ? "{}" : p.exif_json;
    std::int64_t row = p.row.value;
    if (row == 0) {
      Statement same = database_->sql(
          "SELECT row FROM photograph WHERE batch = ? AND side = ? AND camera = ? AND stop = ? AND "
          "take = ?");
      same.with(p.batch, wordOf(p.side), camera, p.stop, p.take);
      if (same.next()) same >> row;
    }
    if (row == 0) {
      database_
          ->sql(
              "INSERT INTO photograph (id, created_at, created_by, updated_at, updated_by, "
              "batch, side, camera, stop, take, path, serial, exif, angle_deg, sharpness, used, "
              "reason) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
          .with(newId(now()), now(), provenance.person, now(), provenance.person, p.batch,
                wordOf(p.side), camera, p.stop, p.take, *path, p.serial, exif, p.angle_deg,
                p.sharpness, p.used, p.reason)
          .run();
      return PhotographRow{database_->lastRow()};
    }
    if (rememberDifferences(*this, provenance, "photograph", row,
                            {{"path", *path},
                             {"serial", p.serial},
                             {"exif", exif},
                             {"angle_deg", opt(p.angle_deg)},
                             {"sharpness", opt(p.sharpness)},
                             {"used", p.used ? "1" : "0"},
                             {"reason", p.reason}}))
      database_
          ->sql(
              "UPDATE photograph SET path = ?, serial = ?, exif = ?, angle_deg = ?, sharpness = "
              "?, used = ?, reason = ?, updated_at = ?, updated_by = ?, revision = revision + 1 "
              "WHERE row = ?")
          .with(*path, p.serial, exif, p.angle_deg, p.sharpness, p.used, p.reason, now(),
                provenance.person, row)
          .run();
    return PhotographRow{row};
  });
}

Result<std::vector<PhotographRecord>> Catalogue::photographs(BatchRow batch) const {
  return database_->door([&] {
    std::vector<PhotographRecord> all;
    Statement rows = database_->sql(
        "SELECT row, batch, side, camera, stop, take, path, serial, exif, angle_deg, sharpness, "
        "used, reason FROM photograph WHERE batch = ? ORDER BY side DESC, camera, stop, take");
    rows.with(batch);
    while (rows.next()) {
      PhotographRecord p;
      std::string side, camera;
      rows >> p.row >> p.batch >> side >> camera >> p.stop >> p.take >> p.path >> p.serial >>
          p.exif_json >> p.angle_deg >> p.sharpness >> p.used >> p.reason;
      p.side = fromWord<batch::Side>(side);
      p.camera = camera.empty() ? 'A' : camera[0];
      all.push_back(std::move(p));
    }
    return all;
  });
}

Result<ScanRow> Catalogue::save(const ScanRecord& s, const Provenance& provenance) {
  return database_->inTransaction([&] {
    const Result<std::string> path = checkedPath(s.path);
    if (!path) throw Refused(path.error());
    std::int64_t row = s.row.value;
    if (row == 0) {
      Statement same =
          database_->sql("SELECT row FROM scan WHERE batch = ? AND side = ? AND position = ?");
      same.with(s.batch, wordOf(s.side), s.index);
      if (same.next()) same >> row;
    }
    const std::string points = s.points ? std::to_string(*s.points) : std::string();
    if (row == 0) {
      database_
          ->sql(
              "INSERT INTO scan (id, created_at, created_by, updated_at, updated_by, batch, "
              "side, position, name, path, points, coverage_pct, plate_x_mm, plate_y_mm) VALUES "
              "(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
          .with(newId(now()), now(), provenance.person, now(), provenance.person, s.batch,
                wordOf(s.side), s.index, s.name, *path, s.points, s.coverage_pct, s.plate_x_mm,
                s.plate_y_mm)
          .run();
      return ScanRow{database_->lastRow()};
    }
    if (rememberDifferences(*this, provenance, "scan", row,
                            {{"name", s.name},
                             {"path", *path},
                             {"points", points},
                             {"coverage_pct", opt(s.coverage_pct)},
                             {"plate_x_mm", opt(s.plate_x_mm)},
                             {"plate_y_mm", opt(s.plate_y_mm)}}))
      database_
          ->sql(
              "UPDATE scan SET position = ?, name = ?, path = ?, points = ?, coverage_pct = ?, "
              "plate_x_mm = ?, plate_y_mm = ?, updated_at = ?, updated_by = ?, revision = revision "
              "+ 1 WHERE row = ?")
          .with(s.index, s.name, *path, s.points, s.coverage_pct, s.plate_x_mm, s.plate_y_mm, now(),
                provenance.person, row)
          .run();
    return ScanRow{row};
  });
}

Result<std::vector<ScanRecord>> Catalogue::scans(BatchRow batch) const {
  return database_->door([&] {
    std::vector<ScanRecord> all;
    Statement rows = database_->sql(
        "SELECT row, batch, side, position, name, path, points, coverage_pct, plate_x_mm, "
        "plate_y_mm, state FROM scan WHERE batch = ? ORDER BY side DESC, position");
    rows.with(batch);
    while (rows.next()) {
      ScanRecord s;
      std::string side, state;
      rows >> s.row >> s.batch >> side >> s.index >> s.name >> s.path >> s.points >>
          s.coverage_pct >> s.plate_x_mm >> s.plate_y_mm >> state;
      s.side = fromWord<batch::Side>(side);
      s.state = fromWord<ScanState>(state);
      all.push_back(std::move(s));
    }
    return all;
  });
}

}  // namespace ostraka::catalogue
