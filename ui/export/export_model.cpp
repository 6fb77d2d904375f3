#include "ui/export/export_model.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>
#include <QRegularExpression>

#include "catalogue/settings.h"
#include "sherds/filter.h"
#include "sherds/sherds.h"
#include "ui/catalogue/field_words.h"
#include "ui/frame/project_session.h"
#include "ui/words/print_wording.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

// Measured on a laptop's disk with hashing: writing, syncing and reading back.
constexpr double kBytesPerSecond = 60e6;
constexpr double kSecondsPerDrawing = 2;  // of a sherd of 60 mm
constexpr double kSecondsPerLighter = 3;  // likewise
constexpr const char* kChoicesKey = "export.choices";

Result<std::vector<store::SherdRow>> rowsOf(const catalogue::Catalogue& catalogue,
                                            ExportModel::What what, const QString& line,
                                            const std::vector<store::SherdRow>& chosen) {
  if (what == ExportModel::What::Chosen) return chosen;
  const Result<sherds::Filter> filter = sherds::parseFilter(
      what == ExportModel::What::Filtered ? withFieldNames(line).toStdString() : std::string());
  if (!filter) return filter.error();
  return sherds::Sherds(catalogue).rows(*filter, {});
}

// The same, or with the first number behind it that no folder has.
QString freeName(const QString& folder) {
  static const QRegularExpression counted(QStringLiteral("-\\d+$"));
  const QString first = QString(folder).remove(counted);
  QString name = folder;
  for (int i = 2; QFileInfo::exists(name); ++i) name = QStringLiteral("%1-%2").arg(first).arg(i);
  return name;
}

}  // namespace

ExportModel::ExportModel(QObject* parent) : QObject(parent) {}

void ExportModel::openProject(ProjectSession* session) {
  cancel();
  delete sizing_.data();
  delete running_.data();
  if (session_) session_->disconnect(this);
  session_ = session;
  if (session_) connect(session_, &ProjectSession::sherdsChanged, this, &ExportModel::measureSize);
  what_ = What::All;
  filter_.clear();
  chosen_.clear();
  state_ = State::Choosing;
  done_.reset();
  problem_.clear();
  target_.clear();  // another project's
  if (session_) readChoices();
  measureSize();
}

void ExportModel::readChoices() {
  const exchange::ExportOptions usual;
  forms_ = usual.forms;
  drawing_scale_ = usual.drawing_scale;
  deviation_mm_ = usual.deviation_mm;
  parent_ = QDir::homePath();
  const Result<std::string> kept =
      catalogue::Settings(session_->project().catalogue()).value(kChoicesKey);
  const QJsonObject choices =
      QJsonDocument::fromJson(QByteArray::fromStdString(kept ? *kept : std::string())).object();
  if (!choices.isEmpty()) {
    forms_.clear();
    for (const QJsonValue& form : choices[QStringLiteral("forms")].toArray())
      if (form.toInt(-1) >= 0 && form.toInt() <= static_cast<int>(exchange::Form::Views))
        forms_.insert(static_cast<exchange::Form>(form.toInt()));
    const double scale = choices[QStringLiteral("drawing_scale")].toDouble();
    drawing_scale_ = scale > 0 ? std::optional(scale) : std::nullopt;
    deviation_mm_ = qBound(0.0, choices[QStringLiteral("deviation_mm")].toDouble(), 1.0);
    const QString parent = choices[QStringLiteral("folder")].toString();
    if (!parent.isEmpty() && QFileInfo(parent).isDir()) parent_ = parent;
  }
  target_ = proposedTarget();
}

void ExportModel::keepChoices() const {
  if (!session_) return;
  QJsonArray forms;
  for (const exchange::Form form : forms_) forms.append(static_cast<int>(form));
  const QJsonObject choices{{QStringLiteral("forms"), forms},
                            {QStringLiteral("drawing_scale"), drawing_scale_.value_or(0)},
                            {QStringLiteral("deviation_mm"), deviation_mm_},
                            {QStringLiteral("folder"), parent_}};
  (void)catalogue::Settings(session_->project().catalogue())
      .setValue(kChoicesKey, QJsonDocument(choices).toJson(QJsonDocument::Compact).toStdString());
}

QString ExportModel::proposedTarget() const {
  return freeName(QDir(parent_).filePath(
      QString::fromStdString(session_->folder().filename().string()) + QStringLiteral("-export")));
}

void ExportModel::setWatched(bool watched) {
  watched_ = watched;
  if (!watched_ && !size_) delete sizing_.data();
  if (watched_ && session_ && !sizing_ && !size_ && problem_.isEmpty()) measureSize();
}

void ExportModel::setAll() {
  what_ = What::All;
  chooseAnew();
}

void ExportModel::setFilter(const QString& line) {
  what_ = What::Filtered;
  filter_ = line;
  chooseAnew();
}

void ExportModel::setChosen(std::vector<store::SherdRow> sherds) {
  if (what_ == What::Chosen && sherds == chosen_) return;
  what_ = What::Chosen;
  chosen_ = std::move(sherds);
  chooseAnew();
}

