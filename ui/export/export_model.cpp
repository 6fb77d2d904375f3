#include "ui/export/export_model.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <utility>

#include "catalogue/queue_pause.h"
#include "sherds/filter.h"
#include "sherds/sherds.h"
#include "ui/frame/lines.h"
#include "ui/frame/project_session.h"
#include "ui/jobs/when_done.h"
#include "ui/sherds/field_words.h"
#include "ui/words/print_wording.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

using What = ExportSelection::What;

constexpr const char* kChoicesKey = "export.choices";

QString withoutCount(QString folder) {
  static const QRegularExpression counted(QStringLiteral("-\\d+$"));
  return folder.remove(counted);
}

// The same, or with the first number behind it that no folder has.
QString freeName(const QString& folder) {
  const QString first = withoutCount(folder);
  QString name = folder;
  for (int i = 2; QFileInfo::exists(name); ++i) name = QStringLiteral("%1-%2").arg(first).arg(i);
  return name;
}

QString proposedTarget(const ProjectSession& session, const QString& parent, What what) {
  return freeName(QDir(parent).filePath(
      QString::fromStdString(session.folder().filename().string()) +
      (what == What::Project ? QStringLiteral("-archive") : QStringLiteral("-export"))));
}

Result<std::vector<store::SherdRow>> rowsOf(const catalogue::Catalogue& catalogue,
                                            const ExportSelection& selection) {
  if (selection.what == What::Chosen) return selection.chosen;
  const Result<sherds::Filter> filter = sherds::parseFilter(
      selection.what == What::Filtered ? withFieldNames(selection.filter).toStdString()
                                       : std::string());
  if (!filter) return filter.error();
  return sherds::Sherds(catalogue).rows(*filter, {});
}

// Measured on a laptop's disk with hashing: writing, syncing and reading back.
constexpr double kBytesPerSecond = 60e6;
constexpr double kSecondsPerDrawing = 2;  // of a sherd of 60 mm
constexpr double kSecondsPerLighter = 3;  // likewise
constexpr qsizetype kMostNames = 8;       // of sherds, in a line

QString modellessWords(const std::vector<std::string>& names) {
  QStringList shown;
  for (const std::string& name : names) shown << QString::fromStdString(name);
  return ExportModel::tr("%n of them without a model: %1", nullptr, static_cast<int>(names.size()))
      .arg(firstOf(shown, kMostNames));
}

}  // namespace

void ExportModel::openProject(ProjectSession* session) {
  cancel();
  delete sizing_.data();
  delete running_.data();
  if (session_) session_->disconnect(this);
  session_ = session;
  if (session_) {
    connect(session_, &ProjectSession::sherdsChanged, this, &ExportModel::measureSize);
    connect(session_, &ProjectSession::batchChanged, this, [this] {
      const int before = queued_;
      countQueued();
      if (queued_ != before) emit changed();
    });
  }
  selection_ = {};
  options_ = {};  // the target is another project's
  if (session_) readChoices();
  state_ = State::Choosing;
  closing_.clear();
  warnings_.clear();
  problem_.clear();
  measureSize();
}

void ExportModel::setWatched(bool watched) {
  watched_ = watched;
  if (!watched_ && !size_) delete sizing_.data();
  if (watched_ && session_ && !sizing_ && !size_ && problem_.isEmpty()) measureSize();
}

