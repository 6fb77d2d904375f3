#include "ui/capture/place_edit.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>

#include "ui/frame/look.h"

namespace ostraka::ui {

PlaceEdit::PlaceEdit(QWidget* parent)
    : QWidget(parent), edit_(new QLineEdit(this)), note_(new QLabel(this)) {
  auto* label = new QLabel(tr("&Bag"), this);
  label->setBuddy(edit_);
  edit_->setObjectName(QStringLiteral("capturePlace"));
  edit_->setPlaceholderText(tr("scan its label, or ARM1-T3-0012-4"));
  edit_->setAccessibleDescription(tr("Site, trench, context and bag"));
  edit_->setMinimumHeight(targetSize(*this));
  edit_->setMinimumWidth(fontMetrics().averageCharWidth() * 24);
  note_->setWordWrap(true);  // long words of another language would widen the window
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(label);
  row->addWidget(edit_, 1);
  row->addWidget(note_);
  connect(edit_, &QLineEdit::returnPressed, this, &PlaceEdit::entered);
  connect(edit_, &QLineEdit::textEdited, this, [this] {
    follow();
    emit edited();
  });
  follow();
}

void PlaceEdit::setReader(std::function<std::optional<PlaceText>(const QString&)> reader) {
  reader_ = reader ? std::move(reader) : readPlaceText;
}

void PlaceEdit::setText(const QString& text) {
  edit_->setText(text);
  follow();
}

QString PlaceEdit::text() const {
  return edit_->text().trimmed();
}

PlaceText PlaceEdit::place() const {
  return reader_(text()).value_or(PlaceText());
}

bool PlaceEdit::isUsable() const {
  return text().isEmpty() || reader_(text()).has_value();
}

void PlaceEdit::follow() {
  note_->setText(text().isEmpty() ? tr("no bag: no numbers yet")
                 : isUsable()     ? QString()
                                  : tr("site-trench-context-bag, please"));
}

}  // namespace ostraka::ui
