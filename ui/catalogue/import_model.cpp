#include "ui/catalogue/import_model.h"

#include <QFileInfo>
#include <QTemporaryDir>
#include <algorithm>
#include <map>
#include <memory>

#include "base/files.h"
#include "base/limits.h"
#include "catalogue/project.h"
#include "exchange/csv.h"
#include "exchange/read_back.h"
#include "ui/frame/project_session.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRows = 1000;
constexpr std::size_t kLargest = limits::kTableBytes.most;

struct Task {
  fs::path source;
  exchange::ImportOptions options;
  catalogue::Act act;
};

Result<exchange::ImportReport> run(catalogue::Project& project, const Task& task,
                                   Progress& progress, std::stop_token stop) {
  if (fs::is_directory(task.source))
    return exchange::readBack(project, task.source, task.options.mode, task.act, progress, stop);
  const Result<std::string> bytes = readFile(task.source, kLargest);
  if (!bytes) return bytes.error();
  if (task.options.mode == exchange::ImportMode::Enter)
    if (const auto saved = project.backUp(); !saved) return saved.error();
  return exchange::importTable(project.catalogue(), *bytes, task.source.string(), task.options,
                               task.act, progress, stop);
}

// On a copy: a preview does everything and takes it back, and nobody should wait meanwhile.
Result<exchange::ImportReport> runOnCopy(const fs::path& folder, const Task& task,
                                         Progress& progress, std::stop_token stop) {
  const QTemporaryDir copy;
  if (!copy.isValid())
    return Error{ErrorCode::CannotWrite, "There is no room for a copy of the catalogue.",
                 copy.path().toStdString()};
  const fs::path there = copy.path().toStdString();
  {
    const Result<catalogue::Catalogue> original = catalogue::Project::connect(folder);
    if (!original) return original.error();
    if (const auto copied = original->backup(there / "catalogue.sqlite"); !copied)
      return copied.error();
  }
  Result<catalogue::Project> project = catalogue::Project::open(there);
  if (!project) return project.error();
  return run(*project, task, progress, stop);
}

QString text(const std::string& value) {
  return QString::fromStdString(value);
}

}  // namespace

struct ImportModel::Look {
  exchange::ImportReport report;
  QStringList columns;
  std::vector<Row> rows;
};

ImportModel::ImportModel(QObject* parent) : QObject(parent) {}

void ImportModel::openProject(ProjectSession* session) {
  // What is being entered goes on: its report and its undo would be lost.
  if (state_ == State::Entering && session == session_) return emit changed();
  delete job_.data();
  session_ = session;
  state_ = State::Choosing;
  source_.clear();
  problem_.clear();
  rows_.clear();
  report_.reset();
  emit changed();
}

void ImportModel::setSource(const QString& path) {
  if (state_ == State::Entering) return;
  source_ = path;
  look();
}

void ImportModel::setMakesPlaces(bool make) {
  if (make == make_places_ || state_ == State::Entering) return;
  make_places_ = make;
  if (!source_.isEmpty()) look();
}

namespace {

// The rows of a table with their fates; of an export folder only what is refused is listed.
std::vector<ImportModel::Row> rowsOf(const exchange::ImportReport& report,
                                     const exchange::CsvTable* table) {
  std::map<int, QString> refusals;
  for (const exchange::Refusal& refusal : report.refusals) {
    QString why = wordsOf(refusal.reason);
    if (!refusal.column.empty())
      why = ImportModel::tr("%1 '%2': %3").arg(text(refusal.column), text(refusal.value), why);
    refusals[refusal.line] = why;
  }
  std::vector<ImportModel::Row> rows;
  if (table == nullptr) {
    for (const auto& [line, why] : refusals)
      rows.push_back({line, exchange::RowFate::Refused, {}, why});
    return rows;
  }
  std::map<int, const exchange::CsvRow*> by_line;
  for (const exchange::CsvRow& row : table->rows) by_line[row.line] = &row;
  const auto take = [&](bool refused) {
    for (const auto& [line, fate] : report.rows) {
      if (rows.size() == kMostRows) return;
      if ((fate == exchange::RowFate::Refused) != refused) continue;
      ImportModel::Row row{line, fate, {}, refusals[line]};
      if (const auto read = by_line.find(line); read != by_line.end())
        for (const std::string& value : read->second->values)
          row.values << text(exchange::unguarded(value));
      rows.push_back(std::move(row));
    }
  };
  take(true);
  take(false);
  return rows;
}

}  // namespace

