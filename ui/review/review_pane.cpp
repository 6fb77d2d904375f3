#include "ui/review/review_pane.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/look/look.h"
#include "ui/pairs/free_words.h"
#include "ui/pairs/pair_review.h"
#include "ui/pairs/review_words.h"
#include "ui/review/candidate_bar.h"
#include "ui/review/card_list.h"
#include "ui/review/join_mode.h"
#include "ui/review/outline_plot.h"
#include "ui/review/picture_pair.h"
#include "ui/viewport/sherd_view.h"
#include "ui/widgets/big_button.h"
#include "ui/widgets/page_acts.h"
#include "ui/widgets/page_area.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/tool_row.h"

namespace ostraka::ui {
namespace {

// So long the pair before may be seen: at once would flicker where pictures come fast.
constexpr int kBlankAfter_ms = 150;
constexpr double kFractureScale_mm = 0.5;  // twice a good fracture's RMS has the full colour

}  // namespace

ReviewPane::ReviewPane(PairReview& review, QWidget* parent)
    : QWidget(parent), review_(review), hand_(review.hand()) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Pairs of the batch"));
  cards_ = named<CardList>({"cards", tr("Pairs, most doubtful first")}, review_.cards(), this);
  pictures_ = named<PicturePair>("pictures", this);
  plot_ = named<OutlinePlot>("outlines", this);
  view_ = named<SherdView>("sherd", this);
  view_->setPalette(mattePalette());
  candidates_ = new CandidateBar(review_, this);
  buildActions();
  buildLayout();
  connect(cards_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& now) {
            if (!now.isValid() || now.row() == hand_.row()) return;
            joining_->isOn() ? joining_->take(now.row()) : review_.selectRow(now.row());
          });
  connect(cards_, &CardList::backDropped, &review_, &PairReview::giveBack);
  connect(&hand_, &CardInHand::cardChanged, this, &ReviewPane::showCard);
  connect(&review_, &PairReview::waitingChanged, this, &ReviewPane::showCard);
  connect(&review_, &PairReview::personChanged, this, &ReviewPane::showFigures);
  connect(&hand_, &CardInHand::trialChanged, this, &ReviewPane::showFigures);
  connect(&hand_, &CardInHand::busyChanged, this, &ReviewPane::showFigures);
  connect(&hand_, &CardInHand::settlingAt, this, &ReviewPane::showSettling);
  connect(&hand_, &CardInHand::sceneChanged, this,
          [this](const std::shared_ptr<const PairScene>& scene) {
            scene_ = scene;
            showScene(*scene);
          });
  connect(&hand_, &CardInHand::sceneFetched, this, [this] {
    blankOther();  // where its pictures cannot be had
    showFigures();
  });
  blanking_.setSingleShot(true);
  blanking_.setInterval(kBlankAfter_ms);
  connect(&blanking_, &QTimer::timeout, this, &ReviewPane::blankOther);
  connect(&hand_, &CardInHand::modelFetched, this, [this](const MeshPtr& mesh) {
    mesh ? view_->showModel(*mesh) : closed_->setChecked(false);
    forgetMeasured();
  });
  connect(view_, &SherdView::backMoved, this, [this](const auto& turn_rad, const auto& move_mm) {
    if (!closed_->isChecked()) hand_.moveByHand(turn_rad, move_mm);  // a model hides the back
  });
  connect(view_, &SherdView::pointPicked, this, &ReviewPane::measure);
  showCard();
}

template <class... To>
QAction* ReviewPane::keyed(const char* name, const QString& picture, const QString& text,
                           const QList<QKeySequence>& keys, To... to) {
  QAction* action = addPageAct(this, name, picture, text, {}, to...);
  action->setShortcuts(keys);
  action->setAutoRepeat(false);  // a key that is held down decides one pair, not all of them
  return action;
}

QAction* ReviewPane::step(const char* name, const QString& text, const QKeySequence& key, int by,
                          void (CardInHand::*slot)(int), void (PicturePair::*line)(int)) {
  QAction* action = keyed(name, {}, text, {key}, this, [this, slot, line, by] {
    pictures_->isCutting() && line ? (pictures_->*line)(by) : (hand_.*slot)(by);
  });
  action->setAutoRepeat(true);
  return action;
}

QAction* ReviewPane::toggle(const char* name, const QString& picture, const QString& text,
                            const QKeySequence& key) {
  QAction* action = keyed(name, picture, text, {key});
  action->setCheckable(true);
  return action;
}

