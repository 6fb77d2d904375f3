#include "ui/sherds/filter_line.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>

#include "ui/look/look.h"
#include "ui/sherds/field_words.h"
#include "ui/widgets/parts.h"

namespace ostraka::ui {
namespace {

constexpr int kTypingPause_ms = 150;

}  // namespace

FilterLine::FilterLine(QWidget* parent)
    : QWidget(parent),
      line_(named<QLineEdit>({"filter", tr("Filter of the catalogue")}, this)),
      typing_(new QTimer(this)),
      row_(new QHBoxLayout),
      chips_(new QHBoxLayout),
      count_(named<QLabel>("count", this)) {
  line_->setPlaceholderText(tr("rim T3 thickness>6"));
  line_->setToolTip(
      tr("Words are looked for everywhere; ware:grey, thickness>6, entered>=2026-07-01, -burnt, "
         "note:* also work."));
  line_->setClearButtonEnabled(true);
  line_->addAction(icon("search"), QLineEdit::LeadingPosition);
  typing_->setSingleShot(true);
  typing_->setInterval(kTypingPause_ms);
  connect(line_, &QLineEdit::textChanged, typing_, qOverload<>(&QTimer::start));
  connect(line_, &QLineEdit::returnPressed, this, &FilterLine::ask);
  connect(typing_, &QTimer::timeout, this, &FilterLine::ask);
  row_->addWidget(line_, 1);
  auto* below = filled(new QHBoxLayout, {chips_, Part::room(), count_});
  filled(bareLayout<QVBoxLayout>(this), {row_, below});
}

void FilterLine::addButton(QPushButton* button) {
  row_->addWidget(button);
}

QString FilterLine::text() const {
  return line_->text();
}

void FilterLine::setText(const QString& line) {
  line_->setText(line);
  ask();
}

void FilterLine::clear() {
  line_->clear();
  typing_->stop();
  showConditions({});
}

void FilterLine::takeKeys() {
  line_->setFocus(Qt::ShortcutFocusReason);
  line_->selectAll();
}

void FilterLine::ask() {
  typing_->stop();
  emit wanted(line_->text());
}

void FilterLine::showConditions(const sherds::Filter& filter) {
  while (QLayoutItem* item = chips_->takeAt(0)) {
    if (item->widget()) item->widget()->deleteLater();
    delete item;
  }
  for (std::size_t i = 0; i < filter.conditions.size(); ++i) {
    sherds::Filter fewer = filter;
    fewer.conditions.erase(fewer.conditions.begin() + static_cast<std::ptrdiff_t>(i));
    const QString text = conditionText(filter.conditions[i]);
    auto* chip = named<QToolButton>({"chip", tr("Remove the condition %1").arg(text)}, this);
    chip->setText(text);
    chip->setIcon(icon("cancel"));
    chip->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    connect(chip, &QToolButton::clicked, this,
            [this, line = QString::fromStdString(fewer.text())] { setText(line); });
    chips_->addWidget(chip);
  }
}

void FilterLine::showCount(int sherds) {
  count_->setText(tr("%n sherd(s)", nullptr, sherds));
}

}  // namespace ostraka::ui