void ImportModel::look() {
  delete job_.data();
  problem_.clear();
  rows_.clear();
  columns_.clear();
  report_.reset();
  fraction_ = 0;
  if (!session_ || source_.isEmpty()) return;
  state_ = State::Looking;
  Task task{source_.toStdString(), exchange::ImportOptions(), session_->act()};
  task.options.unknown_places =
      make_places_ ? exchange::UnknownPlaces::Make : exchange::UnknownPlaces::Refuse;
  task.act.source = "import";
  const auto work = [folder = session_->folder(), task](
                        Progress& progress,
                        std::stop_token stop) -> Result<std::shared_ptr<const Look>> {
    Result<exchange::ImportReport> report = runOnCopy(folder, task, progress, stop);
    if (!report) return report.error();
    auto look = std::make_shared<Look>();
    if (!fs::is_directory(task.source)) {
      const Result<std::string> bytes = readFile(task.source, kLargest);
      if (!bytes) return bytes.error();
      const Result<exchange::CsvTable> table =
          exchange::parseCsv(*bytes, task.source.filename().string());
      if (!table) return table.error();
      for (const std::string& column : table->columns) look->columns << text(column);
      look->rows = rowsOf(*report, &*table);
    } else {
      look->rows = rowsOf(*report, nullptr);
    }
    look->report = std::move(*report);
    return std::shared_ptr<const Look>(std::move(look));
  };
  job_ = session_->jobs().start(makeJob(tr("Preview of an import"), work), this);
  connect(job_, &JobHandle::progressed, this, [this](const JobProgress& progress) {
    fraction_ = progress.fraction;
    emit changed();
  });
  connect(job_, &JobHandle::finished, this, [this](const JobOutcome& outcome) {
    const auto look = outcomeAs<std::shared_ptr<const Look>>(outcome);
    job_->deleteLater();
    job_.clear();
    if (look) return took(**look);
    state_ = State::Choosing;
    if (look.error().code != ErrorCode::Cancelled) problem_ = sentenceOf(look.error());
    emit changed();
  });
  emit changed();
}

void ImportModel::took(const Look& look) {
  state_ = State::Ready;
  report_ = look.report;
  columns_ = look.columns;
  rows_ = look.rows;
  emit changed();
}

QString ImportModel::summary() const {
  if (!report_) return {};
  return tr("%1 new, %2 changed, %3 as they are, %4 refused.")
      .arg(report_->fresh)
      .arg(report_->changed)
      .arg(report_->same)
      .arg(report_->refused);
}

QStringList ImportModel::warnings() const {
  QStringList all;
  if (report_)
    for (const std::string& warning : report_->warnings) all << wordsOf(warning);
  return all;
}

bool ImportModel::isOfContexts() const {
  return !columns_.isEmpty() && !columns_.contains(QStringLiteral("number")) &&
         !columns_.contains(QStringLiteral("uuid"));
}

bool ImportModel::canEnter() const {
  // Of an export, other versions are kept beside sherds that count as refused.
  return session_ && state_ == State::Ready && report_ &&
         (report_->fresh + report_->changed > 0 || !report_->undo.empty());
}

void ImportModel::enter() {
  if (!canEnter()) return;
  state_ = State::Entering;
  fraction_ = 0;
  Task task{source_.toStdString(), exchange::ImportOptions(), session_->act()};
  task.options.mode = exchange::ImportMode::Enter;
  task.options.unknown_places =
      make_places_ ? exchange::UnknownPlaces::Make : exchange::UnknownPlaces::Refuse;
  task.act.source = "import";
  const auto work = [folder = session_->folder(), task](
                        Progress& progress,
                        std::stop_token stop) -> Result<exchange::ImportReport> {
    Result<catalogue::Project> project = catalogue::Project::open(folder);
    if (!project) return project.error();
    return run(*project, task, progress, stop);
  };
  job_ = session_->jobs().start(makeJob(tr("Import"), work), this);
  connect(job_, &JobHandle::progressed, this, [this](const JobProgress& progress) {
    fraction_ = progress.fraction;
    emit changed();
  });
  connect(job_, &JobHandle::finished, this, [this](const JobOutcome& outcome) {
    const auto report = outcomeAs<exchange::ImportReport>(outcome);
    job_->deleteLater();
    job_.clear();
    if (!report) {
      state_ = State::Ready;
      problem_ = report.error().code == ErrorCode::Cancelled ? tr("Stopped; nothing was entered.")
                                                             : sentenceOf(report.error());
      return emit changed();
    }
    state_ = State::Done;
    problem_ = report->not_reached == 0
                   ? QString()
                   : tr("Stopped: %n row(s) are not entered. Import the table again for the rest.",
                        nullptr, report->not_reached);
    report_ = *report;
    emit changed();
    emit entered(source_, *report);
  });
  emit changed();
}

void ImportModel::cancel() {
  if (job_) job_->cancel();
}

QString ImportModel::saveRefusals(const QString& file) const {
  if (!report_) return {};
  const Result<void> written =
      writeFileAtomically(file.toStdString(), exchange::refusalsCsv(*report_));
  return written ? QString() : sentenceOf(written.error());
}

}  // namespace ostraka::ui
