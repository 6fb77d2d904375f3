#include "ui/capture/fact_list.h"

#include <QApplication>
#include <QLabel>
#include <QVBoxLayout>
#include <memory>

#include "ui/look/look.h"
#include "ui/look/state_colours.h"

namespace ostraka::ui {

FactList::FactList(QWidget* parent) : QWidget(parent), column_(new QVBoxLayout(this)) {
  setMinimumWidth(fontMetrics().averageCharWidth() * 26);
  column_->addStretch(1);
}

void FactList::setFacts(const std::vector<CaptureFact>& facts) {
  const auto wanted = static_cast<int>(facts.size());
  while (column_->count() > wanted + 1) {
    const std::unique_ptr<QLayoutItem> item(column_->takeAt(column_->count() - 2));
    item->widget()->deleteLater();
  }
  while (column_->count() < wanted + 1) {
    auto* label = new QLabel(this);
    label->setWordWrap(true);
    column_->insertWidget(column_->count() - 1, label);
  }
  for (int i = 0; i < wanted; ++i) {
    const CaptureFact& fact = facts[static_cast<std::size_t>(i)];
    auto* label = static_cast<QLabel*>(column_->itemAt(i)->widget());
    label->setText((fact.good ? QStringLiteral("✓  ") : QStringLiteral("!  ")) + fact.words);
    QPalette ink;  // the one colour only: all others follow the theme
    if (!fact.good)
      ink.setColor(QPalette::WindowText, StateColours(QApplication::palette()).of(State::Ask));
    label->setPalette(ink);
    label->setFont(scaledFont(*this, Look::kSection, true));
  }
}

}  // namespace ostraka::ui
