#include "ui/capture/capture_screen.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "batch/batch.h"
#include "catalogue/typed_place.h"
#include "ui/capture/capture_foot.h"
#include "ui/capture/count_edit.h"
#include "ui/capture/fact_list.h"
#include "ui/capture/number_edit.h"
#include "ui/capture/plate_view.h"
#include "ui/capture/rig_page.h"
#include "ui/capture/stop_board.h"
#include "ui/frame/project_session.h"
#include "ui/import/batch_importer.h"
#include "ui/import/import_ask.h"
#include "ui/import/import_chooser.h"
#include "ui/import/import_line.h"
#include "ui/import/place_edit.h"
#include "ui/import/sides_view.h"
#include "ui/look/look.h"
#include "ui/widgets/big_button.h"
#include "ui/widgets/message_panel.h"
#include "ui/widgets/page_acts.h"
#include "ui/widgets/page_area.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/thumbnails.h"
#include "ui/wizard/batch_description.h"
#include "ui/wizard/capture_wizard.h"
#include "ui/wizard/plate_pictures.h"
#include "ui/wizard/rig_connection.h"
#include "ui/wizard/rig_renewal.h"
#include "ui/wizard/sherd_numbers.h"
#include "ui/wizard/side_progress.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

constexpr int kMostCameras = 3;
constexpr qsizetype kNumbersNamed = 4;
constexpr double kFromAfar = 3;  // of the body's letters

}  // namespace

CaptureScreen::CaptureScreen(CaptureWizard* wizard, QWidget* parent)
    : Screen(tr("Capture"), QStringLiteral("capture"), parent),
      wizard_(wizard),
      text_(*wizard),
      importer_(new BatchImporter(this)),
      renewal_(new RigRenewal(this)),
      rig_page_(new RigPage(this)) {
  setObjectName(QStringLiteral("capture"));
  setFocusPolicy(Qt::ClickFocus);  // so that its keys work wherever a person clicked
  setAccessibleName(tr("Capture"));
  buildActions();
  work_page_ = buildWorkPage();
  QVBoxLayout* all = filled(pageColumn(this), {rig_page_, work_page_});
  failure_ = new MessagePanel(QStringLiteral("captureFailure"), this);
  connect(failure_, &MessagePanel::acted, this, [this] {
    failure_->hide();
    setFocus();
  });
  failure_->setBesidePrimary();
  buildTwice();
  twice_->setBesidePrimary();
  buildImport(all);
  filled(all, {twice_, failure_});

  connect(wizard_, &CaptureWizard::changed, this, &CaptureScreen::follow);
  connect(wizard_->pictures(), &PlatePictures::changed, this, &CaptureScreen::followLive);
  connect(wizard_->side(), &SideProgress::changed, board_, &StopBoard::follow);
  connect(wizard_->side(), &SideProgress::preparing, board_, &StopBoard::follow);
  connect(wizard_->side(), &SideProgress::changed, this, &CaptureScreen::tellWork);
  connect(wizard_->side(), &SideProgress::said, this, &Screen::said);
  connect(wizard_->description(), &BatchDescription::said, this, &Screen::said);
  connect(wizard_, &CaptureWizard::said, this, &Screen::said);
  connect(wizard_, &CaptureWizard::batchQueued, this,
          [this](const QString& number) { emit said(tr("%1 is in the queue.").arg(number)); });
  connect(wizard_, &CaptureWizard::batchSetAside, this, &CaptureScreen::batchSetAside);
  connect(wizard_->rig(), &RigConnection::tried, this, &CaptureScreen::followRig);
  connect(rig_page_, &RigPage::kept, wizard_->rig(), &RigConnection::restore);
  connect(rig_page_, &RigPage::left, this, &CaptureScreen::leaveRig);
  connect(rig_page_, &RigPage::chosen, this, &CaptureScreen::chooseRig);
  connect(rig_page_, &RigPage::importPhotographs, import_photographs_, &QAction::trigger);
  connect(rig_page_, &RigPage::importScans, import_scans_, &QAction::trigger);
  connect(importer_, &BatchImporter::imported, this, &CaptureScreen::showImported);
  connect(importer_, &BatchImporter::failed, this, [this](const Error& error) {
    if (error.code != ErrorCode::Cancelled && !import_ask_->isAsking()) import_ask_->askAgain();
    showFailure(error);
  });
  connect(renewal_, &RigRenewal::failed, this, &CaptureScreen::showFailure);
  connect(renewal_, &RigRenewal::renewed, this, [this](const QString& batch, const QString& kept) {
    chooseRig(rigChoice());  // its age is new
    emit rigRenewed(batch);
    emit said(
        tr("The rig is calibrated by %1; the calibration before is kept as %2.").arg(batch, kept));
  });
  follow();
}

