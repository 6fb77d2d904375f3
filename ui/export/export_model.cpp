#include "ui/export/export_model.h"

#include <QFileInfo>
#include <QLocale>
#include <algorithm>
#include <span>

#include "ui/export/export_choices.h"
#include "ui/frame/lines.h"
#include "ui/frame/project_session.h"
#include "ui/jobs/when_done.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

// Measured on a laptop's disk with hashing: writing, syncing and reading back.
constexpr double kBytesPerSecond = 60e6;
constexpr double kSecondsPerDrawing = 2;  // of a sherd of 60 mm
constexpr double kSecondsPerLighter = 3;  // likewise
constexpr std::size_t kMostNames = 8;     // of sherds, in a line

QString modellessWords(const std::vector<std::string>& names) {
  QStringList shown;
  for (const std::string& name : std::span(names).first(std::min(names.size(), kMostNames)))
    shown << QString::fromStdString(name);
  if (names.size() > kMostNames) shown << QStringLiteral("…");
  return ExportModel::tr("%n of them without a model: %1", nullptr, static_cast<int>(names.size()))
      .arg(shown.join(QStringLiteral(", ")));
}

}  // namespace

ExportModel::ExportModel(QObject* parent) : QObject(parent), choices_(new ExportChoices(this)) {
  connect(choices_, &ExportChoices::contentChanged, this, &ExportModel::chooseAnew);
  connect(choices_, &ExportChoices::targetChanged, this, &ExportModel::followTarget);
  connect(choices_, &ExportChoices::offerChanged, this, &ExportModel::changed);
}

void ExportModel::openProject(ProjectSession* session) {
  cancel();
  delete sizing_.data();
  delete running_.data();
  if (session_) session_->disconnect(this);
  session_ = session;
  if (session_) connect(session_, &ProjectSession::sherdsChanged, this, &ExportModel::measureSize);
  choices_->setSession(session);
  state_ = State::Choosing;
  done_.reset();
  problem_.clear();
  measureSize();
}

void ExportModel::setWatched(bool watched) {
  watched_ = watched;
  if (!watched_ && !size_) delete sizing_.data();
  if (watched_ && session_ && !sizing_ && !size_ && problem_.isEmpty()) measureSize();
}

void ExportModel::chooseAnew() {
  if (state_ == State::Done) choices_->takeFreeTarget();  // never over what was written
  forgetDone();
  measureSize();
}

void ExportModel::followTarget() {
  forgetDone();
  emit changed();
}

// What was exported before is told until somebody wants something else.
void ExportModel::forgetDone() {
  if (state_ == State::Running) return;
  state_ = State::Choosing;
  done_.reset();
}

void ExportModel::measureSize() {
  delete sizing_.data();
  size_.reset();
  problem_.clear();
  if (state_ == State::Failed) state_ = State::Choosing;
  if (session_ && watched_) {
    const auto work = [folder = session_->folder(), selection = choices_->selection(),
                       options = choices_->options()](
                          Progress&, std::stop_token stop) -> Result<exchange::ExportSize> {
      const Result<catalogue::Catalogue> catalogue = upkeep::Project::connect(folder);
      if (!catalogue) return catalogue.error();
      const auto rows = rowsOf(*catalogue, selection);
      if (!rows) return rows.error();
      return exchange::sizeOfExport(*catalogue, folder, *rows, options, stop);
    };
    sizing_ = session_->jobs().start(makeJob(work), this);
    whenDone<exchange::ExportSize>(sizing_, this, [this](const auto& size) {
      if (size)
        size_ = *size;
      else if (size.error().code != ErrorCode::Cancelled)
        problem_ = sentenceOf(size.error());
      emit changed();
    });
  }
  emit changed();
}

bool ExportModel::canStart() const {
  return session_ && state_ != State::Running && size_ && size_->sherds > 0 &&
         !choices_->forms().empty() && !choices_->target().isEmpty() &&
         !QFileInfo::exists(choices_->target());
}

QString ExportModel::sizeText() const {
  if (!size_) return session_ && problem_.isEmpty() ? tr("Counting…") : QString();
  if (size_->sherds == 0) return tr("No sherds match this selection.");
  const QLocale locale;
  const double seconds = static_cast<double>(size_->bytes) / kBytesPerSecond +
                         0.01 * static_cast<double>(size_->sherds) +
                         kSecondsPerDrawing * static_cast<double>(size_->drawings) +
                         kSecondsPerLighter * static_cast<double>(size_->lightened);
  const QString time =
      seconds < 60 ? tr("less than a minute")
                   : tr("about %n minute(s)", nullptr, static_cast<int>(seconds / 60 + 0.5));
  QString text =
      tr("%n sherd(s), %1 files, %2, %3", nullptr, size_->sherds)
          .arg(locale.toString(size_->files), locale.formattedDataSize(size_->bytes), time);
  if (!size_->without_model.empty()) text += "\n" + modellessWords(size_->without_model);
  const bool before = state_ == State::Choosing || state_ == State::Failed;
  if (before && QFileInfo::exists(choices_->target()))
    text += "\n" + tr("A folder with this name already exists; choose another name.");
  return text;
}

QString ExportModel::progressText() const {
  if (state_ != State::Running) return {};
  const QString percent = tr("%1 %").arg(qRound(100 * fraction_));
  const QString left = timeLeftWords(seconds_left_);
  return left.isEmpty() ? percent : percent + QStringLiteral(", ") + left;
}

QString ExportModel::closingLine() const {
  if (!done_) return {};
  return tr("%n sherd(s), %1, manifest checked", nullptr, done_->sherds)
      .arg(QLocale().formattedDataSize(done_->bytes));
}

QStringList ExportModel::warnings() const {
  if (!done_) return {};
  QStringList warnings = listOf(done_->warnings);
  if (!done_->without_model.empty()) warnings << modellessWords(done_->without_model);
  return warnings;
}

void ExportModel::start() {
  if (!canStart()) return;
  choices_->keepTarget();
  state_ = State::Running;
  fraction_ = 0;
  seconds_left_ = -1;
  problem_.clear();
  done_.reset();
  const auto work = [folder = session_->folder(), selection = choices_->selection(),
                     options = choices_->options()](
                        Progress& progress, std::stop_token stop) -> Result<exchange::Exported> {
    const Result<catalogue::Catalogue> catalogue = upkeep::Project::connect(folder);
    if (!catalogue) return catalogue.error();
    const auto rows = rowsOf(*catalogue, selection);
    if (!rows) return rows.error();
    return exchange::exportFolder(*catalogue, folder, *rows, options, progress, stop);
  };
  running_ = session_->jobs().start(makeJob(work, JobPriority::Background), this);
  connect(running_, &JobHandle::progressed, this, [this](const JobProgress& progress) {
    fraction_ = progress.fraction;
    seconds_left_ = progress.seconds_left;
    emit changed();
  });
  whenDone<exchange::Exported>(running_, this, [this](const auto& done) { ended(done); });
  emit changed();
}

void ExportModel::ended(const Result<exchange::Exported>& done) {
  if (done) {
    state_ = State::Done;
    done_ = *done;
  } else {
    state_ = State::Failed;
    problem_ = done.error().code == ErrorCode::Cancelled ? tr("Cancelled. Nothing was left behind.")
                                                         : sentenceOf(done.error());
  }
  emit changed();
  emit finished();
}

void ExportModel::cancel() {
  if (running_) running_->cancel();
}

}  // namespace ostraka::ui