void ExportModel::readChoices() {
  parent_ = QDir::homePath();
  const QJsonObject choices =
      QJsonDocument::fromJson(session_->setting(kChoicesKey).toUtf8()).object();
  if (!choices.isEmpty()) {
    options_.forms.clear();
    for (const QJsonValue& form : choices[QStringLiteral("forms")].toArray())
      if (form.toInt(-1) >= 0 && form.toInt() <= static_cast<int>(exchange::Form::Views))
        options_.forms.insert(static_cast<exchange::Form>(form.toInt()));
    const double scale = choices[QStringLiteral("drawing_scale")].toDouble();
    options_.drawing_scale = scale > 0 ? std::optional(scale) : std::nullopt;
    const int surface = choices[QStringLiteral("drawing_surface")].toInt();
    if (surface >= 0 && surface <= static_cast<int>(drawing::Surface::Orthophoto))
      options_.drawing_surface = static_cast<drawing::Surface>(surface);
    const int dpi = choices[QStringLiteral("drawing_dpi")].toInt();
    options_.drawing_dpi =
        dpi == static_cast<int>(drawing::Dpi::Fine) ? drawing::Dpi::Fine : drawing::Dpi::Usual;
    options_.most_model_bytes = static_cast<std::size_t>(
        std::max<qint64>(0, choices[QStringLiteral("most_model_bytes")].toInteger()));
    const QString parent = choices[QStringLiteral("folder")].toString();
    if (!parent.isEmpty() && QFileInfo(parent).isDir()) parent_ = parent;
  }
  options_.target = proposedTarget(*session_, parent_, selection_.what).toStdString();
}

void ExportModel::keepChoices() const {
  if (!session_) return;
  QJsonArray forms;
  for (const exchange::Form form : options_.forms) forms.append(static_cast<int>(form));
  const QJsonObject choices{
      {QStringLiteral("forms"), forms},
      {QStringLiteral("drawing_scale"), options_.drawing_scale.value_or(0)},
      {QStringLiteral("drawing_surface"), static_cast<int>(options_.drawing_surface)},
      {QStringLiteral("drawing_dpi"), static_cast<int>(options_.drawing_dpi)},
      {QStringLiteral("most_model_bytes"), static_cast<qint64>(options_.most_model_bytes)},
      {QStringLiteral("folder"), parent_}};
  session_->keepSetting(kChoicesKey, QJsonDocument(choices).toJson(QJsonDocument::Compact));
}

exchange::ExportOptions ExportModel::worded() const {
  exchange::ExportOptions options = options_;
  options.wording = printWording();
  options.words = [](const std::string& column) { return fieldLabel(column).toStdString(); };
  options.program = ("ostraka " + QCoreApplication::applicationVersion()).trimmed().toStdString();
  return options;
}

void ExportModel::choose(ExportSelection selection) {
  const bool same = selection.what == What::Chosen && selection_.what == What::Chosen &&
                    selection.chosen == selection_.chosen;
  const What before = std::exchange(selection_, std::move(selection)).what;
  // A proposed name says what it is the name of; one that was typed stays.
  if (session_ &&
      withoutCount(target()) == withoutCount(proposedTarget(*session_, parent_, before)))
    options_.target = proposedTarget(*session_, parent_, selection_.what).toStdString();
  if (!same) chooseAnew();
}

void ExportModel::setOptions(exchange::ExportOptions options) {
  options_ = std::move(options);
  keepChoices();
  chooseAnew();
}

void ExportModel::setTarget(const QString& folder) {
  options_.target = folder.trimmed().toStdString();
  forgetDone();
  emit changed();
}

void ExportModel::chooseAnew() {
  // Never over what was written.
  if (state_ == State::Done) options_.target = freeName(target()).toStdString();
  forgetDone();
  measureSize();
}

// What was exported before is told until somebody wants something else.
void ExportModel::forgetDone() {
  if (state_ == State::Running) return;
  state_ = State::Choosing;
  closing_.clear();
  warnings_.clear();
}