void CaptureScreen::buildImport(QVBoxLayout* all) {
  import_ask_ = new ImportAsk(this);
  chooser_ = new ImportChooser(this, import_ask_);
  connect(chooser_, &ImportChooser::failed, this, &CaptureScreen::showFailure);
  // What was said of one import does not stand under the next.
  connect(chooser_, &ImportChooser::failed, twice_, &QWidget::hide);
  for (QWidget* said_before : {failure_, twice_}) {
    connect(import_ask_, &ImportAsk::asked, said_before, &QWidget::hide);
    connect(import_ask_, &ImportAsk::left, said_before, &QWidget::hide);
    connect(importer_, &BatchImporter::started, said_before, &QWidget::hide);
  }
  connect(import_photographs_, &QAction::triggered, this,
          [this] { chooser_->choose(ImportKind::Photographs); });
  connect(import_scans_, &QAction::triggered, this,
          [this] { chooser_->choose(ImportKind::Scans); });
  connect(import_ask_, &ImportAsk::confirmed, importer_, &BatchImporter::start);
  connect(import_ask_, &ImportAsk::confirmed, this, qOverload<>(&QWidget::setFocus));
  connect(import_ask_, &ImportAsk::left, this, qOverload<>(&QWidget::setFocus));
  connect(import_ask_, &ImportAsk::asked, this, &CaptureScreen::follow);
  connect(import_ask_, &ImportAsk::confirmed, this, &CaptureScreen::follow);
  connect(import_ask_, &ImportAsk::left, this, &CaptureScreen::follow);
  connect(import_ask_, &ImportAsk::left, this, &CaptureScreen::importLeft);
  connect(import_ask_, &ImportAsk::placeEdited, this, &CaptureScreen::lineChanged);
  connect(importer_, &BatchImporter::started, this, &CaptureScreen::follow);
  connect(importer_, &BatchImporter::progressed, this, &CaptureScreen::tellWork);
  connect(importer_, &BatchImporter::ended, this, &CaptureScreen::follow);
  filled(all, {import_ask_, new ImportLine(importer_, this)});
}

