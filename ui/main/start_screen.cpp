#include "ui/main/start_screen.h"

#include <QAction>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QStandardPaths>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

#include "ui/export/project_restoring.h"
#include "ui/frame/batch_place.h"
#include "ui/frame/lines.h"
#include "ui/import/path_drop.h"
#include "ui/import/print_sheet_button.h"
#include "ui/look/look.h"
#include "ui/look/style.h"
#include "ui/widgets/big_button.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/message_panel.h"
#include "ui/widgets/page_acts.h"
#include "ui/widgets/page_area.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/thumbnails.h"
#include "upkeep/archived_project.h"

namespace ostraka::ui {
namespace {

// The first sherd's preview of the newest results, else the first photograph.
QString pictureOf(const QString& folder) {
  const QDir results(folder + QStringLiteral("/results"));
  const QStringList batches =
      results.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name | QDir::Reversed);
  for (const QString& batch : batches) {
    const QString preview = results.filePath(batch + QStringLiteral("/sherds/01/preview.png"));
    if (QFileInfo::exists(preview)) return preview;
  }
  const QDir photographs(folder + QStringLiteral("/batches"));
  for (const QString& batch : photographs.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    const QString first = frontPicture(photographs.filePath(batch).toStdString());
    if (!first.isEmpty()) return first;
  }
  return {};
}

bool isThere(const QString& folder) {
  return QFileInfo::exists(folder + QStringLiteral("/catalogue.sqlite"));
}

// As people write it: ~ for their own home.
QString shortPath(const QString& folder) {
  const QString home = QDir::homePath() + QLatin1Char('/');
  return QDir::toNativeSeparators(
      folder.startsWith(home) ? QStringLiteral("~/") + folder.mid(home.size()) : folder);
}

}  // namespace

StartScreen::StartScreen(Thumbnails* thumbnails, QWidget* parent)
    : QWidget(parent),
      thumbnails_(thumbnails),
      fresh_(new NewProject(this)),
      message_(new MessagePanel(QStringLiteral("startMessage"), this)) {
  setObjectName(QStringLiteral("start"));
  auto* title = new QLabel(tr("Ostraka"), this);
  title->setFont(scaledFont(*this, Look::kDecides, true));
  auto* words = new QLabel(tr("Potsherds, both sides, complete and measured."), this);
  words->setForegroundRole(kSecondaryText);
  auto* columns = filled(new QHBoxLayout, {{buildRecent(), 1}});
  columns->addSpacing(Look::kMargin - Look::kGap);
  columns->addWidget(buildNew(), 1);
  connect(message_, &MessagePanel::acted, this, &StartScreen::act);
  // The language, too, is chosen there.
  QPushButton* settings = iconButton(this, "startSettings", "settings", tr("Settings"), this,
                                     &StartScreen::settingsWanted);
  QPushButton* help =
      iconButton(this, "startHelp", "help", tr("Help"), this, &StartScreen::manualWanted);
  auto* head = filled(new QHBoxLayout, {title, Part::room(), settings, help});
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(Look::kMargin, Look::kGap, Look::kMargin, Look::kGap);
  filled(all, {head, words, message_, {columns, 1}});
  connect(fresh_, &NewProject::changed, this, &StartScreen::follow);
  setAcceptDrops(true);
  connect(new PathDrop(this), &PathDrop::dropped, this, &StartScreen::photographsChosen);
  follow();
}