void ReviewPane::buildActions() {
  keyed("accept", {}, tr("Accept"), {Qt::Key_Return, Qt::Key_Enter}, this,
        &ReviewPane::acceptMarked);
  keyed("next", {}, tr("Next pair"), {Qt::Key_Down}, this, &ReviewPane::next)->setAutoRepeat(true);
  keyed("previous", {}, tr("Previous pair"), {Qt::Key_Up}, this, &ReviewPane::previous)
      ->setAutoRepeat(true);
  keyed("leaveJoin", {}, tr("Leave merging and splitting"), {Qt::Key_Escape}, this,
        &ReviewPane::leave);
  for (int i = 0; i < 9; ++i)
    step("choose", tr("Candidate %1").arg(i + 1), QKeySequence(Qt::Key_1 + i), i,
         &CardInHand::choose, nullptr);
  step("startBefore", tr("Start point before"), Qt::Key_Left, -1, &CardInHand::stepStart,
       &PicturePair::moveLine);
  step("startAfter", tr("Next start point"), Qt::Key_Right, 1, &CardInHand::stepStart,
       &PicturePair::moveLine);
  step("sampleBefore", tr("One sample back"), Qt::SHIFT | Qt::Key_Left, -1, &CardInHand::stepSample,
       &PicturePair::turnLine);
  step("sampleAfter", tr("One sample on"), Qt::SHIFT | Qt::Key_Right, 1, &CardInHand::stepSample,
       &PicturePair::turnLine);
  buildViewActions();
  QAction* settle =
      keyed("settle", "settle", tr("Refine fit"), {Qt::Key_B}, &hand_, &CardInHand::settle);
  settle->setToolTip(tr("Refine the position by the fracture surfaces (B)"));
  QAction* aside =
      keyed("aside", "aside", tr("Set aside"), {Qt::Key_S}, &review_, &PairReview::setAside);
  QAction* reshoot =
      keyed("reshoot", "camera", tr("Reshoot"), {Qt::Key_N}, &review_, &PairReview::reshoot);
  buildPieceActions();
  tools_ = named<ToolRow>("reviewTools", this);
  tools_->addGroup(tr("View"), {mirror_, apart_, section_, measure_, along_fracture_, closed_});
  tools_->addGroup(tr("Fit"), {settle});
  tools_->addGroup(tr("Decide"), {aside, reshoot, join_, cut_});
  if (review_.whyReadOnly().isEmpty()) return;
  for (QAction* action : {aside, reshoot, join_, cut_}) {
    action->setEnabled(false);
    action->setToolTip(review_.whyReadOnly());
  }
}

void ReviewPane::buildViewActions() {
  mirror_ = toggle("mirror", "mirror", tr("Mirror back"), Qt::Key_M);
  connect(mirror_, &QAction::toggled, pictures_, &PicturePair::setMirrored);
  apart_ = toggle("apart", "apart", tr("Explode"), Qt::Key_A);
  connect(apart_, &QAction::toggled, view_, &SherdView::setApart);
  connect(apart_, &QAction::toggled, this, [this](bool on) {
    if (on) measure_->setChecked(false);  // lengths across sides that lie apart would be false
  });
  section_ = toggle("section", "section", tr("Section"), Qt::Key_X);
  connect(section_, &QAction::toggled, view_, &SherdView::setSection);
  connect(view_, &SherdView::sectionChanged, section_, &QAction::setChecked);
  measure_ = toggle("measure", "measure", tr("Measure"), Qt::Key_D);
  connect(measure_, &QAction::toggled, this, [this](bool on) {
    measured_.clear();
    if (on) apart_->setChecked(false);
    view_->setMeasuring(on);
    showFigures();
  });
  along_fracture_ = toggle("alongFracture", "distance", tr("Fracture gap"), Qt::Key_R);
  connect(along_fracture_, &QAction::toggled, this, &ReviewPane::colourFracture);
  closed_ = toggle("closed", "model", tr("Model"), Qt::Key_V);
  connect(closed_, &QAction::triggered, this, [this](bool on) {
    if (on)
      hand_.fetchModel();
    else
      hand_.fetchScans();
  });
}