void CaptureScreen::buildActions() {
  next_ = addPageAct(this, "captureNext", "next", tr("Next step"), Qt::Key_Space, this,
                     &CaptureScreen::goOn);
  next_->setAutoRepeat(false);  // a key that is held does one thing
  stop_ = addPageAct(this, "captureStop", "stop", tr("Stop turntable"), Qt::Key_Escape, wizard_,
                     &CaptureWizard::stop);
  stop_->setIconText(tr("Stop"));  // in sight in every language
  again_ =
      addPageAct(this, "captureAgain", "again", tr("Photograph again"), Qt::Key_R, this, [this] {
        if (namesABag()) wizard_->again();
      });
  again_->setAutoRepeat(false);
  keep_ = addPageAct(this, "keepPhotographs", {}, tr("Keep the photographs"), Qt::Key_Escape,
                     wizard_, &CaptureWizard::keepPhotographs);
  number_ = addPageAct(this, "numberSherds", "label", tr("Type the sherds' numbers"), Qt::Key_N,
                       this, [this] { number_edit_->choose(number_edit_->sherd()); });
  count_sherds_ = addPageAct(this, "countSherds", "sherd", tr("Type how many sherds lie there"),
                             Qt::Key_S, this, [this] { foot_->count()->takeKeys(); });
  import_photographs_ =
      addPageAct(this, "importPhotographs", "import", tr("Import photographs…"), {});
  import_scans_ = addPageAct(this, "importScans", "import", tr("Import scans…"), {});
  change_rig_ = addPageAct(this, "changeRig", "turntable", tr("Change rig…"), {}, wizard_->rig(),
                           &RigConnection::clear);
  set_aside_ = addPageAct(this, "setBatchAside", "aside", tr("Set this batch aside"), {}, wizard_,
                          &CaptureWizard::setAside);
  for (int camera = 0; camera < kMostCameras; ++camera) {
    const QString letter = QString::fromStdString(batch::cameraLetter(camera));
    QAction* action = addPageAct(this, "camera" + letter, "camera", tr("Camera %1").arg(letter),
                                 QKeySequence(static_cast<Qt::Key>(Qt::Key_A + camera)), this,
                                 [this, camera] { wizard_->pictures()->setCamera(camera); });
    action->setIconText(letter);
    action->setCheckable(true);
    cameras_.push_back(action);
  }
}

void CaptureScreen::goOn() {
  if (!rig_page_->isHidden()) return rig_page_->goOn();
  if (number_edit_->isVisible() && !number_edit_->keepTyped()) return;
  if (namesABag()) wizard_->next();
}

// A word that names no bag would leave all its sherds without a context.
bool CaptureScreen::namesABag() {
  if (!wizard_->canDescribe() || place_->isUsable()) return true;
  place_->choose();
  emit said(tr("'%1' names no bag: write site-trench-context-bag, or empty the line to go on "
               "without one.")
                .arg(place_->text()));
  return false;
}

QWidget* CaptureScreen::buildWorkPage() {
  auto* page = new QWidget(this);
  headline_ = wrappedLabel(page, QStringLiteral("captureHeadline"));
  instruction_ = new QLabel(page);
  instruction_->setWordWrap(true);
  middle_ = new QStackedWidget(page);
  plate_ = new PlateView(middle_);
  board_ = new StopBoard(wizard_->rig(), wizard_->side(), middle_);
  middle_->addWidget(plate_);
  middle_->addWidget(board_);
  facts_ = new FactList(page);
  numbers_ = new SherdNumbers(this);
  number_edit_ = new NumberEdit(numbers_, page);
  number_edit_->hide();
  connect(plate_, &PlateView::sherdClicked, this, [this](int sherd) {
    if (number_edit_->isVisible()) number_edit_->choose(sherd);
  });
  connect(number_edit_, &NumberEdit::chosen, this, &CaptureScreen::followNumbers);
  connect(numbers_, &SherdNumbers::changed, this, &CaptureScreen::followNumbers);
  connect(number_edit_, &NumberEdit::finished, this, [this] {
    setFocus();
    followNumbers();
  });
  doubts_ = new MessagePanel(QStringLiteral("captureDoubts"), page);
  fault_ = new MessagePanel(QStringLiteral("captureFault"), page);
  connect(fault_, &MessagePanel::acted, this, [this] {
    if (wizard_->fault()) goOn();
  });
  connect(fault_, &MessagePanel::actedSecond, change_rig_, &QAction::trigger);
  connect(doubts_, &MessagePanel::acted, again_, &QAction::trigger);
  other_numbers_ = new MessagePanel(QStringLiteral("numbersOfAnotherBag"), page);
  connect(other_numbers_, &MessagePanel::acted, wizard_->description(),
          &BatchDescription::takeNumbersAsRight);
  for (MessagePanel* panel : {doubts_, other_numbers_}) panel->setBesidePrimary();
  connect(numbers_, &SherdNumbers::changed, this, &CaptureScreen::followBag);
  QWidget* foot = buildFoot();
  filled(bareLayout<QVBoxLayout>(page), {headline_,
                                         instruction_,
                                         {new PageArea(buildMiddle(page), page), 1},
                                         fault_,
                                         place_->note(),
                                         foot});
  return page;
}