QWidget* StartScreen::buildRecent() {
  auto* box = new QWidget(this);
  auto* label = new QLabel(tr("&Projects"), box);
  label->setFont(scaledFont(*this, Look::kSection, true));
  recent_ = named<QListWidget>({"recentProjects", tr("Projects")}, box);
  label->setBuddy(recent_);
  const int line = fontMetrics().height();
  recent_->setIconSize(QSize(line * 4, line * 3));
  no_recent_ =
      new QLabel(tr("No project yet. Import photographs of both sides of your sherds, or drop "
                    "their folders here: a project is created for them. To practise, try the "
                    "virtual rig: it breaks a pot and photographs its sherds for you."),
                 box);
  no_recent_->setWordWrap(true);
  no_recent_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  open_ = new BigButton(QStringLiteral("openChosen"), tr("Open project"), box);
  open_->setKeyHint(tr("Enter"));
  connect(open_, &QPushButton::clicked, this, &StartScreen::openChosen);
  connect(recent_, &QListWidget::currentRowChanged, this, &StartScreen::follow);
  QPushButton* open = iconButton(box, "openProject", "open", tr("&Open from folder…"), this,
                                 &StartScreen::chooseProject);
  QPushButton* restore = iconButton(box, "restoreArchive", "folder", tr("&Restore an archive…"),
                                    this, &StartScreen::chooseArchive);
  photographs_ = new BigButton(QStringLiteral("startPhotographs"), tr("Import photographs…"), box);
  photographs_->setToolTip(tr("Creates a project named after their folder"));
  QPushButton* virtual_rig =
      iconButton(box, "tryVirtualRig", "turntable", tr("Try with the virtual rig"), this,
                 &StartScreen::virtualRigWanted);
  connect(recent_, &QListWidget::itemActivated, this, &StartScreen::openChosen);
  connect(photographs_, &QPushButton::clicked, this, &StartScreen::choosePhotographs);
  connect(thumbnails_, &Thumbnails::ready, this, [this] {
    for (int i = 0; i < recent_->count(); ++i)
      if (QListWidgetItem* item = recent_->item(i); item->icon().isNull())
        item->setIcon(thumbnails_->get(item->data(Qt::UserRole + 1).toString(),
                                       recent_->iconSize() * devicePixelRatioF()));
  });
  auto* print = new PrintSheetButton(QStringLiteral("startPrintSheet"), box);
  connect(print, &PrintSheetButton::failed, this, &StartScreen::showError);
  connect(print, &PrintSheetButton::printed, this,
          [this](const QString& headline, const QString& words) {
            tell(State::Sure, headline, words, {});
          });
  auto* opening = filled(new QHBoxLayout, {{open_, 1}, {open, 1}});
  filled(
      bareLayout<QVBoxLayout>(box),
      {label, {recent_, 1}, {no_recent_, 1}, opening, restore, photographs_, virtual_rig, print});
  return box;
}

QWidget* StartScreen::buildNew() {
  auto* box = new QGroupBox(tr("New project"), this);
  const auto field = [box](const char* name) {
    auto* edit = named<QLineEdit>(name, box);
    edit->setAcceptDrops(false);  // a folder is dropped onto the page
    return edit;
  };
  name_ = field("newName");
  site_ = field("newSite");
  folder_ = field("newFolder");
  numbering_ = field("newNumbering");
  name_->setPlaceholderText(tr("Aragats 2026"));
  site_->setPlaceholderText(QStringLiteral("ARM1"));
  showNumbering();
  auto* browse = named<QToolButton>({"newBrowse", tr("Choose the folder")}, box);
  browse->setText(tr("Choose…"));
  example_ = named<QLabel>("newExample", box);
  example_->setFont(scaledFont(*this, Look::kSection));
  refusal_ = wrappedLabel(box, QStringLiteral("newRefusal"));
  make_ = new BigButton(QStringLiteral("makeProject"), tr("Create project"), box);
  auto* place = filled(new QHBoxLayout, {{folder_, 1}, browse});
  auto* fields = new QWidget(box);
  auto* form = bareLayout<QFormLayout>(fields);
  form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  form->addRow(tr("&Name"), name_);
  form->addRow(tr("&Site code"), site_);
  form->addRow(tr("&Folder"), place);
  if (auto* label = qobject_cast<QLabel*>(form->labelForField(place))) label->setBuddy(folder_);
  folder_->setAccessibleName(tr("Folder"));
  form->addRow(tr("N&umbering"), numbering_);
  form->addRow(tr("Example"), example_);
  alignForm(*form);
  filled(new QVBoxLayout(box), {{new PageArea(fields, box), 1}, refusal_, make_});
  setTabOrder(folder_, browse);
  setTabOrder(browse, numbering_);
  connect(name_, &QLineEdit::textEdited, fresh_, &NewProject::setName);
  connect(site_, &QLineEdit::textEdited, fresh_, &NewProject::setSiteCode);
  connect(folder_, &QLineEdit::textEdited, fresh_, &NewProject::setFolder);
  connect(numbering_, &QLineEdit::textEdited, fresh_, &NewProject::setNumbering);
  connect(browse, &QToolButton::clicked, this, &StartScreen::chooseFolder);
  connect(make_, &QPushButton::clicked, this, &StartScreen::make);
  return box;
}

