#include "ui/frame/sidebar.h"

#include <QAction>
#include <QActionGroup>
#include <QEvent>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/frame/screen.h"
#include "ui/look/look.h"
#include "ui/widgets/page_acts.h"

namespace ostraka::ui {
namespace {

constexpr double kNarrow = 0.8;  // of the letters' size, below their pictures

}  // namespace

Sidebar::Sidebar(QWidget* parent)
    : QFrame(parent), group_(new QActionGroup(this)), column_(new QVBoxLayout(this)) {
  setObjectName(QStringLiteral("sidebar"));
  setAccessibleName(tr("Screens"));
  column_->setContentsMargins(Look::kGap / 2, Look::kGap, Look::kGap / 2, Look::kGap);
  column_->setSpacing(2);
  column_->addStretch(1);
}

QToolButton* Sidebar::addButton(QAction* action, int at) {
  auto* button = new QToolButton(this);
  button->setDefaultAction(action);
  button->setObjectName(action->objectName() + QStringLiteral("Button"));
  button->setAutoRaise(true);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  button->setFocusPolicy(Qt::TabFocus);
  column_->insertWidget(at, button);
  buttons_.push_back(button);
  lay();
  return button;
}

QAction* Sidebar::addScreen(Screen* screen) {
  auto* action = new QAction(icon(screen->iconName()), screen->title(), this);
  action->setObjectName(QStringLiteral("screen_") + screen->iconName());
  action->setCheckable(true);
  const int index = screens_++;
  action->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + index)));
  group_->addAction(action);
  QToolButton* button = addButton(action, index);
  connect(action, &QAction::triggered, this, [this, index] { emit selectedChanged(index); });
  connect(screen, &Screen::waitingChanged, this,
          [this, screen, action, button] { showCount(screen, action, button); });
  showCount(screen, action, button);
  return action;
}

QAction* Sidebar::addFoot(const QString& icon_name, const QString& text, const QKeySequence& key) {
  auto* action = new QAction(icon(icon_name), text, this);
  action->setObjectName(QStringLiteral("foot_") + icon_name);
  action->setShortcut(key);
  QToolButton* button = addButton(action, column_->count());
  button->setAccessibleName(text);
  button->setToolTip(QStringLiteral("%1 (%2)").arg(text, keyText(key)));
  return action;
}

void Sidebar::select(int index) {
  if (index < 0 || index >= screens_) return;
  QAction* action = group_->actions().at(index);
  if (!action->isChecked()) action->setChecked(true);
}

int Sidebar::selected() const {
  return group_->checkedAction() == nullptr
             ? -1
             : static_cast<int>(group_->actions().indexOf(group_->checkedAction()));
}

void Sidebar::showCount(Screen* screen, QAction* action, QToolButton* button) {
  const int count = screen->waiting();
  const QString key = keyText(action->shortcut());
  action->setText(count > 0 ? tr("%1  %2").arg(screen->title()).arg(count) : screen->title());
  button->setAccessibleName(count > 0 && !screen->waitingText().isEmpty()
                                ? tr("%1: %2").arg(screen->title(), screen->waitingText())
                                : screen->title());
  action->setToolTip(count > 0 ? QStringLiteral("%1 (%2)").arg(screen->waitingText(), key)
                               : QStringLiteral("%1 (%2)").arg(screen->title(), key));
  QFont font = button->font();
  font.setBold(count > 0);
  button->setFont(font);
  lay();
}

void Sidebar::fit(const QSize& window) {
  if (window == window_) return;
  window_ = window;
  lay();
}

void Sidebar::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::FontChange) lay();
}

void Sidebar::lay() {
  // Wide enough for the longest word with a count, so that nothing moves.
  const auto widest = [this](const QFont& font, const QString& count) {
    int width = 0;
    for (const QToolButton* button : buttons_)
      width = qMax(width, QFontMetrics(font).horizontalAdvance(
                              button->text().section(QStringLiteral("  "), 0, 0) + count));
    return width;
  };
  const int letter = fontMetrics().height();
  int picture = qMax(Look::kIcon, letter);
  QFont font = this->font();
  font.setBold(true);
  int width = widest(font, QStringLiteral("  000")) + picture + letter * 3 / 2;
  // Large letters on a small screen: the words go below their pictures and leave room to the work.
  const bool compact = window_.height() < Look::kCompactBelow;
  const bool narrow = compact || width > window_.width() / 6;
  if (narrow) {
    font.setPointSizeF(kNarrow * font.pointSizeF());
    picture = letter;
    width = widest(font, QStringLiteral("  00")) + letter / 2;
  }
  for (QToolButton* button : buttons_) {
    font.setBold(button->font().bold());
    button->setFont(font);
    button->setToolButtonStyle(narrow ? Qt::ToolButtonTextUnderIcon : Qt::ToolButtonTextBesideIcon);
    button->setMinimumSize(width, compact ? 0 : targetSize(*this));
    button->setIconSize(QSize(picture, picture));
  }
}

}  // namespace ostraka::ui