void ExportModel::offerChosen(std::vector<store::SherdRow> sherds) {
  if (sherds == chosen_) return;
  chosen_ = std::move(sherds);
  if (what_ == What::Chosen) return chooseAnew();
  emit changed();
}

void ExportModel::chooseAnew() {
  forgetDone();
  measureSize();
}

// What was exported before is told until somebody wants something else.
void ExportModel::forgetDone() {
  if (state_ == State::Running) return;
  if (state_ == State::Done) target_ = freeName(target_);  // never over what was written
  state_ = State::Choosing;
  done_.reset();
}

void ExportModel::setForm(exchange::Form form, bool wanted) {
  if (wanted)
    forms_.insert(form);
  else
    forms_.erase(form);
  keepChoices();
  chooseAnew();
}

void ExportModel::setDrawingScale(std::optional<double> scale) {
  drawing_scale_ = scale;
  keepChoices();
  chooseAnew();
}

void ExportModel::setDeviation(double deviation_mm) {
  deviation_mm_ = deviation_mm;
  keepChoices();
  chooseAnew();
}

void ExportModel::setTarget(const QString& folder) {
  forgetDone();
  target_ = folder.trimmed();
  emit changed();
}

exchange::ExportOptions ExportModel::options() const {
  exchange::ExportOptions options;
  options.target = target_.toStdString();
  options.forms = forms_;
  options.drawing_scale = drawing_scale_;
  options.deviation_mm = deviation_mm_;
  options.wording = printWording();
  options.program = ("ostraka " + QCoreApplication::applicationVersion()).trimmed().toStdString();
  return options;
}

void ExportModel::measureSize() {
  delete sizing_.data();
  size_.reset();
  problem_.clear();
  if (state_ == State::Failed) state_ = State::Choosing;
  if (session_ && watched_) {
    const auto work = [folder = session_->folder(), what = what_, line = filter_, chosen = chosen_,
                       options = options()](Progress&,
                                            std::stop_token stop) -> Result<exchange::ExportSize> {
      const Result<catalogue::Catalogue> catalogue = upkeep::Project::connect(folder);
      if (!catalogue) return catalogue.error();
      const auto rows = rowsOf(*catalogue, what, line, chosen);
      if (!rows) return rows.error();
      return exchange::sizeOfExport(*catalogue, folder, *rows, options, stop);
    };
    sizing_ = session_->jobs().start(makeJob(tr("Size of the export"), work), this);
    connect(sizing_, &JobHandle::finished, this, [this](const JobOutcome& outcome) {
      const Result<exchange::ExportSize> size = outcomeAs<exchange::ExportSize>(outcome);
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
  return session_ && state_ != State::Running && size_ && size_->sherds > 0 && !forms_.empty() &&
         !target_.isEmpty() && !QFileInfo::exists(target_);
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
  if (size_->without_model > 0)
    text += "\n" + tr("%n of them without a model", nullptr, size_->without_model);
  const bool before = state_ == State::Choosing || state_ == State::Failed;
  if (before && QFileInfo::exists(target_))
    text += "\n" + tr("A folder with this name already exists; choose another name.");
  return text;
}

QString ExportModel::progressText() const {
  if (state_ != State::Running) return {};
  const QString percent = tr("%1 %").arg(qRound(100 * fraction_));
  return seconds_left_ < 0
             ? percent
             : tr("%1, %n second(s) left", nullptr, qRound(seconds_left_)).arg(percent);
}

QString ExportModel::closingLine() const {
  if (!done_) return {};
  return tr("%n sherd(s), %1, manifest checked", nullptr, done_->sherds)
      .arg(QLocale().formattedDataSize(done_->bytes));
}

QStringList ExportModel::warnings() const {
  QStringList list;
  if (done_)
    for (const std::string& warning : done_->warnings) list << wordsOf(warning);
  return list;
}

void ExportModel::start() {
  if (!canStart()) return;
  parent_ = QFileInfo(target_).absolutePath();
  keepChoices();
  state_ = State::Running;
  fraction_ = 0;
  seconds_left_ = -1;
  problem_.clear();
  done_.reset();
  const auto work = [folder = session_->folder(), what = what_, line = filter_, chosen = chosen_,
                     options = options()](Progress& progress,
                                          std::stop_token stop) -> Result<exchange::Exported> {
    const Result<catalogue::Catalogue> catalogue = upkeep::Project::connect(folder);
    if (!catalogue) return catalogue.error();
    const auto rows = rowsOf(*catalogue, what, line, chosen);
    if (!rows) return rows.error();
    return exchange::exportFolder(*catalogue, folder, *rows, options, progress, stop);
  };
  running_ = session_->jobs().start(makeJob(tr("Export"), work, JobPriority::Background), this);
  connect(running_, &JobHandle::progressed, this, [this](const JobProgress& progress) {
    fraction_ = progress.fraction;
    seconds_left_ = progress.seconds_left;
    emit changed();
  });
  connect(running_, &JobHandle::finished, this,
          [this](const JobOutcome& outcome) { ended(outcomeAs<exchange::Exported>(outcome)); });
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