// Pieces that the masks separated or joined wrongly.
void ReviewPane::buildPieceActions() {
  cut_ = toggle("cut", "split", tr("Split"), Qt::Key_K);
  cut_->setToolTip(tr("Split a scan of two sherds along a line over its photograph (K)"));
  connect(cut_, &QAction::toggled, this, [this](bool on) {
    pictures_->setCutting(on);
    showFigures();
  });
  connect(pictures_, &PicturePair::cut, this,
          [this](bool front, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
            cut_->setChecked(false);
            review_.split(front ? batch::Side::Front : batch::Side::Back, a, b);
          });
  join_ = toggle("join", "join", tr("Merge"), Qt::Key_J);
  join_->setToolTip(
      tr("Merge two fragments of one sherd: then choose the other card (J fronts, Shift+J backs)"));
  joining_ =
      new JoinMode(review_, *cards_, join_,
                   toggle("joinBacks", "join", tr("Merge backs"), Qt::SHIFT | Qt::Key_J), this);
  connect(joining_, &JoinMode::changed, this, &ReviewPane::showCard);
  connect(cut_, &QAction::toggled, joining_, [this](bool on) {
    if (on) joining_->leave();
  });
  connect(joining_, &JoinMode::changed, this, [this] {
    if (joining_->isOn()) cut_->setChecked(false);
  });
}

// As wide as the letters want, but never at the cost of what is to be compared.
void ReviewPane::fitCards() {
  cards_->setFixedWidth(std::min(fontMetrics().height() * 15, window()->width() / 5));
}

// Beside the pictures the plots have a third of the room, or are away for their sake.
void ReviewPane::fitPlot() {
  const int room = (width() - cards_->width()) / 2;
  plot_->setMinimumWidth(plot_->readableWidth());
  plot_->setVisible(compared_->orientation() == Qt::Vertical || room >= 3 * plot_->readableWidth());
}

void ReviewPane::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::FontChange || compared_ == nullptr) return;
  fitCards();
  fitPlot();
}

void ReviewPane::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitCards();
  fitPlot();
}

void ReviewPane::setCompact(bool compact) {
  compared_->setOrientation(compact ? Qt::Horizontal : Qt::Vertical);
  fitPlot();
  tools_->setCompact(compact);
  candidates_->setCompact(compact);
  reason_->setFont(scaledFont(*this, compact ? 1 : Look::kSection));
}

void ReviewPane::buildLayout() {
  reason_ = wrappedLabel(this, "reason");
  reason_->setFont(scaledFont(*this, Look::kSection));
  figures_ = wrappedLabel(this, "figures");
  figures_->setFont(tabularFont(figures_->font()));
  accept_ = new BigButton("acceptButton", tr("Accept"), this);
  accept_->setKeyHint(keyText(Qt::Key_Return));
  accept_->setFocusPolicy(Qt::TabFocus);
  connect(accept_, &BigButton::clicked, this, &ReviewPane::acceptMarked);

  compared_ = filled(new QSplitter(Qt::Vertical, this), {{pictures_, 3}, {plot_, 1}});
  QSplitter* sides = filled(new QSplitter(Qt::Horizontal, this), {{compared_, 1}, {view_, 1}});
  sides->setSizes({500, 500});

  auto* decide = filled(new QVBoxLayout, {Part::room(), candidates_->others(), accept_});
  auto* last = filled(new QHBoxLayout, {{candidates_, 1}, decide});
  // What decides stays in sight; where letters are large, what is compared and measured is
  // scrolled.
  auto* compared = new QWidget(this);
  filled(bareLayout<QVBoxLayout>(compared), {{sides, 1}, figures_});
  auto* area = new PageArea(compared, this);
  auto* right = filled(new QVBoxLayout, {reason_, {area, 1}, tools_, last});
  fitCards();
  filled(bareLayout<QHBoxLayout>(this), {cards_, {right, 1}});
}

// A press that decided something ends by marking the card that was pressed; keys act on the other.
void ReviewPane::markCard() {
  const int row = hand_.row();
  if (row < 0 || joining_->isOn()) return;
  cards_->selectionModel()->setCurrentIndex(review_.cards().index(row),
                                            QItemSelectionModel::ClearAndSelect);
}

void ReviewPane::showCard() {
  const int row = hand_.row();
  if (row >= 0 && cards_->currentIndex().row() != row)
    cards_->setCurrentIndex(review_.cards().index(row));
  QMetaObject::invokeMethod(this, &ReviewPane::markCard, Qt::QueuedConnection);
  if (!review_.batch().isOpen()) {
    cut_->setChecked(false);  // what is opened next is asked anew
    joining_->leave();
  }
  if (showsOther()) blanking_.start();
  if (!scene_ || !review_.batch().isOpen()) blankOther();
  showFigures();
}

bool ReviewPane::showsOther() const {
  return scene_ && (scene_->front != hand_.front() || scene_->back != hand_.trial().back);
}

void ReviewPane::blankOther() {
  if (review_.batch().isOpen() && scene_ && !showsOther()) return;
  scene_.reset();
  view_->clear();
  plot_->clear();
  pictures_->setPictures({}, {}, {});
  namePictures();
  pictures_->setLoading(hand_.isLoading());
}

