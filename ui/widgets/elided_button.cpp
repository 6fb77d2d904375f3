#include "ui/widgets/elided_button.h"

#include <QStyleOptionButton>
#include <QStylePainter>

namespace ostraka::ui {

ElidedButton::ElidedButton(const QIcon& icon, const QString& text, QWidget* parent)
    : QPushButton(icon, text, parent) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);  // it may shrink
}

QSize ElidedButton::minimumSizeHint() const {
  const QSize whole = QPushButton::minimumSizeHint();
  return {qMin(whole.width(), iconSize().width() + fontMetrics().averageCharWidth() * 16),
          whole.height()};
}

QString ElidedButton::shownText() const {
  QStyleOptionButton option;
  initStyleOption(&option);
  const int letter = fontMetrics().averageCharWidth();
  const int room = style()->subElementRect(QStyle::SE_PushButtonContents, &option, this).width() -
                   (icon().isNull() ? 0 : iconSize().width() + letter);
  return fontMetrics().elidedText(text(), Qt::ElideMiddle, room);
}

void ElidedButton::paintEvent(QPaintEvent*) {
  QStylePainter painter(this);
  QStyleOptionButton option;
  initStyleOption(&option);
  option.text = shownText();
  setToolTip(option.text == text() ? QString() : text());
  painter.drawControl(QStyle::CE_PushButton, option);
}

}  // namespace ostraka::ui