// What is looked at; where it finds no room it is scrolled, and what decides is not.
QWidget* CaptureScreen::buildMiddle(QWidget* page) {
  auto* middle = new QWidget(page);
  auto* row = filled(new QHBoxLayout, {{middle_, 1}, facts_});
  filled(bareLayout<QVBoxLayout>(middle), {{row, 1}, number_edit_, doubts_, other_numbers_});
  return middle;
}

QWidget* CaptureScreen::buildFoot() {
  foot_ = new CaptureFoot(
      wizard_,
      {next_, stop_, cameras_, {import_photographs_, import_scans_, change_rig_, set_aside_}},
      this);
  place_ = foot_->place();
  connect(foot_, &CaptureFoot::entered, this, qOverload<>(&QWidget::setFocus));
  connect(place_, &PlaceEdit::edited, this, &CaptureScreen::placeTyped);
  connect(place_, &PlaceEdit::settled, wizard_, &CaptureWizard::keepDescribed);
  connect(wizard_->description(), &BatchDescription::placeRead, this, [this] {
    place_->setText(wizard_->description()->place().typed());
    placeTyped();
  });
  return foot_;
}

QString CaptureScreen::whereWords() const {
  return (import_ask_->isAsking() ? import_ask_->place()->place() : wizard_->description()->place())
      .words();
}

void CaptureScreen::openProject(ProjectSession& session) {
  session_ = &session;
  thumbnails_ = new Thumbnails(session.jobs(), this);
  board_->setThumbnails(thumbnails_);
  importer_->setSession(&session);
  chooser_->setSession(&session);
  import_ask_->sides()->setThumbnails(thumbnails_);
  wizard_->setSession(&session);
  for (PlaceEdit* edit : {place_, import_ask_->place()}) {
    edit->setReader([&session](const QString& text) {
      return findPlaceText(session.project().catalogue(), text);
    });
    edit->setSite(siteOf(session.project().catalogue()));
    edit->setNews(
        [&session](const PlaceText& place) { return newOf(session.project().catalogue(), place); });
  }
  place_->setText(session.setting(catalogue::kCapturePlace));
  placeTyped();
  connect(&session, &ProjectSession::vocabulariesChanged, this, [this, &session] {
    place_->setSite(siteOf(session.project().catalogue()));  // it may have another code
    const QString kept = session.setting(catalogue::kCapturePlace);
    if (!place_->isUsable() || kept == place_->text()) return;
    place_->setText(kept);
    placeTyped();
  });
  const RigChoice choice = rigChoice();
  rig_page_->setChoice(choice);
  if (choice.kind != RigChoice::Kind::None) chooseRig(choice);
  follow();
}

void CaptureScreen::closeProject() {
  if (session_ != nullptr && !number_edit_->isHidden()) number_edit_->keepTyped();
  wizard_->pictures()->setLive(false);
  wizard_->setSession(nullptr);
  importer_->setSession(nullptr);
  chooser_->setSession(nullptr);
  import_ask_->sides()->setThumbnails(nullptr);
  renewal_->forget();
  board_->setThumbnails(nullptr);
  if (import_ask_->isAsking()) import_ask_->leave();
  for (PlaceEdit* place : {place_, import_ask_->place()}) {
    place->setNews({});
    place->setReader({});
  }
  if (thumbnails_ != nullptr) thumbnails_->deleteLater();
  thumbnails_ = nullptr;
  failure_->hide();
  twice_->hide();
  session_ = nullptr;
}

void CaptureScreen::setInFront(bool in_front) {
  wizard_->pictures()->setLive(in_front);
  if (in_front) setFocus();
}

