#include "ui/tables/import_model.h"

#include <QFileInfo>
#include <QTemporaryDir>
#include <algorithm>
#include <map>
#include <memory>

#include "base/limits.h"
#include "base/message.h"
#include "exchange/read_back.h"
#include "files/files.h"
#include "files/output_place.h"
#include "records/records.h"
#include "sherds/sherd_fields.h"
#include "tables/csv.h"
#include "tables/refused_rows.h"
#include "ui/frame/project_session.h"
#include "ui/jobs/when_done.h"
#include "ui/sherds/field_words.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRows = 1000;
constexpr std::size_t kLargest = limits::kTableBytes.most;

using Bytes = std::shared_ptr<const std::string>;

struct Task {
  fs::path source;
  Bytes bytes;  // of a table; none for an export folder
  tables::ImportOptions options;
  records::Provenance provenance;
};

Result<tables::ImportReport> run(upkeep::Project& project, const Task& task, Progress& progress,
                                 std::stop_token stop) {
  if (!task.bytes)
    // Who goes on after the preview has read its warnings.
    return exchange::readBack(project, task.source, task.options.mode, task.provenance, progress,
                              stop, exchange::SamePhotographs::KeepBoth);
  if (task.options.mode == tables::ImportMode::Enter)
    if (const auto saved = project.backUp(); !saved) return saved.error();
  return tables::importTable(project.catalogue(), *task.bytes, task.source.string(), task.options,
                             task.provenance, progress, stop);
}

Result<Bytes> tableBytes(const fs::path& source) {
  if (fs::is_directory(source)) return Bytes();
  Result<std::string> bytes = readFile(source, kLargest);
  if (!bytes) return bytes.error();
  return std::make_shared<const std::string>(std::move(*bytes));
}

// On a copy: a preview does everything and takes it back, and nobody should wait meanwhile.
Result<tables::ImportReport> runOnCopy(const fs::path& folder, const Task& task, Progress& progress,
                                       std::stop_token stop) {
  const QTemporaryDir copy;
  if (!copy.isValid())
    return Error{ErrorCode::CannotWrite, "There is no room for a copy of the catalogue.",
                 copy.path().toStdString()};
  const fs::path there = copy.path().toStdString();
  {
    const Result<catalogue::Catalogue> original = upkeep::Project::connect(folder);
    if (!original) return original.error();
    if (const auto copied = original->backup(there / "catalogue.sqlite"); !copied)
      return copied.error();
  }
  Result<upkeep::Project> project = upkeep::Project::open(there);
  if (!project) return project.error();
  return run(*project, task, progress, stop);
}

QString text(const std::string& value) {
  return QString::fromStdString(value);
}

}  // namespace

struct ImportModel::Look {
  Bytes bytes;
  tables::ImportReport report;
  QStringList columns;
  std::vector<Row> rows;
};

void ImportModel::openProject(ProjectSession* session) {
  // What is being entered goes on: its report and its undo would be lost.
  if (state_ == State::Entering && session == session_) return emit changed();
  delete job_.data();
  session_ = session;
  state_ = State::Choosing;
  source_.clear();
  bytes_.reset();
  problem_.clear();
  columns_.clear();
  rows_.clear();
  report_.reset();
  emit changed();
}

void ImportModel::setSource(const QString& path) {
  if (state_ == State::Entering) return;
  source_ = path;
  bytes_.reset();
  chosen_.clear();
  confirmed_.clear();
  look();
}

void ImportModel::setMakesPlaces(bool make) {
  if (make == make_places_ || state_ == State::Entering) return;
  make_places_ = make;
  if (!source_.isEmpty()) look();
}

