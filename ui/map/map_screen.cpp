#include "ui/map/map_screen.h"

#include <QAction>
#include <QComboBox>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPrinter>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "catalogue/batches.h"
#include "ui/frame/no_batch_yet.h"
#include "ui/frame/project_session.h"
#include "ui/jobs/when_done.h"
#include "ui/map/asked_print.h"
#include "ui/map/catalogue_labels.h"
#include "ui/map/map_view.h"
#include "ui/widgets/big_button.h"
#include "ui/widgets/page_acts.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/thumbnails.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

namespace fs = std::filesystem;

Result<MapPicture> readMap(const fs::path& output, const std::stop_token& stop) {
  // Its scans may be new already, and neither its pairs nor the catalogue.
  if (const Result<void> whole = review::computedToItsEnd(output); !whole) return whole.error();
  const auto live = review::LivePairs::open(output);
  if (!live) return live.error();
  const Result<decisions::Decisions> decisions = decisions::readDecisions(output);
  if (!decisions) return decisions.error();
  if (stop.stop_requested()) return Error::cancelled();
  Result<review::PlateMap> map = review::plateMap(**live, decisions::standing(*decisions));
  if (!map) return map.error();
  MapPicture picture{std::move(*map), {}, {}};
  if (stop.stop_requested()) return Error::cancelled();
  picture.front = readWhole(QString::fromStdString(picture.map.front.photograph.string()));
  picture.back = readWhole(QString::fromStdString(picture.map.back.photograph.string()));
  return picture;
}

QString dayText(const QDateTime& moment) {
  return QLocale::c().toString(moment.date(), "yyyy-MM-dd");
}

}  // namespace

MapScreen::MapScreen(QWidget* parent) : PlateScreen(tr("Map"), QStringLiteral("map"), parent) {
  connect(addPageAct(this, "print", {}, tr("Print map and labels"), QKeySequence::Print),
          &QAction::triggered, this, &MapScreen::print);
  print_ = new BigButton("printMap", tr("Print map and labels"), this);
  print_->setKeyHint(QKeySequence(QKeySequence::Print).toString(QKeySequence::NativeText));
  print_->setFocusPolicy(Qt::TabFocus);
  print_->setEnabled(false);
  connect(print_, &QPushButton::clicked, this, &MapScreen::print);
  connect(
      addPageAct(this, "printBags", {}, tr("Print bag labels"), Qt::CTRL | Qt::SHIFT | Qt::Key_P),
      &QAction::triggered, this, &MapScreen::printBags);
  bags_ = iconButton(this, {}, "print", tr("Print bag labels"), this, &MapScreen::printBags);
  bags_->setToolTip(
      tr("Print a label for each bag; its code gives a batch its context "
         "(Ctrl+Shift+P)"));
  bags_->setFocusPolicy(Qt::TabFocus);
  bags_->setEnabled(false);
  view_ = named<MapView>("plate", this);
  auto* head = filled(new QHBoxLayout, {batches_, {message_, 1}});
  auto* foot = filled(new QHBoxLayout, {Part::room(), bags_, print_});
  empty_ = new NoBatchYet(QStringLiteral("map"), tr("No map yet"),
                          tr("The map of a batch appears here once it is processed, and shows "
                             "which sherd lay where."),
                          this);
  filled(pageColumn(this), {head, {view_, 1}, {empty_, 1}, foot});
  setFocusProxy(view_);
  connect(view_, &MapView::highlightedChanged, this, [this](const QString& number) {
    const MapNumbers& numbers = view_->picture().numbers;
    if (!number.isEmpty()) say(tr("Sherd %1").arg(numbers.whole(number)));
  });
  connect(view_, &MapView::activated, this,
          [this](const QString&) { emit wantsScreen(QStringLiteral("review"), batch_); });
}

void MapScreen::openProject(ProjectSession& session) {
  closeProject();
  session_ = &session;
  connect(&session, &ProjectSession::batchChanged, this, [this](const QString& batch) {
    if (batches_->findText(batch) < 0) listBatches();
    if (batches_->findText(batch) < 0) return;
    if (batch_.isEmpty() || batch == batch_) showBatch(batch);
  });
  connect(&session, &ProjectSession::sherdsChanged, this, &MapScreen::nameMarks);
  bags_->setEnabled(session.hasProject());
  listBatches();
  if (batches_->count() > 0) showBatch(batches_->itemText(0));
}

void MapScreen::closeProject() {
  if (opening_) opening_->drop();
  if (session_) disconnect(session_, nullptr, this, nullptr);
  session_.clear();
  batch_.clear();
  stale_.clear();
  batches_->clear();
  message_->clear();
  view_->setPicture({});
  print_->setEnabled(false);
  bags_->setEnabled(false);
}

QAbstractButton* MapScreen::primary() const {
  return empty_->isHidden() ? static_cast<QAbstractButton*>(print_) : empty_->act();
}

void MapScreen::setInFront(bool in_front) {
  if (in_front) view_->setFocus();
}

void MapScreen::listBatches() {
  if (!session_) return;
  const QStringList names = reviewable();
  batches_->clear();
  batches_->addItems(names);
  batches_->setCurrentText(batch_);
  if (names.isEmpty()) empty_->follow(session_);
  empty_->setVisible(names.isEmpty());
  for (QWidget* part : std::initializer_list<QWidget*>{batches_, view_, print_})
    part->setVisible(!names.isEmpty());
}