void ExportModel::measureSize() {
  delete sizing_.data();
  size_.reset();
  problem_.clear();
  if (state_ == State::Failed) state_ = State::Choosing;
  countQueued();
  if (session_ && watched_ && !isArchive()) {
    const auto work = [folder = session_->folder(), selection = selection_, options = worded()](
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

void ExportModel::countQueued() {
  const auto queued = session_ && isArchive()
                          ? catalogue::batchesInQueue(session_->project().catalogue())
                          : Result<int>(0);
  queued_ = queued ? *queued : 0;
}

// Whoever does not wait for the count gets the same export.
bool ExportModel::canStart() const {
  const bool any =
      isArchive() || ((size_ ? size_->sherds > 0 : !sizing_.isNull()) && !options_.forms.empty());
  return session_ && state_ != State::Running && any && !target().isEmpty() &&
         !QFileInfo::exists(target());
}

QString ExportModel::sizeText() const {
  const bool before = state_ == State::Choosing || state_ == State::Failed;
  const QString taken =
      before && QFileInfo::exists(target())
          ? "\n" + tr("A folder with this name already exists; choose another name.")
          : QString();
  if (isArchive()) {
    QString words =
        tr("Everything in the project, with checksums. 'Restore an archive' on the start "
           "screen makes the project from it again.");
    if (queued_ > 0)
      words += "\n" + tr("%n batch(es) in the queue: the archive holds their photographs and the "
                         "stages that are finished when it is made; the restored project "
                         "processes the rest.",
                         nullptr, queued_);
    return words + taken;
  }
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
  return text + taken;
}

QString ExportModel::progressText() const {
  if (state_ != State::Running) return {};
  const QString percent = tr("%1 %").arg(qRound(100 * fraction()));
  const QString left = timeLeftWords(running_ ? running_->progress().seconds_left : -1);
  return left.isEmpty() ? percent : percent + QStringLiteral(", ") + left;
}

void ExportModel::start() {
  if (!canStart()) return;
  parent_ = QFileInfo(target()).absolutePath();
  keepChoices();
  if (isArchive()) {
    // A project with damage is archived with the list of it: half a copy is better than none.
    const auto work = [folder = session_->folder(),
                       options = archive::ArchiveOptions{options_.target, worded().program,
                                                         archive::DamagedFiles::Seal}](
                          Progress& progress, std::stop_token stop) -> Result<archive::Archived> {
      const Result<upkeep::Project> project = upkeep::Project::open(folder);
      if (!project) return project.error();
      return archive::archiveProject(*project, options, progress, stop);
    };
    run(session_->jobs().start(makeJob(work, JobPriority::Background), this));
    whenDone<archive::Archived>(running_, this, [this](const auto& done) { archived(done); });
  } else {
    const auto work = [folder = session_->folder(), selection = selection_, options = worded()](
                          Progress& progress, std::stop_token stop) -> Result<exchange::Exported> {
      const Result<catalogue::Catalogue> catalogue = upkeep::Project::connect(folder);
      if (!catalogue) return catalogue.error();
      const auto rows = rowsOf(*catalogue, selection);
      if (!rows) return rows.error();
      return exchange::exportFolder(*catalogue, folder, *rows, options, progress, stop);
    };
    run(session_->jobs().start(makeJob(work, JobPriority::Background), this));
    whenDone<exchange::Exported>(running_, this, [this](const auto& done) { exported(done); });
  }
  emit changed();
}

void ExportModel::run(JobHandle* job) {
  running_ = job;
  state_ = State::Running;
  problem_.clear();
  closing_.clear();
  warnings_.clear();
  connect(running_, &JobHandle::progressed, this, &ExportModel::changed);
}

void ExportModel::exported(const Result<exchange::Exported>& done) {
  if (done) {
    closing_ = tr("%n sherd(s), %1, manifest checked", nullptr, done->sherds)
                   .arg(QLocale().formattedDataSize(done->bytes));
    warnings_ = listOf(done->warnings);
    if (!done->without_model.empty()) warnings_ << modellessWords(done->without_model);
  }
  ended(done ? nullptr : &done.error());
}

void ExportModel::archived(const Result<archive::Archived>& done) {
  if (done) {
    closing_ = tr("The whole project, %1").arg(QLocale().formattedDataSize(done->bytes));
    if (!done->whole())
      warnings_ << tr(
          "%n file(s) of the project are missing, changed or links; damage.txt in the "
          "archive lists them.",
          nullptr, static_cast<int>(done->damage.size() + done->links.size()));
  }
  ended(done ? nullptr : &done.error());
}

void ExportModel::ended(const Error* why_not) {
  state_ = why_not == nullptr ? State::Done : State::Failed;
  if (why_not != nullptr)
    problem_ = why_not->code == ErrorCode::Cancelled ? tr("Cancelled. Nothing was left behind.")
                                                     : sentenceOf(*why_not);
  emit changed();
  emit finished();
}

void ExportModel::cancel() {
  if (running_) running_->cancel();
}

}  // namespace ostraka::ui