void ImportModel::setColumn(int column, const QString& field, const QString& unit) {
  if (state_ != State::Ready || !report_) return;
  chosen_ = report_->mapping.columns;  // what is seen is what holds
  tables::ColumnChoice& choice = chosen_[static_cast<std::size_t>(column)];
  choice.field = field.toStdString();
  choice.unit = unit.toStdString();
  choice.unit_guessed = choice.unit_idle = false;  // now a person says it
  choice.by = tables::ChosenBy::Person;
  for (tables::ColumnChoice& other : chosen_)  // the field is this column's now
    if (&other != &choice && !choice.field.empty() && other.field == choice.field) {
      other.field = "extra." + other.column;
      other.unit.clear();
      other.by = tables::ChosenBy::Person;
    }
  // A unit that was guessed for others is guessed again.
  for (tables::ColumnChoice& other : chosen_)
    if (&other != &choice && other.unit_guessed) other.unit.clear();
  // Of a table that was taken for none the others are proposed anew: it may be another kind now.
  if (!report_->mapping.missing.empty())
    std::erase_if(chosen_, [](const tables::ColumnChoice& other) {
      return other.by != tables::ChosenBy::Person;
    });
  look();
}

void ImportModel::setConfirmed(int line, bool confirmed) {
  if (!asks()) return;
  if (confirmed)
    confirmed_.insert(line);
  else
    confirmed_.erase(line);
  emit changed();
}

void ImportModel::confirmAll() {
  if (!asks()) return;
  for (const tables::Refusal& question : report_->questions) confirmed_.insert(question.line);
  emit changed();
}

bool ImportModel::asks() const {
  return (state_ == State::Ready || state_ == State::Done) && report_ && report_->asked > 0;
}

int ImportModel::entering() const {
  const int confirmed = static_cast<int>(confirmed_.size());
  if (state_ == State::Done) return confirmed;  // the others are in
  return report_ ? report_->fresh + report_->changed + confirmed : 0;
}

tables::ImportOptions ImportModel::options() const {
  tables::ImportOptions options;
  options.unknown_places =
      make_places_ ? tables::UnknownPlaces::Make : tables::UnknownPlaces::Refuse;
  options.columns = chosen_;
  return options;
}

namespace {

// As the table calls it; what it does not have, as the window does.
QString columnWords(const tables::ImportReport& report, const std::string& column) {
  const bool named =
      std::any_of(report.mapping.columns.begin(), report.mapping.columns.end(),
                  [&](const tables::ColumnChoice& choice) { return choice.column == column; });
  return named ? text(column) : fieldLabel(column);
}

QString shownValue(const std::string& field, const std::string& value) {
  if (value.empty()) return QStringLiteral("–");
  return isNumber(field) ? typedText(*sherds::sherdField(field), value) : text(value);
}

// What is there and is replaced, before the new value: in the cell that says so.
void showChange(ImportModel::Row& row, const tables::ChangedValue& change,
                const tables::ImportReport& report) {
  const QString shown = QStringLiteral("%1 → %2").arg(shownValue(change.field, change.old_value),
                                                      shownValue(change.field, change.new_value));
  const auto& columns = report.mapping.columns;
  const auto at = std::ranges::find(columns, change.field, &tables::ColumnChoice::field);
  const auto column = static_cast<int>(at - columns.begin());
  if (at == columns.end() || column >= row.values.size()) {
    row.refusal += (row.refusal.isEmpty() ? QString() : QString(' ')) + fieldLabel(change.field) +
                   QStringLiteral(": ") + shown;
    return;
  }
  row.values[column] = shown;
  row.changed.insert(column);
}

// The rows of a table with their fates; of an export folder only what is refused is listed.
std::vector<ImportModel::Row> rowsOf(const tables::ImportReport& report,
                                     const tables::CsvTable* table) {
  std::map<int, QString> refusals;
  std::vector<tables::Refusal> all = report.refusals;
  all.insert(all.end(), report.questions.begin(), report.questions.end());
  for (const tables::Refusal& refusal : all) {
    QString why = wordsOf(refusal.reason);
    if (!refusal.column.empty())
      why = ImportModel::tr("%1 '%2': %3")
                .arg(columnWords(report, refusal.column), text(refusal.value), why);
    QString& all_of_line = refusals[refusal.line];
    all_of_line += (all_of_line.isEmpty() ? QString() : QString(' ')) + why;
  }
  std::vector<ImportModel::Row> rows;
  if (table == nullptr) {
    for (const auto& [line, why] : refusals)
      rows.push_back({line, tables::RowFate::Refused, {}, {}, why});
    return rows;
  }
  std::map<int, const tables::CsvRow*> by_line;
  for (const tables::CsvRow& row : table->rows) by_line[row.line] = &row;
  std::multimap<int, const tables::ChangedValue*> changes;
  for (const tables::ChangedValue& change : report.changed_values)
    changes.emplace(change.line, &change);
  using tables::RowFate;
  const auto take = [&](const std::set<RowFate>& fates) {
    for (const auto& [line, fate] : report.rows) {
      if (rows.size() == kMostRows) return;
      if (!fates.contains(fate)) continue;
      ImportModel::Row row{line, fate, {}, {}, refusals[line]};
      if (const auto read = by_line.find(line); read != by_line.end())
        for (const std::string& value : read->second->values)
          row.values << text(tables::unguarded(value));
      const auto [first, last] = changes.equal_range(line);
      for (auto change = first; change != last; ++change) showChange(row, *change->second, report);
      rows.push_back(std::move(row));
    }
  };
  take({RowFate::Refused});
  take({RowFate::Asked});
  take({RowFate::Changed});
  take({RowFate::Fresh, RowFate::Same});
  return rows;
}

}  // namespace