// From its beginning, also where it is longer than the field.
void StartScreen::showNumbering() {
  numbering_->setText(fresh_->numbering());
  numbering_->setCursorPosition(0);
}

void StartScreen::setRecent(const QStringList& folders,
                            const QMap<QString, RecentProject>& projects) {
  recent_->clear();
  for (const QString& folder : folders) {
    const QFileInfo catalogue(folder + QStringLiteral("/catalogue.sqlite"));
    const RecentProject known = projects.value(folder, {QDir(folder).dirName(), 0});
    QString words = tr("%1\n%2 is not there: find it…").arg(known.title, shortPath(folder));
    if (isThere(folder))
      words = tr("%1\n%2, %3")
                  .arg(known.title, shortPath(folder), momentWords(catalogue.lastModified()));
    if (isThere(folder) && known.unfinished > 0)
      words = tr("%1; %n batch(es) unfinished", nullptr, known.unfinished).arg(words);
    auto* item = new QListWidgetItem(words, recent_);
    // Moved, or on a disk that is unplugged: it comes back with it.
    if (!isThere(folder))
      item->setForeground(palette().color(QPalette::Disabled, QPalette::WindowText));
    const QString picture = pictureOf(folder);
    item->setSizeHint(QSize(0, targetSize(*this) + fontMetrics().height()));
    item->setData(Qt::UserRole, folder);
    item->setData(Qt::UserRole + 1, picture);
    const QPixmap ready = thumbnails_->get(picture, recent_->iconSize() * devicePixelRatioF());
    if (!ready.isNull()) item->setIcon(ready);
  }
  follow();
  recent_->setVisible(recent_->count() > 0);
  no_recent_->setVisible(recent_->count() == 0);
  if (recent_->count() > 0) recent_->setCurrentRow(0);
  // By keyboard alone: what most come for is one key away.
  recent_->count() > 0 ? recent_->setFocus() : photographs_->setFocus();
}

void StartScreen::openChosen() {
  const QListWidgetItem* item = recent_->currentItem();
  if (item == nullptr) return;
  const QString folder = item->data(Qt::UserRole).toString();
  isThere(folder) ? emit opened(folder) : findLost(folder);
}

void StartScreen::showError(const Error& error) {
  const QString where = QString::fromStdString(error.where);
  const QString archive =
      where.isEmpty() ? QString() : QString::fromStdString(upkeep::archiveAt(error.where).string());
  then_ = nullptr;
  if (error.code == ErrorCode::Damaged)
    then_ = [this, folder = QFileInfo(where).absolutePath()] { emit repairWanted(folder); };
  else if (!archive.isEmpty())
    then_ = [this, archive] { choosePlaceFor(archive); };
  message_->showError(error, error.code == ErrorCode::Damaged ? tr("Repair the catalogue")
                             : archive.isEmpty()              ? tr("OK")
                                                              : tr("Restore…"));
}

