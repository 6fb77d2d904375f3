#include "ui/export/export_choices.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>

#include "sherds/filter.h"
#include "sherds/sherds.h"
#include "ui/frame/project_session.h"
#include "ui/sherds/field_words.h"
#include "ui/words/print_wording.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

using What = ExportSelection::What;

constexpr const char* kChoicesKey = "export.choices";

// The same, or with the first number behind it that no folder has.
QString freeName(const QString& folder) {
  static const QRegularExpression counted(QStringLiteral("-\\d+$"));
  const QString first = QString(folder).remove(counted);
  QString name = folder;
  for (int i = 2; QFileInfo::exists(name); ++i) name = QStringLiteral("%1-%2").arg(first).arg(i);
  return name;
}

QString proposedTarget(const ProjectSession& session, const QString& parent) {
  return freeName(QDir(parent).filePath(
      QString::fromStdString(session.folder().filename().string()) + QStringLiteral("-export")));
}

}  // namespace

Result<std::vector<store::SherdRow>> rowsOf(const catalogue::Catalogue& catalogue,
                                            const ExportSelection& selection) {
  if (selection.what == What::Chosen) return selection.chosen;
  const Result<sherds::Filter> filter = sherds::parseFilter(
      selection.what == What::Filtered ? withFieldNames(selection.filter).toStdString()
                                       : std::string());
  if (!filter) return filter.error();
  return sherds::Sherds(catalogue).rows(*filter, {});
}

ExportChoices::ExportChoices(QObject* parent) : QObject(parent) {}

void ExportChoices::setSession(ProjectSession* session) {
  session_ = session;
  selection_ = {};
  target_.clear();  // another project's
  if (session_) readChoices();
}

void ExportChoices::readChoices() {
  const exchange::ExportOptions usual;
  forms_ = usual.forms;
  drawing_scale_ = usual.drawing_scale;
  most_model_bytes_ = usual.most_model_bytes;
  parent_ = QDir::homePath();
  const QJsonObject choices =
      QJsonDocument::fromJson(session_->setting(kChoicesKey).toUtf8()).object();
  if (!choices.isEmpty()) {
    forms_.clear();
    for (const QJsonValue& form : choices[QStringLiteral("forms")].toArray())
      if (form.toInt(-1) >= 0 && form.toInt() <= static_cast<int>(exchange::Form::Views))
        forms_.insert(static_cast<exchange::Form>(form.toInt()));
    const double scale = choices[QStringLiteral("drawing_scale")].toDouble();
    drawing_scale_ = scale > 0 ? std::optional(scale) : std::nullopt;
    most_model_bytes_ = static_cast<std::size_t>(
        std::max<qint64>(0, choices[QStringLiteral("most_model_bytes")].toInteger()));
    const QString parent = choices[QStringLiteral("folder")].toString();
    if (!parent.isEmpty() && QFileInfo(parent).isDir()) parent_ = parent;
  }
  target_ = proposedTarget(*session_, parent_);
}

void ExportChoices::keepChoices() const {
  if (!session_) return;
  QJsonArray forms;
  for (const exchange::Form form : forms_) forms.append(static_cast<int>(form));
  const QJsonObject choices{
      {QStringLiteral("forms"), forms},
      {QStringLiteral("drawing_scale"), drawing_scale_.value_or(0)},
      {QStringLiteral("most_model_bytes"), static_cast<qint64>(most_model_bytes_)},
      {QStringLiteral("folder"), parent_}};
  session_->keepSetting(kChoicesKey, QJsonDocument(choices).toJson(QJsonDocument::Compact));
}

exchange::ExportOptions ExportChoices::options() const {
  exchange::ExportOptions options;
  options.target = target_.toStdString();
  options.forms = forms_;
  options.drawing_scale = drawing_scale_;
  options.most_model_bytes = most_model_bytes_;
  options.wording = printWording();
  options.words = [](const std::string& column) { return fieldLabel(column).toStdString(); };
  options.program = ("ostraka " + QCoreApplication::applicationVersion()).trimmed().toStdString();
  return options;
}

void ExportChoices::setAll() {
  selection_.what = What::All;
  emit contentChanged();
}

void ExportChoices::setFilter(const QString& line) {
  selection_.what = What::Filtered;
  selection_.filter = line;
  emit contentChanged();
}

void ExportChoices::setChosen(std::vector<store::SherdRow> sherds) {
  if (selection_.what == What::Chosen && sherds == selection_.chosen) return;
  selection_.what = What::Chosen;
  selection_.chosen = std::move(sherds);
  emit contentChanged();
}

void ExportChoices::offerChosen(std::vector<store::SherdRow> sherds) {
  if (sherds == selection_.chosen) return;
  selection_.chosen = std::move(sherds);
  if (selection_.what == What::Chosen)
    emit contentChanged();
  else
    emit offerChanged();
}

void ExportChoices::setForm(exchange::Form form, bool wanted) {
  if (wanted)
    forms_.insert(form);
  else
    forms_.erase(form);
  keepChoices();
  emit contentChanged();
}

void ExportChoices::setDrawingScale(std::optional<double> scale) {
  drawing_scale_ = scale;
  keepChoices();
  emit contentChanged();
}

void ExportChoices::setMostModelBytes(std::size_t bytes) {
  most_model_bytes_ = bytes;
  keepChoices();
  emit contentChanged();
}

void ExportChoices::setTarget(const QString& folder) {
  target_ = folder.trimmed();
  emit targetChanged();
}

void ExportChoices::takeFreeTarget() {
  target_ = freeName(target_);
}

void ExportChoices::keepTarget() {
  parent_ = QFileInfo(target_).absolutePath();
  keepChoices();
}

}  // namespace ostraka::ui