void ImportModel::look() {
  delete job_.data();
  problem_.clear();
  rows_.clear();
  columns_.clear();
  report_.reset();
  if (!session_ || source_.isEmpty()) return;
  state_ = State::Looking;
  Task task{source_.toStdString(), bytes_, options(), session_->provenance()};
  task.provenance.source = "import";
  const auto work = [folder = session_->folder(), task](
                        Progress& progress,
                        std::stop_token stop) -> Result<std::shared_ptr<const Look>> {
    auto look = std::make_shared<Look>();
    const Result<Bytes> bytes = task.bytes ? task.bytes : tableBytes(task.source);
    if (!bytes) return bytes.error();
    look->bytes = *bytes;
    Task read = task;
    read.bytes = look->bytes;
    Result<tables::ImportReport> report = runOnCopy(folder, read, progress, stop);
    if (!report) return report.error();
    if (look->bytes) {
      const Result<tables::CsvTable> table =
          tables::parseCsv(*look->bytes, task.source.filename().string());
      if (!table) return table.error();
      for (const std::string& column : table->columns) look->columns << text(column);
      look->rows = rowsOf(*report, &*table);
    } else {
      look->rows = rowsOf(*report, nullptr);
    }
    look->report = std::move(*report);
    return std::shared_ptr<const Look>(std::move(look));
  };
  job_ = session_->jobs().start(makeJob(work), this);
  connect(job_, &JobHandle::progressed, this, &ImportModel::changed);
  whenDone<std::shared_ptr<const Look>>(job_, this, [this](const auto& look) {
    if (look) return took(**look);
    state_ = State::Choosing;
    if (look.error().code == ErrorCode::Cancelled) return emit changed();
    if (!chosen_.empty()) {  // what was chosen does not fit: what was proposed is shown again
      chosen_.clear();
      this->look();
    }
    problem_ = sentenceOf(look.error());
    emit changed();
  });
  emit changed();
}

void ImportModel::took(const Look& look) {
  state_ = State::Ready;
  bytes_ = look.bytes;
  report_ = look.report;
  if (!report_->mapping.missing.empty()) problem_ = wordsOf(report_->mapping.missing);
  confirmed_.clear();  // the rows may mean something else now
  columns_ = look.columns;
  rows_ = look.rows;
  emit changed();
}

QString ImportModel::summary() const {
  if (!report_ || !report_->mapping.missing.empty()) return {};
  const QString counts = tr("%1 new, %2 updated, %3 unchanged, %4 rejected.")
                             .arg(report_->fresh)
                             .arg(report_->changed)
                             .arg(report_->same)
                             .arg(report_->refused);
  return report_->asked == 0 ? counts
                             : counts + QLatin1Char(' ') +
                                   tr("%n row(s) ask for a confirmation.", nullptr, report_->asked);
}