void StartScreen::tell(State state, const QString& headline, const QString& words,
                       const QString& project) {
  then_ = nullptr;
  if (!project.isEmpty()) then_ = [this, project] { emit opened(project); };
  message_->showWords(state, headline, words,
                      project.isEmpty() ? tr("OK") : tr("Open the project"));
}

void StartScreen::showRestoring(const QString& folder, const QString& words) {
  then_ = [this] { emit restoreCancelled(); };
  message_->showWords(State::Busy, tr("Restoring the project to %1").arg(shortPath(folder)), words,
                      tr("Cancel"));
}

void StartScreen::act() {
  message_->hide();
  if (const auto then = std::exchange(then_, nullptr)) then();
}

void StartScreen::follow() {
  if (folder_->text() != fresh_->folder()) folder_->setText(fresh_->folder());
  example_->setText(fresh_->example());
  const bool untouched = fresh_->siteCode().isEmpty() && fresh_->name().isEmpty();
  refusal_->setText(untouched ? QString() : fresh_->refusal());
  make_->setEnabled(fresh_->canBeMade());
  // One of them is the next step.
  make_->setPrimary(fresh_->canBeMade());
  open_->setVisible(recent_->count() > 0);
  open_->setEnabled(recent_->currentRow() >= 0);
  open_->setPrimary(!fresh_->canBeMade());
  photographs_->setPrimary(!fresh_->canBeMade() && recent_->count() == 0);
}

void StartScreen::chooseFolder() {
  connect(askForFile(this, tr("Folder of the new project"), projectsFolder(), {}),
          &QFileDialog::fileSelected, fresh_, &NewProject::setFolder);
}

void StartScreen::choosePhotographs() {
  QFileDialog* dialog = askForFile(
      this, tr("Folder of the photographs: both sides, or a folder for each side within it"),
      QStandardPaths::writableLocation(QStandardPaths::PicturesLocation), {});
  connect(dialog, &QFileDialog::fileSelected, this,
          [this](const QString& folder) { emit photographsChosen({folder}); });
}

void StartScreen::chooseProject() {
  connect(askForFile(this, tr("Folder of a project"), projectsFolder(), {}),
          &QFileDialog::fileSelected, this, &StartScreen::opened);
}

void StartScreen::chooseArchive() {
  connect(askForFile(this, tr("Folder of the archive"), QDir::homePath(), {}),
          &QFileDialog::fileSelected, this, &StartScreen::choosePlaceFor);
}

void StartScreen::choosePlaceFor(const QString& archive) {
  QFileDialog* dialog =
      askForFile(this, tr("Where to put the project: an empty folder, or one for a new folder"),
                 projectsFolder(), {});
  dialog->setObjectName(QStringLiteral("restoreTo"));
  connect(dialog, &QFileDialog::fileSelected, this, [this, archive](const QString& folder) {
    emit restoreWanted(archive, ProjectRestoring::placeIn(folder, archive));
  });
}

void StartScreen::findLost(const QString& folder) {
  QFileDialog* dialog = askForFile(this, tr("Where is %1 now?").arg(shortPath(folder)),
                                   QFileInfo(folder).absolutePath(), {});
  dialog->setObjectName(QStringLiteral("findProject"));
  connect(dialog, &QFileDialog::fileSelected, this,
          [this, folder](const QString& now) { emit found(folder, now); });
}

void StartScreen::makeFor(const QStringList& photographs) {
  fresh_->proposeFor(photographs);
  name_->setText(fresh_->name());
  site_->setText(fresh_->siteCode());
  if (fresh_->canBeMade()) return make();
  showError(Error::unusable(fresh_->refusal().toStdString(), fresh_->folder().toStdString()));
}

void StartScreen::make() {
  auto project = fresh_->make();
  if (!project) return showError(project.error());
  // The next one has another name.
  name_->clear();
  site_->clear();
  fresh_->clear();
  showNumbering();
  emit made(*project);
}

}  // namespace ostraka::ui
