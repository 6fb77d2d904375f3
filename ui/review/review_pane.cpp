#include "ui/review/review_pane.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScreen>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/frame/flow_row.h"
#include "ui/frame/look.h"
#include "ui/frame/page_area.h"
#include "ui/frame/state_colours.h"
#include "ui/review/candidate_bar.h"
#include "ui/review/card_list.h"
#include "ui/review/join_mode.h"
#include "ui/review/outline_plot.h"
#include "ui/review/pair_review_model.h"
#include "ui/review/picture_pair.h"
#include "ui/review/review_words.h"
#include "ui/viewport/sherd_view.h"

namespace ostraka::ui {
namespace {

constexpr double kRimScale_mm = 0.5;  // twice a good rim's RMS is yellow

ShownScan shownScan(const pipeline::ScanCloud& cloud) {
  return {cloud.cloud, cloud.rim};
}

}  // namespace

ReviewPane::ReviewPane(PairReviewModel& model, QWidget* parent) : QWidget(parent), model_(model) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Pairs of the batch"));
  cards_ = new CardList(this);
  cards_->setObjectName("cards");
  cards_->setAccessibleName(tr("Pairs, most doubtful first"));
  cards_->setModel(&model_);
  pictures_ = new PicturePair(this);
  plot_ = new OutlinePlot(this);
  view_ = new SherdView(this);
  view_->setObjectName("sherd");
  candidates_ = new CandidateBar(model_, this);
  buildActions();
  buildLayout();
  connect(cards_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& now) {
            if (!now.isValid() || now.row() == model_.rowInHand()) return;
            joining_->isOn() ? joining_->take(now.row()) : model_.selectRow(now.row());
          });
  connect(cards_, &CardList::backDropped, &model_, &PairReviewModel::giveBack);
  connect(&model_, &PairReviewModel::cardChanged, this, &ReviewPane::showCard);
  connect(&model_, &PairReviewModel::waitingChanged, this, &ReviewPane::showCard);
  connect(&model_, &PairReviewModel::trialChanged, this, &ReviewPane::showFigures);
  connect(&model_, &PairReviewModel::busyChanged, this, &ReviewPane::showFigures);
  connect(&model_, &PairReviewModel::settlingAt, this, &ReviewPane::showSettling);
  connect(&model_, &PairReviewModel::sceneChanged, this,
          [this](const std::shared_ptr<const PairScene>& scene) {
            scene_ = scene;
            showScene(*scene);
          });
  connect(&model_, &PairReviewModel::modelFetched, this, [this](const MeshPtr& mesh) {
    mesh ? view_->showModel(*mesh) : closed_->setChecked(false);
    forgetMeasured();
  });
  connect(view_, &SherdView::backMoved, this, [this](const auto& turn_rad, const auto& move_mm) {
    if (!closed_->isChecked()) model_.moveByHand(turn_rad, move_mm);  // a model hides the back
  });
  connect(view_, &SherdView::pointPicked, this, &ReviewPane::measure);
  showCard();
}

QAction* ReviewPane::act(const char* name, const QString& text, const QList<QKeySequence>& keys,
                         void (PairReviewModel::*slot)()) {
  QAction* action = keyed(name, text, keys);
  connect(action, &QAction::triggered, &model_, slot);
  return action;
}

QAction* ReviewPane::keyed(const char* name, const QString& text, const QList<QKeySequence>& keys) {
  auto* action = new QAction(text, this);
  action->setObjectName(name);
  action->setShortcuts(keys);
  action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  action->setAutoRepeat(false);  // a key that is held down decides one pair, not all of them
  addAction(action);
  return action;
}

QAction* ReviewPane::step(const char* name, const QString& text, const QKeySequence& key, int by,
                          void (PairReviewModel::*slot)(int), void (PicturePair::*line)(int)) {
  QAction* action = keyed(name, text, {key});
  action->setAutoRepeat(true);
  connect(action, &QAction::triggered, this, [this, slot, line, by] {
    pictures_->isCutting() && line ? (pictures_->*line)(by) : (model_.*slot)(by);
  });
  return action;
}

QAction* ReviewPane::toggle(const char* name, const QString& text, const QKeySequence& key) {
  QAction* action = keyed(name, text, {key});
  action->setCheckable(true);
  return action;
}