QAbstractButton* CaptureScreen::primary() const {
  if (import_ask_->isAsking()) return import_ask_->import();
  if (!rig_page_->isHidden()) return rig_page_->primary();
  return fault_->act() != nullptr ? fault_->act() : foot_->button();
}

void CaptureScreen::setCompact(bool compact) {
  compact_ = compact;
  foot_->setCompact(compact);
  for (MessagePanel* panel : {fault_, doubts_, other_numbers_, failure_, twice_})
    panel->setCompact(compact);
  follow();
}

void CaptureScreen::showFailure(const Error& error) {
  if (error.code == ErrorCode::Cancelled) {
    emit said(tr("Import cancelled. Nothing was left behind."));
    return emit importLeft();
  }
  failure_->showError(error, tr("OK"));
  emit said(sentenceOf(error));
}

void CaptureScreen::showImported(const QString& number, int files, const QStringList& doubts,
                                 const QString& note) {
  const QString words =
      tr("%1: %n file(s) imported; it is in the queue.", nullptr, files).arg(number);
  const QStringList more = note.isEmpty() ? doubts : QStringList(note) + doubts;
  if (!more.isEmpty())
    failure_->showWords(doubts.isEmpty() ? State::Sure : State::Ask, words,
                        more.join(QLatin1Char('\n')), tr("OK"));
  emit said(words);
  // Without a rig nothing is to be photographed meanwhile; what is to be read or typed here stays.
  if (isVisible() && !import_ask_->isAsking() && wizard_->phase() == CapturePhase::NoRig &&
      more.isEmpty())
    emit wantsScreen(QStringLiteral("queue"), number);
}

void CaptureScreen::placeTyped() {
  wizard_->description()->setPlace(place_->place());
  if (session_ != nullptr && place_->isUsable())
    session_->noteSetting(catalogue::kCapturePlace, place_->text());
  emit lineChanged();
}

void CaptureScreen::follow() {
  const CapturePhase phase = wizard_->phase();
  const bool no_rig = phase == CapturePhase::NoRig && !wizard_->fault();
  // While an import asks, it is the one thing to do: its bag, its button, and no key of the rig.
  const bool importing = import_ask_->isAsking();
  const bool rig_in_sight = !importing || wizard_->isShooting();
  rig_page_->setVisible(no_rig && rig_in_sight);
  rig_page_->setImporting(importer_->isBusy());
  rig_page_->setCanKeep(wizard_->rig()->canRestore());
  rig_page_->setCanLeave(no_rig && rigChoice().kind != RigChoice::Kind::None);
  work_page_->setVisible(!no_rig && rig_in_sight);
  const bool shooting = phase == CapturePhase::ShootFront || phase == CapturePhase::ShootBack;
  // What was photographed stays in sight when it is done.
  const bool board = shooting || (phase == CapturePhase::Done && !wizard_->side()->shots().empty());
  middle_->setCurrentWidget(board ? static_cast<QWidget*>(board_) : plate_);
  headline_->setText(text_.headline());
  headline_->setFont(scaledFont(*this, headlineSize(), true));
  instruction_->setText(text_.instruction());
  instruction_->setVisible(!compact_ && !instruction_->text().isEmpty());
  foot_->setVisible(rig_in_sight);
  foot_->follow();
  place_->setVisible(!importing);
  place_->follow();
  next_->setEnabled(!importing && (no_rig || wizard_->canGoOn()));
  stop_->setEnabled(wizard_->isShooting());
  keep_->setEnabled(wizard_->asksToRepeat());  // never while Esc stops
  change_rig_->setEnabled(!wizard_->isShooting());
  set_aside_->setEnabled(wizard_->canSetAside());
  again_->setEnabled(!importing && !wizard_->rig()->isBusy() &&
                     (phase == CapturePhase::Flip || phase == CapturePhase::Done));
  count_sherds_->setEnabled(wizard_->canDescribe());
  for (std::size_t i = 0; i < cameras_.size(); ++i) {
    cameras_[i]->setEnabled(static_cast<int>(i) < wizard_->rig()->cameras());
    cameras_[i]->setChecked(static_cast<int>(i) == wizard_->pictures()->camera());
  }
  showTrouble();
  followBag();
  followLive();
  tellWork();
  emit lineChanged();
}