void ReviewPane::namePictures() {
  if (!review_.batch().isOpen()) return pictures_->setNames({}, {});
  const decisions::CandidateTable& table = review_.batch().table();
  pictures_->setNames(plainNumber(table.fronts, hand_.front()),
                      plainNumber(table.backs, hand_.trial().back));
}

void ReviewPane::acceptMarked() {
  if (pictures_->isCutting()) return pictures_->cutHere();
  if (joining_->isOn()) return joining_->takeMarked();
  review_.accept();
}

void ReviewPane::next() {
  if (pictures_->isCutting()) return pictures_->takeOtherSide();
  joining_->isOn() ? joining_->move(1) : review_.next();
}

void ReviewPane::previous() {
  if (pictures_->isCutting()) return pictures_->takeOtherSide();
  joining_->isOn() ? joining_->move(-1) : review_.previous();
}

void ReviewPane::leave() {
  if (hand_.isSettling()) return hand_.stopSettling();
  cut_->setChecked(false);
  joining_->leave();
}

// The back moves under the eye, and its fracture's figures with it.
void ReviewPane::showSettling(const Eigen::Isometry3d& front_from_back,
                              const std::vector<double>& rms_mm) {
  QStringList fractures;
  for (const double fracture : rms_mm) fractures << mm(fracture, 2);
  figures_->setText(tr("Refining the fit, fracture gap %1. Esc stops.")
                        .arg(fractures.join(QStringLiteral(" → "))));
  if (!closed_->isChecked()) view_->setPose(front_from_back);
  forgetMeasured();
}

QString ReviewPane::words() const {
  if (joining_->isOn()) return joining_->words();
  if (pictures_->isCutting()) return pictures_->cutWords();
  if (view_->isMeasuring())
    return tr("Click on one end of the length on the sherd, then on the other. D ends.");
  return hand_.reason();
}

// A length between sides that moved since is none.
void ReviewPane::forgetMeasured() {
  if (measured_.empty()) return;
  measured_.clear();
  view_->setMeasure(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), {});
}

void ReviewPane::showFigures() {
  if (hand_.trial().front_from_back.matrix() != measured_at_.matrix()) forgetMeasured();
  reason_->setText(words());
  figures_->setText(hand_.isSettling() ? tr("Comparing the fractures… Esc stops.")
                                       : hand_.figuresText());
  // A missing name is said by the click, not by a dead button.
  accept_->setEnabled(review_.batch().isOpen() && hand_.front() >= 0 && hand_.trial().back >= 0 &&
                      !hand_.isLoading() && review_.whyReadOnly().isEmpty() &&
                      (joining_->isOn() || pictures_->isCutting() || !review_.isDone()));
  accept_->setToolTip(review_.whyNotAccept());
  if (review_.batch().isOpen() && !closed_->isChecked())
    view_->setPose(hand_.trial().front_from_back);
}

void ReviewPane::showScene(const PairScene& scene) {
  view_->setUnitKnown(review_.batch().table().has_scale);
  pictures_->setPictures(scene.front_picture, scene.back_picture, scene.view.frame);
  namePictures();
  scene.front < 0 || scene.back < 0 ? plot_->clear() : plot_->setView(scene.view);
  if (scene.front_cloud && scene.back_cloud) {
    closed_->setChecked(false);
    measure_->setChecked(false);
    const auto shown = [](const review::ScanCloud& scan) {
      return ShownScan{scan.cloud, scan.fracture, scan.strip_point};
    };
    view_->showScans(shown(*scene.front_cloud), shown(*scene.back_cloud),
                     scene.fit.front_from_back);
  }
  colourFracture();
  showFigures();
}

void ReviewPane::colourFracture() {
  ShownDistances shown;
  shown.reach_mm = kFractureScale_mm;
  if (along_fracture_->isChecked() && scene_) {
    shown.front_mm = scene_->view.fracture.front_mm;
    shown.back_mm = scene_->view.fracture.back_mm;
  }
  view_->setDistances(shown);
}

void ReviewPane::measure(const Eigen::Vector3d& point) {
  if (measured_.size() >= 2) measured_.clear();
  measured_.push_back(point);
  measured_at_ = hand_.trial().front_from_back;
  if (measured_.size() < 2) return view_->setMeasure(point, point, tr("… and the other end"));
  const double length = review::length_mm(measured_[0], measured_[1]);
  view_->setMeasure(
      measured_[0], measured_[1],
      review_.batch().table().has_scale ? mm(length, 1) : QLocale().toString(length, 'f', 1));
}

}  // namespace ostraka::ui