// Two photographs are read, and an outline for each sherd: not while nobody looks.
void MapScreen::showBatch(const QString& batch) {
  if (isVisible()) return openBatch(batch);
  batch_ = stale_ = batch;
  emit whereChanged();
  batches_->setCurrentText(batch);
}

void MapScreen::showEvent(QShowEvent* event) {
  Screen::showEvent(event);
  if (!stale_.isEmpty()) openBatch(std::exchange(stale_, {}));
}

void MapScreen::showItem(const QString& batch) {
  if (session_) openBatch(batch);
}

void MapScreen::openBatch(const QString& batch) {
  if (!session_ || batch.isEmpty()) return;
  const QString lit = batch == batch_ ? view_->highlighted() : QString();
  if (batch != batch_) view_->setPicture({});
  batch_ = batch;
  emit whereChanged();
  stale_.clear();
  batches_->setCurrentText(batch);
  message_->clear();
  allowPrint(tr("The map is still loading."));  // what is shown is about to be another
  view_->setLoading(true);
  if (opening_) opening_->drop();
  opening_ =
      session_->jobs().start(makeJob([output = outputOf(batch)](Progress&, std::stop_token stop) {
                               return readMap(output, stop);
                             }),
                             this);
  whenDone<MapPicture>(opening_, this, [this, lit](const auto& picture) {
    view_->setLoading(false);
    allowPrint(picture ? QString() : sentenceOf(picture.error()));
    if (!picture) {
      view_->setPicture({});
      // Said on this page alone, as that of a batch that is not computed yet.
      if (picture.error().code == ErrorCode::Missing && isOfScans())
        return message_->setText(
            tr("This batch was scanned, not photographed: there is no picture of its plate."));
      return say(sentenceOf(picture.error()));
    }
    date_ = dayOf(*picture);
    view_->setPicture(*picture);
    nameMarks();
    view_->highlight(lit);
  });
}

void MapScreen::allowPrint(const QString& why_not) {
  print_->setEnabled(why_not.isEmpty());
  print_->setToolTip(why_not);
}

bool MapScreen::isOfScans() const {
  const QDir front(QString::fromStdString(
      (session_->folder() / "batches" / batch_.toStdString() / "front").string()));
  return !front.entryList({QStringLiteral("*.ply")}, QDir::Files).isEmpty();
}

// The day of the shooting, if the catalogue knows it; where there is no catalogue the file says it.
QString MapScreen::dayOf(const MapPicture& picture) const {
  if (session_->hasProject())
    if (const auto batch =
            catalogue::Batches(session_->project().catalogue()).byNumber(batch_.toStdString()))
      return batch->started_ms ? dayText(QDateTime::fromMSecsSinceEpoch(*batch->started_ms))
                               : QString();
  const QFileInfo file(QString::fromStdString(picture.map.front.photograph.string()));
  return file.exists() ? dayText(file.lastModified()) : QString();
}

void MapScreen::nameMarks() {
  view_->setNumbers(mapNumbers(sherds()));
}

QVector<PlateSherd> MapScreen::sherds() const {
  const bool has_catalogue = session_ && session_->hasProject();
  return sherdsOnPlate(view_->picture().map,
                       has_catalogue ? &session_->project().catalogue() : nullptr, batch_, date_);
}

QVector<SherdLabel> MapScreen::labels() const {
  return labelsOf(sherds());
}

QString MapScreen::pageTitle() const {
  const QString common = view_->picture().numbers.common;
  const QString batch = common.isEmpty() ? batch_ : QStringLiteral("%1: %2…").arg(batch_, common);
  return date_.isEmpty() ? tr("Batch %1").arg(batch) : tr("Batch %1, %2").arg(batch, date_);
}

// Such labels are for the table, not for the bag: in the store nobody knows their batch.
QString MapScreen::unnumberedWords() const {
  const QVector<PlateSherd> all = sherds();
  const auto none = static_cast<int>(std::ranges::count_if(
      all, [](const auto& sherd) { return sherd.getsLabel() && !sherd.has_final_number; }));
  return none > 0 ? tr("%n sherd(s) of this batch have no number yet: their labels name the batch.",
                       nullptr, none)
                  : QString();
}

void MapScreen::print() {
  if (!print_->isEnabled()) return;
  if (const QString none = unnumberedWords(); !none.isEmpty()) say(none);
  askToPrint(
      this, tr("%1 map and labels").arg(batch_), tr("Map and labels are sent to the printer."),
      [this](QPrinter& printer, QString* why) {
        return printMap(printer, view_->picture(), labels(), pageTitle(), why);
      },
      [this](const QString& sentence) { say(sentence); });
}

void MapScreen::printBags() {
  if (!bags_->isEnabled()) return;
  const QVector<SherdLabel> labels =
      bagLabels(session_->project().catalogue(), session_->initials());
  if (labels.isEmpty())
    return say(tr("There is no bag yet: type one at the capture, or import a table of contexts."));
  askToPrint(
      this, tr("bag labels"),
      tr("%n label(s) are sent to the printer.", nullptr, static_cast<int>(labels.size())),
      [labels](QPrinter& printer, QString* why) { return printLabels(printer, labels, why); },
      [this](const QString& sentence) { say(sentence); });
}

}  // namespace ostraka::ui
