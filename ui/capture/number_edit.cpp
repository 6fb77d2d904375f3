#include "ui/capture/number_edit.h"

#include <QFocusEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>

#include "ui/look/look.h"
#include "ui/widgets/parts.h"
#include "ui/wizard/sherd_numbers.h"

namespace ostraka::ui {

NumberEdit::NumberEdit(SherdNumbers* numbers, QWidget* parent)
    : QWidget(parent),
      numbers_(numbers),
      label_(new QLabel(this)),
      note_(wrappedLabel(this, QStringLiteral("sherdNumberNote"))),
      edit_(named<QLineEdit>("sherdNumber", this)) {
  edit_->setPlaceholderText(tr("7, the whole number, or scan its label"));
  edit_->setMinimumHeight(targetSize(*this));
  edit_->setMinimumWidth(fontMetrics().averageCharWidth() * 34);
  edit_->installEventFilter(this);
  label_->setBuddy(edit_);
  filled(bareLayout<QHBoxLayout>(this), {label_, edit_, {note_, 1}});
  connect(edit_, &QLineEdit::returnPressed, this, &NumberEdit::keep);
  connect(numbers_, &SherdNumbers::changed, this, [this] {
    if (sherd_ >= numbers_->count()) sherd_ = 0;
    if (!edit_->hasFocus()) showSherd(sherd_);
  });
  showSherd(0);
}

void NumberEdit::choose(int sherd) {
  if (sherd != sherd_) {
    // Whoever points at another sherd types that one's number next.
    const int before = sherd_;
    const QString refused = give() ? QString() : note_->text();
    const QString doubt = numbers_->doubtOf(before);
    showSherd(sherd);
    if (!doubt.isEmpty()) note_->setText(doubt);
    if (!refused.isEmpty())
      note_->setText(tr("Sherd %1 got no number. %2").arg(before + 1).arg(refused));
  }
  edit_->setFocus();
  edit_->selectAll();
}

void NumberEdit::showSherd(int sherd) {
  sherd_ = sherd;
  const QString words = tr("&Number of sherd %1").arg(sherd + 1);
  label_->setText(words);
  edit_->setAccessibleName(QString(words).remove(QLatin1Char('&')));
  edit_->setText(numbers_->of(sherd));
  const QString doubt = numbers_->doubtOf(sherd);
  note_->setText(
      doubt.isEmpty()
          ? tr("If they have numbers already: each follows its sherd through the flip. Key N.")
          : doubt);
  emit chosen(sherd);
}

bool NumberEdit::give() {
  if (edit_->text().trimmed() == numbers_->of(sherd_)) return true;
  const QString why = numbers_->give(sherd_, edit_->text());
  if (!why.isEmpty()) note_->setText(why);
  return why.isEmpty();
}

bool NumberEdit::keepTyped() {
  if (give()) return true;
  edit_->setFocus();
  edit_->selectAll();
  return false;
}

void NumberEdit::keep() {
  if (!keepTyped()) return;
  if (sherd_ + 1 < numbers_->count()) return choose(sherd_ + 1);
  showSherd(sherd_);
  emit finished();
}

bool NumberEdit::eventFilter(QObject* watched, QEvent* event) {
  if (watched == edit_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const int by = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
    if (by != 0 && sherd_ + by >= 0 && sherd_ + by < numbers_->count() && keepTyped())
      choose(sherd_ + by);
    if (by != 0) return true;
    if (key == Qt::Key_Escape) {
      showSherd(sherd_);
      emit finished();
      return true;
    }
  }
  if (watched == edit_ && event->type() == QEvent::FocusOut) {
    const Qt::FocusReason why = static_cast<QFocusEvent*>(event)->reason();
    if (why != Qt::ActiveWindowFocusReason && why != Qt::PopupFocusReason) give();
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace ostraka::ui