void ReviewPane::buildActions() {
  const auto add = [this](const char* name, const QString& text, const QList<QKeySequence>& keys,
                          void (ReviewPane::*slot)()) {
    QAction* action = keyed(name, text, keys);
    connect(action, &QAction::triggered, this, slot);
    return action;
  };
  add("accept", tr("This one"), {Qt::Key_Return, Qt::Key_Enter}, &ReviewPane::accept);
  add("next", tr("Next pair"), {Qt::Key_Down}, &ReviewPane::next)->setAutoRepeat(true);
  add("previous", tr("Previous pair"), {Qt::Key_Up}, &ReviewPane::previous)->setAutoRepeat(true);
  add("leaveJoin", tr("Settle, join and cut nothing"), {Qt::Key_Escape}, &ReviewPane::leave);
  for (int i = 0; i < 9; ++i)
    step("choose", tr("Candidate %1").arg(i + 1), QKeySequence(Qt::Key_1 + i), i,
         &PairReviewModel::choose, nullptr);
  step("startBefore", tr("Start point before"), Qt::Key_Left, -1, &PairReviewModel::stepStart,
       &PicturePair::moveLine);
  step("startAfter", tr("Next start point"), Qt::Key_Right, 1, &PairReviewModel::stepStart,
       &PicturePair::moveLine);
  step("sampleBefore", tr("One sample back"), Qt::SHIFT | Qt::Key_Left, -1,
       &PairReviewModel::stepSample, &PicturePair::turnLine);
  step("sampleAfter", tr("One sample on"), Qt::SHIFT | Qt::Key_Right, 1,
       &PairReviewModel::stepSample, &PicturePair::turnLine);
  buildViewActions();
  QAction* settle = act("settle", tr("Settle"), {Qt::Key_B}, &PairReviewModel::settle);
  settle->setToolTip(tr("Let the rims settle the position (B)"));
  QAction* aside = act("aside", tr("Set aside"), {Qt::Key_S}, &PairReviewModel::setAside);
  QAction* reshoot = act("reshoot", tr("Shoot again"), {Qt::Key_N}, &PairReviewModel::reshoot);
  buildPieceActions();
  shown_actions_ = {settle,  mirror_, apart_, section_, measure_, along_rim_,
                    closed_, join_,   cut_,   aside,    reshoot};
}

void ReviewPane::buildViewActions() {
  mirror_ = toggle("mirror", tr("Mirror back"), Qt::Key_M);
  connect(mirror_, &QAction::toggled, pictures_, &PicturePair::setMirrored);
  apart_ = toggle("apart", tr("Apart"), Qt::Key_A);
  connect(apart_, &QAction::toggled, view_, &SherdView::setApart);
  connect(apart_, &QAction::toggled, this, [this](bool on) {
    if (on) measure_->setChecked(false);  // lengths across sides that lie apart would be false
  });
  section_ = toggle("section", tr("Section"), Qt::Key_X);
  connect(section_, &QAction::toggled, view_, &SherdView::setSection);
  connect(view_, &SherdView::sectionChanged, section_, &QAction::setChecked);
  measure_ = toggle("measure", tr("Measure"), Qt::Key_D);
  connect(measure_, &QAction::toggled, this, [this](bool on) {
    measured_.clear();
    if (on) apart_->setChecked(false);
    view_->setMeasuring(on);
    showFigures();
  });
  along_rim_ = toggle("alongRim", tr("Rim gap"), Qt::Key_R);
  connect(along_rim_, &QAction::toggled, this, &ReviewPane::colourRim);
  closed_ = toggle("closed", tr("Model"), Qt::Key_V);
  connect(closed_, &QAction::triggered, this, [this](bool on) {
    if (on)
      model_.fetchModel();
    else
      model_.fetchScans();
  });
}

// Pieces that the masks separated or joined wrongly.
void ReviewPane::buildPieceActions() {
  cut_ = toggle("cut", tr("Cut"), Qt::Key_K);
  cut_->setToolTip(
      tr("Cut a piece that is two sherds in truth, along a line over its picture (K)"));
  connect(cut_, &QAction::toggled, this, [this](bool on) {
    pictures_->setCutting(on);
    showFigures();
  });
  connect(pictures_, &PicturePair::cut, this,
          [this](bool front, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
            cut_->setChecked(false);
            model_.split(front ? batch::Side::Front : batch::Side::Back, a, b);
          });
  join_ = toggle("join", tr("Join"), Qt::Key_J);
  join_->setToolTip(
      tr("Join two pieces of one sherd: then choose the other card (J fronts, Shift+J backs)"));
  joining_ = new JoinMode(model_, *cards_, join_,
                          toggle("joinBacks", tr("Join backs"), Qt::SHIFT | Qt::Key_J), this);
  connect(joining_, &JoinMode::changed, this, &ReviewPane::showCard);
  connect(cut_, &QAction::toggled, joining_, [this](bool on) {
    if (on) joining_->leave();
  });
  connect(joining_, &JoinMode::changed, this, [this] {
    if (joining_->isOn()) cut_->setChecked(false);
  });
}

