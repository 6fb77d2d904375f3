#include "ui/masks/mask_page.h"

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/look/look.h"
#include "ui/masks/mask_model.h"
#include "ui/masks/mask_view.h"
#include "ui/widgets/big_button.h"
#include "ui/widgets/page_acts.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/tool_row.h"

namespace ostraka::ui {
namespace {

constexpr int kLeastWidth_px = 2, kMostWidth_px = 200, kUsualWidth_px = 24;
constexpr int kLettersOfAName = 18;  // "front, IMG_0001.jpg"

// Beside the list of photographs, where it is never without room.
QToolButton* arrow(QAction* step, QWidget* parent) {
  auto* button = named<QToolButton>({step->objectName() + "Button", step->text()}, parent);
  button->setDefaultAction(step);
  button->setToolButtonStyle(Qt::ToolButtonIconOnly);
  button->setAutoRaise(true);
  button->setMinimumHeight(controlHeight(*parent));
  return button;
}

}  // namespace

MaskPage::MaskPage(QWidget* parent)
    : QWidget(parent),
      model_(new MaskModel(this)),
      view_(named<MaskView>("maskView", this)),
      title_(named<QLabel>("masksTitle", this)),
      told_(wrappedLabel(this, QStringLiteral("masksTold"))),
      which_(named<QComboBox>({"masksWhich", tr("Photograph")}, this)),
      width_(named<QSlider>("masksWidth", Qt::Horizontal, this)) {
  setObjectName(QStringLiteral("masks"));
  back_ = addPageAct(this, "masksBack", "previous", tr("Back"), Qt::Key_Escape, this,
                     &MaskPage::closed);
  sherd_ = addPageAct(this, "masksSherd", "sherd", tr("Sherd"), Qt::Key_S);
  plate_ = addPageAct(this, "masksPlate", "turntable", tr("Plate"), Qt::Key_P);
  previous_ = addPageAct(this, "masksPrevious", "up", tr("Previous photograph"), Qt::Key_PageUp,
                         this, [this] { step(-1); });
  next_ = addPageAct(this, "masksNext", "down", tr("Next photograph"), Qt::Key_PageDown, this,
                     [this] { step(1); });
  compute_ = addPageAct(this, "masksCompute", "retry", tr("Reprocess"), Qt::Key_R, this,
                        [this] { emit computeWanted(model_->batch()); });
  for (QAction* once : {back_, compute_}) once->setAutoRepeat(false);
  auto* brush = new QActionGroup(this);
  for (QAction* action : {sherd_, plate_}) {
    action->setCheckable(true);
    brush->addAction(action);
  }
  sherd_->setChecked(true);
  buildLayout();
  connect(brush, &QActionGroup::triggered, this, &MaskPage::useBrush);
  connect(width_, &QSlider::valueChanged, this, &MaskPage::useBrush);
  connect(which_, &QComboBox::activated, model_, &MaskModel::show);
  connect(model_, &MaskModel::changed, this, &MaskPage::showModel);
  connect(model_, &MaskModel::overlayChanged, this, [this] {
    view_->setPicture(model_->photograph(), {});
    view_->setOverlay(model_->overlay());
    showTold();
  });
  connect(model_, &MaskModel::failed, told_, &QLabel::setText);
  connect(view_, &MaskView::stroked, this, [this](const QPolygonF& path) {
    model_->paint(sherd_->isChecked() ? decisions::MaskPaint::Sherd : decisions::MaskPaint::Plate,
                  path, width_->value() / 2.0);
  });
  useBrush();
}

void MaskPage::buildLayout() {
  title_->setFont(scaledFont(*this, Look::kSection, true));
  which_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  width_->setRange(kLeastWidth_px, kMostWidth_px);
  width_->setValue(kUsualWidth_px);
  width_->setFixedWidth(fontMetrics().averageCharWidth() * 20);
  auto* brush = new QWidget(this);
  filled(bareLayout<QHBoxLayout>(brush), {labelFor(width_, tr("Brush's &width")), width_});
  brush->setMinimumHeight(controlHeight(*this));
  tools_ = new ToolRow(this);
  auto* photograph = new QWidget(this);
  filled(bareLayout<QHBoxLayout>(photograph),
         {arrow(previous_, photograph), which_, arrow(next_, photograph)});
  tools_->addWidget(photograph);
  tools_->addWidget(brush);
  tools_->addGroup(tr("Brush"), {sherd_, plate_});
  reprocess_ = new BigButton(QStringLiteral("masksComputeButton"), compute_->text(), this);
  reprocess_->setKeyHint(compute_->shortcut().toString(QKeySequence::NativeText));
  connect(reprocess_, &QPushButton::clicked, compute_, &QAction::trigger);
  connect(compute_, &QAction::changed, this,
          [this] { reprocess_->setEnabled(compute_->isEnabled()); });
  auto* foot = filled(new QHBoxLayout, {{tools_, 1}, {reprocess_, 0, Qt::AlignBottom}});
  auto* all = bareLayout<QVBoxLayout>(this);
  auto* leave = named<QToolButton>("masksBackButton", this);
  leave->setDefaultAction(back_);
  leave->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  auto* head = filled(new QHBoxLayout, {{title_, 1}, leave});
  filled(all, {head, told_, {view_, 1}, foot});
  // Plus and minus belong to the picture and need no button.
  for (const auto& [key, factor] :
       {std::pair(Qt::Key_Plus, 1.25), std::pair(Qt::Key_Minus, 1 / 1.25)}) {
    QAction* action = addPageAct(this, key == Qt::Key_Plus ? "masksLarger" : "masksSmaller",
                                 key == Qt::Key_Plus ? "plus" : "minus",
                                 key == Qt::Key_Plus ? tr("Larger") : tr("Smaller"), key, this,
                                 [this, by = factor] { view_->enlarge(by); });
    action->setAutoRepeat(true);
  }
  setFocusProxy(view_);
}

void MaskPage::openBatch(ProjectSession& session, const QString& batch) {
  title_->setText(tr("Masks of %1").arg(batch));
  told_->clear();
  model_->openBatch(session, batch);
  view_->setFocus();
}

QAbstractButton* MaskPage::primary() const {
  return reprocess_;
}

void MaskPage::setCompact(bool compact) {
  constexpr int kShort = 12;  // letters; the list that opens has room for all
  which_->setSizeAdjustPolicy(compact ? QComboBox::AdjustToMinimumContentsLengthWithIcon
                                      : QComboBox::AdjustToContents);
  which_->setMinimumContentsLength(compact ? kShort : kLettersOfAName);
  width_->setFixedWidth(fontMetrics().averageCharWidth() * (compact ? kShort : 20));
  tools_->setCompact(compact);
  told_->setVisible(!compact);
}

void MaskPage::closeBatch() {
  model_->close();
}

void MaskPage::step(int by) {
  if (model_->index() + by >= 0 && model_->index() + by < model_->count())
    model_->show(model_->index() + by);
}

void MaskPage::useBrush() {
  view_->setBrush(width_->value() / 2.0, sherd_->isChecked());
}

void MaskPage::showModel() {
  const QSignalBlocker quiet(which_);
  which_->clear();
  for (int i = 0; i < model_->count(); ++i) which_->addItem(model_->title(i));
  which_->setCurrentIndex(model_->index());
  previous_->setEnabled(model_->index() > 0);
  next_->setEnabled(model_->index() + 1 < model_->count());
  view_->setPicture(model_->photograph(), tr("Loading photograph…"));
  showTold();
}

void MaskPage::showTold() {
  compute_->setEnabled(model_->canCompute());
  if (model_->index() < 0) return;
  told_->setText(
      model_->canCompute() && model_->edited() > 0
          ? tr("%n photograph(s) edited. Reprocess to update what follows from them.", nullptr,
               model_->edited())
          : tr("Blue: classified as sherd. Paint missing parts as sherd and wrong ones as plate; "
               "the program's own masks stay."));
}

}  // namespace ostraka::ui
