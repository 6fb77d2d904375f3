#include "ui/main/new_project.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStandardPaths>

#include "catalogue/places.h"
#include "catalogue/settings.h"
#include "catalogue/typed_place.h"
#include "records/numbering.h"
#include "ui/wizard/rig_source.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

constexpr qsizetype kLongestCode = 8;

const QRegularExpression& siteForm() {
  static const QRegularExpression form(QStringLiteral("^[A-Z0-9]{2,8}$"));
  return form;
}

// What tells the photographs of one place from another's: their folder, of both sides' the one
// above.
QString folderNameOf(const QStringList& photographs) {
  const QFileInfo first(QDir::cleanPath(photographs.front()));
  const QString name =
      photographs.size() == 1 && first.isDir() ? first.fileName() : first.dir().dirName();
  return name.isEmpty() || first.dir().isRoot() ? NewProject::tr("Photographs") : name;
}

QString asFolderName(QString name) {
  return name.replace(QRegularExpression(QStringLiteral("[/\\\\:*?\"<>|]+")), QStringLiteral("_"));
}

}  // namespace

QString projectsFolder() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::HomeLocation))
      .filePath(QStringLiteral("Ostraka"));
}

QString freshFolder(const QString& name) {
  const QDir place(projectsFolder());
  QString folder = place.filePath(asFolderName(name));
  for (int n = 2; QFileInfo::exists(folder); ++n)
    folder = place.filePath(QStringLiteral("%1 %2").arg(asFolderName(name)).arg(n));
  return folder;
}

NewProject::NewProject(QObject* parent) : QObject(parent) {
  clear();
}

void NewProject::clear() {
  name_.clear();
  site_.clear();
  folder_.clear();
  proposed_ = {};
  folder_typed_ = false;
  numbering_ = QString::fromStdString(records::ProjectRecord().numbering);
  follow();
}

void NewProject::proposeFor(const QStringList& photographs) {
  if (name_ == proposed_.name) name_.clear();
  if (site_ == proposed_.site) site_.clear();
  if (folder_ == proposed_.folder) folder_typed_ = false;
  proposed_ = {};
  const QString name = name_.isEmpty() ? folderNameOf(photographs) : name_;
  if (site_.isEmpty()) {
    site_ = name.normalized(QString::NormalizationForm_D).toUpper();
    site_.remove(QRegularExpression(QStringLiteral("[^A-Z0-9]")));
    site_.truncate(kLongestCode);
    if (!siteForm().match(site_).hasMatch()) site_ = QStringLiteral("SITE");
    proposed_.site = site_;
  }
  if (!folder_typed_) setFolder(proposed_.folder = freshFolder(name));
  if (name_.isEmpty()) name_ = proposed_.name = name;
  follow();
}

void NewProject::setName(const QString& name) {
  name_ = name.trimmed();
  follow();
}

void NewProject::setSiteCode(const QString& code) {
  site_ = code.trimmed().toUpper();
  follow();
}

void NewProject::setFolder(const QString& folder) {
  folder_typed_ = !folder.trimmed().isEmpty();
  folder_ = folder;  // as typed: a space at its end may be one within a name
  follow();
}

void NewProject::setNumbering(const QString& numbering) {
  numbering_ = numbering.trimmed();
  follow();
}

void NewProject::follow() {
  if (!folder_typed_) {
    const QString safe = asFolderName(name_.isEmpty() ? site_ : name_);
    folder_ = safe.isEmpty() ? QString() : QDir(projectsFolder()).filePath(safe);
  }
  example_.clear();
  numbering_refusal_.clear();
  const auto scheme = records::Numbering::parse(numbering_.toStdString());
  if (!scheme) {
    numbering_refusal_ = sentenceOf(scheme.error());
  } else {
    const std::string site = site_.isEmpty() ? "ARM1" : site_.toStdString();
    const auto number = scheme->number({{"site", site},
                                        {"trench", "T3"},
                                        {"context", "0012"},
                                        {"bag", "4"},
                                        {"batch", "B0031"},
                                        {"yyyy", "2026"},
                                        {"yy", "26"}},
                                       7);
    if (number)
      example_ = QString::fromStdString(*number);
    else
      numbering_refusal_ = sentenceOf(number.error());
  }
  emit changed();
}

QString NewProject::refusal() const {
  if (!siteForm().match(site_).hasMatch())
    return tr(
        "The site's code has two to eight letters from A to Z and digits, without accents, like "
        "ARM1.");
  if (!numbering_refusal_.isEmpty()) return numbering_refusal_;
  if (place().isEmpty()) return tr("Choose a folder for the project.");
  const QDir folder(place());
  if (upkeep::Project::isProject(place().toStdString()))
    return tr("There is a project in this folder already: open it, or choose another folder.");
  if (folder.exists() && !folder.isEmpty(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden))
    return tr("This folder holds other files: choose a new one.");
  return {};
}

Result<std::shared_ptr<upkeep::Project>> NewProject::make() const {
  records::ProjectRecord record;
  record.code = site_.toStdString();
  record.title = (name_.isEmpty() ? site_ : name_).toStdString();
  record.numbering = numbering_.toStdString();
  Result<upkeep::Project> made = upkeep::Project::create(place().toStdString(), record);
  if (!made) return made.error();
  records::SiteRecord site;
  site.code = record.code;
  site.name = record.title;
  if (const auto saved = catalogue::Places(made->catalogue()).save(site, {}); !saved)
    return saved.error();
  return std::make_shared<upkeep::Project>(std::move(*made));
}

Result<std::shared_ptr<upkeep::Project>> makeVirtualProject(const QString& folder) {
  NewProject fresh;
  fresh.setName(NewProject::tr("Virtual rig"));
  fresh.setSiteCode(QStringLiteral("VIRT"));
  fresh.setFolder(folder);
  if (!fresh.canBeMade())
    return Error{ErrorCode::UnusableInput, fresh.refusal().toStdString(), folder.toStdString()};
  auto made = fresh.make();
  if (!made) return made.error();
  RigChoice rig;
  rig.kind = RigChoice::Kind::Virtual;
  rig.sherds = 5;
  rig.width_px = 1000;
  catalogue::Catalogue& rows = (*made)->catalogue();
  if (const auto set = catalogue::Settings(rows).setValue("rig", rig.toJson().toStdString()); !set)
    return set.error();
  if (const auto set =
          catalogue::Settings(rows).setValue(catalogue::kCapturePlace, "VIRT-T1-0001-1");
      !set)
    return set.error();
  return made;
}

}  // namespace ostraka::ui