QLayout* ReviewPane::buttons() {
  auto* row = new FlowRow;
  row->setSpacing(2);
  for (QAction* action : shown_actions_) {
    auto* button = new QToolButton(this);
    const QString key = action->shortcut().toString(QKeySequence::NativeText);
    action->setIconText(tr("%1 %2").arg(action->text(), key));
    button->setDefaultAction(action);
    connect(action, &QAction::toggled, this, &ReviewPane::tintPressed);
    buttons_.push_back(button);
    button->setAccessibleName(tr("%1, key %2").arg(action->text(), key));
    button->setFocusPolicy(Qt::TabFocus);
    button->setMinimumHeight(fontMetrics().height() * 2);
    row->addWidget(button);
  }
  return row;
}

// As wide as the letters want, but never at the cost of what is to be compared.
void ReviewPane::fitCards() {
  cards_->setFixedWidth(
      std::min(fontMetrics().height() * 15, screen()->availableSize().width() / 5));
}

// Dark themes hardly tell a pressed button from another.
void ReviewPane::tintPressed() {
  for (QToolButton* button : buttons_) {
    QPalette look;
    if (button->defaultAction()->isChecked())
      look.setColor(QPalette::Button, StateColours(palette()).behind(State::Selected));
    button->setPalette(look);
  }
}

void ReviewPane::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) tintPressed();
  if (event->type() == QEvent::FontChange && cards_ != nullptr) fitCards();
}

void ReviewPane::buildLayout() {
  reason_ = new QLabel(this);
  reason_->setObjectName("reason");
  reason_->setWordWrap(true);
  reason_->setFont(scaledFont(*this, 1.15));
  figures_ = new QLabel(this);
  figures_->setObjectName("figures");
  figures_->setFont(tabularFont(figures_->font()));
  figures_->setWordWrap(true);
  accept_ = new QPushButton(tr("This one   Enter"), this);
  accept_->setObjectName("acceptButton");
  accept_->setMinimumHeight(targetSize(*this));
  accept_->setFont(scaledFont(*this, 1.2));
  accept_->setFocusPolicy(Qt::TabFocus);
  connect(accept_, &QPushButton::clicked, this, &ReviewPane::accept);

  auto* middle = new QSplitter(Qt::Vertical, this);
  middle->addWidget(pictures_);
  middle->addWidget(plot_);
  middle->setStretchFactor(0, 3);
  middle->setStretchFactor(1, 2);
  auto* sides = new QSplitter(Qt::Horizontal, this);
  sides->addWidget(middle);
  sides->addWidget(view_);
  sides->setStretchFactor(0, 1);
  sides->setStretchFactor(1, 1);
  sides->setSizes({500, 500});

  auto* last = new QHBoxLayout;
  last->addWidget(candidates_, 1);
  last->addWidget(accept_);
  // What decides stays in sight; where letters are large, the rest is scrolled.
  auto* compared = new QWidget(this);
  auto* column = new QVBoxLayout(compared);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(sides, 1);
  column->addLayout(buttons());
  column->addWidget(figures_);
  auto* right = new QVBoxLayout;
  right->addWidget(reason_);
  auto* area = new PageArea(compared, this);
  area->setMinimumHeight(fontMetrics().height() * 7);
  right->addWidget(area, 1);
  right->addLayout(last);
  auto* all = new QHBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  fitCards();
  all->addWidget(cards_);
  all->addLayout(right, 1);
}

// A press that decided something ends by marking the card that was pressed; keys act on the other.
void ReviewPane::markCard() {
  const int row = model_.rowInHand();
  if (row < 0 || joining_->isOn()) return;
  cards_->selectionModel()->setCurrentIndex(model_.index(row), QItemSelectionModel::ClearAndSelect);
}

