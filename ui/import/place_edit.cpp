#include "ui/import/place_edit.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>

#include "ui/look/look.h"

namespace ostraka::ui {

PlaceEdit::PlaceEdit(QWidget* parent)
    : QWidget(parent),
      edit_(new QLineEdit(this)),
      note_(wrappedLabel(this, QStringLiteral("capturePlaceNote"))) {
  auto* label = new QLabel(tr("&Bag"), this);
  label->setBuddy(edit_);
  edit_->setObjectName(QStringLiteral("capturePlace"));
  edit_->setAccessibleDescription(tr("Site, trench, context and bag"));
  edit_->setMinimumHeight(targetSize(*this));
  edit_->installEventFilter(this);
  auto* row = bareLayout<QHBoxLayout>(this);
  row->addWidget(label);
  row->addWidget(edit_, 1);
  connect(edit_, &QLineEdit::editingFinished, this, [this] {
    if (isUsable()) emit settled();
  });
  connect(edit_, &QLineEdit::returnPressed, this, &PlaceEdit::entered);
  connect(edit_, &QLineEdit::textEdited, this, [this] {
    follow();
    emit edited();
  });
  setSite({});
  setCompact(false);
  follow();
}

void PlaceEdit::setSite(const QString& code) {
  edit_->setPlaceholderText(
      tr("scan its label, or %1-T3-0012-4").arg(code.isEmpty() ? QStringLiteral("ARM1") : code));
}

void PlaceEdit::setReader(std::function<std::optional<PlaceText>(const QString&)> reader) {
  reader_ = reader ? std::move(reader) : readPlaceText;
}

void PlaceEdit::setNews(std::function<QString(const PlaceText&)> news) {
  news_ = std::move(news);
  known_.clear();
  follow();
}

bool PlaceEdit::eventFilter(QObject* watched, QEvent* event) {
  const bool key = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
  if (watched != edit_ || !key || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape ||
      text() == known_)
    return QWidget::eventFilter(watched, event);
  event->accept();
  if (event->type() == QEvent::ShortcutOverride) return true;
  setText(known_);
  emit edited();
  return true;
}

void PlaceEdit::setText(const QString& text) {
  edit_->setText(text);
  follow();
}

QString PlaceEdit::text() const {
  return edit_->text().trimmed();
}

void PlaceEdit::setCompact(bool compact) {
  edit_->setMinimumWidth(fontMetrics().averageCharWidth() * (compact ? 14 : 24));
}

void PlaceEdit::choose() {
  edit_->setFocus();
  edit_->selectAll();
}

PlaceText PlaceEdit::place() const {
  return reader_(text()).value_or(PlaceText());
}

bool PlaceEdit::isUsable() const {
  return text().isEmpty() || reader_(text()).has_value();
}

void PlaceEdit::follow() {
  const QString words = noteWords();
  note_->setText(words);
  const bool put_away = testAttribute(Qt::WA_WState_ExplicitShowHide) && isHidden();
  note_->setVisible(!words.isEmpty() && !put_away);
}

QString PlaceEdit::noteWords() {
  if (text().isEmpty()) {
    known_.clear();
    return tr("No bag: the sherds can be numbered once the catalogue gives them a context.");
  }
  if (!isUsable()) return tr("Write the bag as site-trench-context-bag.");
  const QString news = news_ ? news_(place()) : QString();
  if (news.isEmpty()) known_ = text();
  return news.isEmpty() ? QString() : tr("New: %1").arg(news);
}

}  // namespace ostraka::ui
