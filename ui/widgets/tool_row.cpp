#include "ui/widgets/tool_row.h"

#include <QAction>
#include <QEvent>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QToolButton>
#include <algorithm>

#include "ui/look/look.h"
#include "ui/look/style.h"
#include "ui/widgets/page_acts.h"
#include "ui/widgets/parts.h"

namespace ostraka::ui {
namespace {

constexpr int kBetween = Look::kGap / 4;  // buttons of one group
constexpr int kGroups = Look::kGroup;     // with the line in its middle

int widthOf(const QToolButton& button) {
  return std::max(button.sizeHint().width(), button.minimumWidth());
}

}  // namespace

ToolRow::ToolRow(QWidget* parent)
    : QWidget(parent),
      more_(named<QToolButton>({"moreTools", tr("More tools")}, this)),
      menu_(new QMenu(more_)) {
  more_->setText(tr("More"));
  more_->setIcon(icon(QStringLiteral("more")));
  more_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  more_->setPopupMode(QToolButton::InstantPopup);
  more_->setAutoRaise(true);
  more_->setFocusPolicy(Qt::TabFocus);
  more_->setMenu(menu_);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ToolRow::addWidget(QWidget* widget) {
  widget->setParent(this);
  fixed_.append(widget);
  refit();
}

void ToolRow::addGroup(const QString& caption, const QList<QAction*>& actions) {
  Group group{new QLabel(caption, this), {}};
  group.caption->setFont(scaledFont(*this, Look::kCaption));
  group.caption->setForegroundRole(kSecondaryText);
  for (QAction* action : actions) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(action);
    button->setObjectName(action->objectName() + QStringLiteral("Button"));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    const auto follow = [this, action, button] {
      const QString key = keyText(action->shortcut());
      button->setAccessibleName(key.isEmpty() ? action->text()
                                              : tr("%1, key %2").arg(action->text(), key));
      if (action->toolTip() == action->text() && !key.isEmpty())
        button->setToolTip(QStringLiteral("%1 (%2)").arg(action->text(), key));
      refit();
    };
    connect(action, &QAction::changed, button, follow);
    group.buttons.append(button);
    follow();
  }
  groups_.append(group);
  refit();
}

void ToolRow::setCompact(bool compact) {
  compact_ = compact;
  refit();
}

void ToolRow::setTouched() {
  touched_ = true;
  refit();
}

QToolButton* ToolRow::buttonOf(const QAction* action) const {
  for (const Group& group : groups_)
    for (QToolButton* button : group.buttons)
      if (button->defaultAction() == action) return button;
  return nullptr;
}

bool ToolRow::hasCaptions() const {
  return !compact_ && std::any_of(groups_.begin(), groups_.end(), [](const Group& group) {
    return !group.caption->text().isEmpty();
  });
}

int ToolRow::captionHeight() const {
  return hasCaptions() ? QFontMetrics(scaledFont(*this, Look::kCaption)).height() : 0;
}

int ToolRow::rowHeight() const {
  int high = touched_ ? targetSize(*this) : controlHeight(*this);
  for (const QWidget* widget : fixed_) high = std::max(high, widget->sizeHint().height());
  return high;
}

int ToolRow::widthOfGroup(const Group& group) const {
  int wide = 0;
  for (const QToolButton* button : group.buttons)
    if (button->defaultAction()->isVisible()) wide += widthOf(*button) + kBetween;
  return wide;
}

int ToolRow::fixedWidth() const {
  int wide = 0;
  for (const QWidget* widget : fixed_)
    if (!widget->isHidden()) wide += widget->sizeHint().width() + Look::kGap;
  return wide;
}

int ToolRow::widthOfAll() const {
  int wide = fixedWidth();
  for (const Group& group : groups_)
    if (const int own = widthOfGroup(group); own > 0) wide += own + kGroups;
  return wide;
}

QSize ToolRow::sizeHint() const {
  return {widthOfAll(), captionHeight() + rowHeight()};
}

QSize ToolRow::minimumSizeHint() const {
  return {fixedWidth() + more_->sizeHint().width(), captionHeight() + rowHeight()};
}

void ToolRow::refit() {
  updateGeometry();
  arrange();
}

void ToolRow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

void ToolRow::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) refit();
}

void ToolRow::arrange() {
  const int top = captionHeight(), high = rowHeight();
  const bool whole = widthOfAll() <= width();
  const int end = width() - (whole ? 0 : more_->sizeHint().width());
  int x = 0;
  for (QWidget* widget : fixed_) {
    if (widget->isHidden()) continue;
    widget->setGeometry(x, top, widget->sizeHint().width(), high);
    x += widget->width() + Look::kGap;
  }
  lines_.clear();
  menu_->clear();
  bool room = true;
  for (const Group& group : groups_) {
    const int begin = x;
    bool in_menu = false;
    for (QToolButton* button : group.buttons) {
      QAction* action = button->defaultAction();
      const int wide = widthOf(*button);
      room = room && (!action->isVisible() || x + wide <= end);
      button->setVisible(action->isVisible() && room);
      if (!action->isVisible()) continue;
      if (room) {
        button->setGeometry(x, top, wide, high);
        x += wide + kBetween;
      } else {
        if (!in_menu && !group.caption->text().isEmpty()) menu_->addSection(group.caption->text());
        in_menu = true;
        menu_->addAction(action);
      }
    }
    group.caption->setVisible(hasCaptions() && x > begin);
    group.caption->setGeometry(begin + Look::kGap, 0, std::max(0, x - begin - Look::kGap), top);
    if (x == begin) continue;
    lines_.append(x + kGroups / 2 - kBetween);
    x += kGroups - kBetween;
  }
  if (whole && !lines_.isEmpty()) lines_.removeLast();
  more_->setVisible(!whole);
  more_->setGeometry(end, top, more_->sizeHint().width(), high);
  update();
}

void ToolRow::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const Colours& colours = coloursOf(palette());
  for (const int x : lines_)
    painter.fillRect(x, Look::kGap / 2, colours.border_width, height() - Look::kGap,
                     colours.border);
}

}  // namespace ostraka::ui