QStringList ImportModel::warnings() const {
  QStringList words = report_ ? listOf(report_->warnings) : QStringList();
  if (isOfContexts())
    words << tr(
        "Undo does not take back contexts and bags; the catalogue is backed up before the "
        "import.");
  else if (report_ && report_->fresh > 0)
    words << tr("Undo does not take back new sherds; each can be voided in its details.");
  return words;
}

bool ImportModel::isOfContexts() const {
  return report_ && report_->mapping.of_contexts;
}

bool ImportModel::canEnter() const {
  if (state_ == State::Done) return session_ && entering() > 0;
  // Of an export, other versions are kept beside sherds that count as refused.
  return session_ && state_ == State::Ready && report_ &&
         (entering() > 0 || !report_->undo.empty());
}

void ImportModel::enter() {
  if (!canEnter()) return;
  const State before = state_;
  state_ = State::Entering;
  Task task{source_.toStdString(), bytes_, options(), session_->provenance()};
  task.options.mode = tables::ImportMode::Enter;
  task.options.columns = report_->mapping.columns;
  task.options.guessed_units = tables::GuessedUnits::Enter;  // each was shown as a guess
  task.options.confirmed_lines = confirmed_;
  task.provenance.source = "import";
  const auto work = [folder = session_->folder(), task](
                        Progress& progress, std::stop_token stop) -> Result<tables::ImportReport> {
    Result<upkeep::Project> project = upkeep::Project::open(folder, {}, {stop, &progress});
    if (!project) return project.error();
    return run(*project, task, progress, stop);
  };
  job_ = session_->jobs().start(makeJob(work), this);
  connect(job_, &JobHandle::progressed, this, [this] {
    problem_.clear();  // it waits no longer
    emit changed();
  });
  connect(job_, &JobHandle::noted, this, [this](NoteLevel level, const QString& text) {
    if (level == NoteLevel::Warning) problem_ = text;
    emit changed();
  });
  whenDone<tables::ImportReport>(job_, this, [this, before](const auto& report) {
    if (!report) {
      state_ = before;
      problem_ = report.error().code == ErrorCode::Cancelled
                     ? tr("Cancelled. Nothing was imported.")
                     : sentenceOf(report.error());
      return emit changed();
    }
    state_ = State::Done;
    problem_ =
        report->not_reached == 0
            ? QString()
            : tr("Cancelled: %n row(s) were not imported. Import the table again for the rest.",
                 nullptr, report->not_reached);
    report_ = *report;
    settleRows();
    emit changed();
    emit entered(source_, *report);
  });
  emit changed();
}

// What asks and was not confirmed asks still.
void ImportModel::settleRows() {
  const std::map<int, tables::RowFate> fates(report_->rows.begin(), report_->rows.end());
  std::vector<Row> settled = rows_;  // rows in another place are shown anew
  for (Row& row : settled)
    if (const auto fate = fates.find(row.line);
        fate != fates.end() && row.fate == tables::RowFate::Asked)
      row.fate = fate->second;
  rows_ = std::move(settled);
  confirmed_.clear();
}

void ImportModel::cancel() {
  if (job_) job_->cancel();
}

Result<QString> ImportModel::saveRefusals(const QString& typed) const {
  const QStringList endings{"csv", "tsv", "txt"};
  const bool whole = endings.contains(QFileInfo(typed).suffix(), Qt::CaseInsensitive);
  const QString file = whole ? typed : typed + ".csv";
  // Nobody was asked about a name that was completed, and the table itself is still needed.
  const bool taken = !whole && QFileInfo::exists(file);
  if (taken || QFileInfo(file) == QFileInfo(source_))
    return Error::unusable(
        message("A file with this name already exists and is not overwritten; choose another "
                "name."),
        file.toStdString());
  if (Result<void> good = checkOutputPlace(file.toStdString()); !good) return good.error();
  const std::string rows =
      tables::refusedRowsCsv(report_.value_or(tables::ImportReport()),
                             [](const Message& reason) { return wordsOf(reason).toStdString(); });
  if (Result<void> written = writeFileAtomically(file.toStdString(), rows); !written)
    return written.error();
  return file;
}

}  // namespace ostraka::ui