void ReviewPane::showCard() {
  const int row = model_.rowInHand();
  if (row >= 0 && cards_->currentIndex().row() != row) cards_->setCurrentIndex(model_.index(row));
  QMetaObject::invokeMethod(this, &ReviewPane::markCard, Qt::QueuedConnection);
  if (!model_.isOpen()) {
    cut_->setChecked(false);  // what is opened next is asked anew
    joining_->leave();
    view_->clear();
    plot_->clear();
    pictures_->setPictures({}, {}, {});
  }
  showFigures();
}

void ReviewPane::accept() {
  if (pictures_->isCutting()) return pictures_->cutHere();
  joining_->isOn() ? joining_->takeMarked() : model_.accept();
}

void ReviewPane::next() {
  if (pictures_->isCutting()) return pictures_->takeOtherSide();
  joining_->isOn() ? joining_->move(1) : model_.next();
}

void ReviewPane::previous() {
  if (pictures_->isCutting()) return pictures_->takeOtherSide();
  joining_->isOn() ? joining_->move(-1) : model_.previous();
}

void ReviewPane::leave() {
  if (model_.isSettling()) return model_.stopSettling();
  cut_->setChecked(false);
  joining_->leave();
}

// The back moves under the eye, and its rim's figures with it.
void ReviewPane::showSettling(const Eigen::Isometry3d& front_from_back) {
  QStringList rims;
  for (const double rim : model_.settlingRims()) rims << mm(rim, 2);
  figures_->setText(tr("The rims settle: %1. Esc stops.").arg(rims.join(QStringLiteral(" → "))));
  if (!closed_->isChecked()) view_->setPose(front_from_back);
  forgetMeasured();
}

QString ReviewPane::words() const {
  if (joining_->isOn()) return joining_->words();
  if (pictures_->isCutting()) return pictures_->cutWords();
  if (view_->isMeasuring())
    return tr("Click on one end of the length on the sherd, then on the other. D ends.");
  return model_.reason();
}

// A length between sides that moved since is none.
void ReviewPane::forgetMeasured() {
  if (measured_.empty()) return;
  measured_.clear();
  view_->setMeasure(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), {});
}

void ReviewPane::showFigures() {
  if (model_.trial().front_from_back.matrix() != measured_at_.matrix()) forgetMeasured();
  reason_->setText(words());
  figures_->setText(model_.isSettling() ? tr("The rims are compared … Esc stops.")
                                        : model_.figuresText());
  // A missing name is said by the click, not by a dead button.
  accept_->setEnabled(model_.isOpen() && model_.front() >= 0 && model_.trial().back >= 0);
  accept_->setToolTip(model_.whyNotAccept());
  if (model_.isOpen() && !closed_->isChecked()) view_->setPose(model_.trial().front_from_back);
}

void ReviewPane::showScene(const PairScene& scene) {
  const auto& table = model_.live()->table();
  view_->setUnitKnown(table.has_scale);
  const auto name = [](const std::vector<pipeline::ScanRef>& scans, int i) {
    return i < 0 ? QString() : QString::fromStdString(scans.at(static_cast<std::size_t>(i)).id);
  };
  pictures_->setPictures(scene.front_picture, scene.back_picture, scene.view.frame);
  pictures_->setNames(name(table.fronts, scene.front), name(table.backs, scene.back));
  scene.front < 0 || scene.back < 0 ? plot_->clear() : plot_->setView(scene.view);
  if (scene.front_cloud && scene.back_cloud) {
    closed_->setChecked(false);
    measure_->setChecked(false);
    view_->showScans(shownScan(*scene.front_cloud), shownScan(*scene.back_cloud),
                     scene.fit.front_from_back);
  }
  colourRim();
  showFigures();
}

void ReviewPane::colourRim() {
  ShownRim rim;
  rim.reach_mm = kRimScale_mm;
  if (along_rim_->isChecked() && scene_)
    for (const registration::RimDistance& d : scene_->view.rim) {
      rim.points.push_back(d.point);
      rim.distance_mm.push_back(d.distance_mm);
    }
  view_->setRim(rim);
}

void ReviewPane::measure(const Eigen::Vector3d& point) {
  if (measured_.size() >= 2) measured_.clear();
  measured_.push_back(point);
  measured_at_ = model_.trial().front_from_back;
  if (measured_.size() < 2) return view_->setMeasure(point, point, tr("… and the other end"));
  const double length = pipeline::length_mm(measured_[0], measured_[1]);
  view_->setMeasure(
      measured_[0], measured_[1],
      model_.live()->table().has_scale ? mm(length, 1) : QLocale().toString(length, 'f', 1));
}

}  // namespace ostraka::ui