// On whatever screen the person waits.
void CaptureScreen::tellWork() {
  const bool shooting = wizard_->isShooting(), importing = importer_->isBusy();
  if (!shooting && !importing && !working_) return;
  working_ = shooting || importing;
  if (!working_) return emit working({}, -1);
  if (!shooting)
    return emit working(
        tr("%1, %2 %").arg(importer_->title()).arg(static_cast<int>(100 * importer_->fraction())),
        importer_->fraction());
  const PreparedPhotographs steps = wizard_->side()->steps(wizard_->rig()->source().stops);
  emit working(QStringLiteral("%1: %2").arg(text_.headline(), text_.button()),
               static_cast<double>(steps.done) / std::max(1, steps.total));
}

// That the plate may be cleared is read from three metres.
double CaptureScreen::headlineSize() const {
  if (wizard_->phase() == CapturePhase::Done) return compact_ ? Look::kDecides : kFromAfar;
  return compact_ ? Look::kSection : Look::kTitle;
}

void CaptureScreen::followLive() {
  const CapturePhase phase = wizard_->phase();
  const bool front = phase == CapturePhase::Flip && wizard_->pictures()->front();
  plate_->setPicture(front ? wizard_->pictures()->front()
                     : (phase == CapturePhase::Place || phase == CapturePhase::Flip)
                         ? wizard_->pictures()->live()
                         : std::nullopt,
                     phase == CapturePhase::Done ? QString() : tr("Loading picture…"));
  facts_->setFacts(text_.facts());
  numbers_->follow(session_, wizard_->batch().number(),
                   front ? &wizard_->pictures()->front()->inspection : nullptr);
  const bool typing = front && numbers_->count() > 0;
  number_edit_->setVisible(typing);
  number_->setEnabled(typing);
  followNumbers();
}

void CaptureScreen::followNumbers() {
  plate_->setNumbers(numbers_->all(),
                     number_edit_->isVisible() && number_edit_->isAncestorOf(focusWidget())
                         ? number_edit_->sherd()
                         : -1);
}

// Their labels would carry one context, and the catalogue another.
void CaptureScreen::followBag() {
  const QStringList numbers = wizard_->batch().numbersOfAnotherBag();
  other_numbers_->setVisible(!numbers.isEmpty());
  if (numbers.isEmpty()) return;
  other_numbers_->showWords(State::Ask, tr("The bag is another now, the numbers are not"),
                            tr("Not as this bag's sherds are numbered: %1. Type them anew (N, or "
                               "later in the catalogue), "
                               "or say that they are right.")
                                .arg(firstOf(numbers, kNumbersNamed)),
                            tr("Keep these numbers"));
}

void CaptureScreen::showTrouble() {
  if (wizard_->fault()) {
    Error shown = *wizard_->fault();
    if (!wizard_->rig()->holders().isEmpty())
      shown.what =
          tr("%1 The desktop holds a camera, by its program %2.")
              .arg(wordsOf(shown.what), wizard_->rig()->holders().join(QStringLiteral(", ")))
              .toStdString();
    fault_->showError(shown, text_.button(), tr("Space"));
    fault_->setSecondAct(wizard_->phase() == CapturePhase::Opening ? change_rig_->text()
                                                                   : QString());
  } else {
    fault_->hide();
  }
  if (wizard_->doubts().isEmpty() || wizard_->fault())
    doubts_->hide();
  else
    doubts_->showWords(
        State::Ask,
        wizard_->asksToRepeat() ? tr("Photograph this side again?") : tr("Check this first"),
        wizard_->doubts().join(QLatin1Char('\n')), tr("Photograph again"), tr("R"));
}

}  // namespace ostraka::ui
