#include "ui/import/import_ask.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include "ui/import/place_edit.h"
#include "ui/import/sides_view.h"
#include "ui/look/look.h"
#include "ui/widgets/big_button.h"
#include "ui/widgets/message_panel.h"
#include "ui/widgets/page_area.h"
#include "ui/widgets/parts.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {

ImportAsk::ImportAsk(QWidget* parent)
    : QWidget(parent),
      words_(new QLabel(this)),
      sides_(new SidesView(this)),
      place_(new PlaceEdit(this)),
      labels_(wrappedLabel(this, QStringLiteral("importLabels"))),
      label_doubt_(new MessagePanel(QStringLiteral("importLabelDoubt"), this)),
      reason_(wrappedLabel(this, QStringLiteral("importReason"))) {
  setObjectName(QStringLiteral("importAsk"));
  words_->setWordWrap(true);
  reason_->setText(
      tr("To import, confirm or move the division between front and back, or choose one side "
         "only."));
  label_doubt_->setCompact(true);
  import_ = new BigButton(QStringLiteral("importStart"), tr("Import"), this);
  import_->setKeyHint(tr("Enter"));
  auto* leave = named<QPushButton>("importLeave", tr("Cancel import"), this);
  for (QPushButton* button : {static_cast<QPushButton*>(import_), leave})
    button->setMinimumHeight(targetSize(*this));
  auto* row = filled(new QHBoxLayout, {{place_, 1}, import_, leave});
  auto* middle = new QWidget(this);
  filled(bareLayout<QVBoxLayout>(middle), {words_, sides_, Part::room()});
  // What is looked at is scrolled where it finds no room; what decides, and why not, is not.
  filled(bareLayout<QVBoxLayout>(this),
         {{new PageArea(middle, this), 1}, reason_, label_doubt_, labels_, place_->note(), row});
  connect(import_, &QPushButton::clicked, this, &ImportAsk::confirm);
  connect(leave, &QPushButton::clicked, this, &ImportAsk::leave);
  connect(place_, &PlaceEdit::entered, this, &ImportAsk::confirm);
  connect(place_, &PlaceEdit::edited, this, &ImportAsk::follow);
  connect(place_, &PlaceEdit::edited, this, &ImportAsk::placeEdited);
  connect(sides_, &SidesView::changed, this, &ImportAsk::follow);
  connect(sides_, &SidesView::sheetPrinted, this,
          [this](const QString& headline, const QString& words) {
            words_->setText(headline + QLatin1Char('\n') + words);
          });
  connect(sides_, &SidesView::sheetNotPrinted, this,
          [this](const Error& error) { words_->setText(sentenceOf(error)); });
  hide();
}

void ImportAsk::ask(const QString& folder, ImportKind kind) {
  sides_->hide();
  codes_.clear();
  open(folder, kind);
}

void ImportAsk::askSides(const SidesPlan& plan) {
  codes_.clear();
  sides_->show();
  sides_->setPlan(plan);
  open(plan.from, ImportKind::Photographs);
}

bool ImportAsk::isReady() const {
  return place_->isUsable() && areSidesDecided();
}

bool ImportAsk::areSidesDecided() const {
  return sides_->isHidden() || sides_->plan().isDecided();
}

// What is wrong with the bag is said in its own note.
void ImportAsk::follow() {
  import_->setEnabled(isReady());
  reason_->setVisible(!areSidesDecided());
  followLabels();
}

void ImportAsk::takeCodes(std::vector<capture::PhotographCodes> seen) {
  codes_ = std::move(seen);
  const auto bag = labels().bag();
  if (bag && place_->text().isEmpty()) {
    place_->setText(bag->typed());
    if (place_->isAncestorOf(focusWidget()))
      place_->choose();  // what is typed elsewhere stays there
  }
  follow();
  emit placeEdited();
}

SideLabels ImportAsk::labels() const {
  return labelsOf(codes_, sides_->plan().sides(),
                  [this](const QString& code) { return place_->read(code); });
}

void ImportAsk::followLabels() {
  const SideLabels found = labels();
  const QString doubt = found.doubt(place_->place());
  if (doubt.isEmpty())
    label_doubt_->hide();
  else
    label_doubt_->showWords(State::Ask, tr("Check this first"), doubt);
  const auto bag = found.bag();
  const bool named = bag && doubt.isEmpty() && !place_->text().isEmpty();
  if (named) labels_->setText(tr("The label in the photographs names %1.").arg(bag->words()));
  labels_->setVisible(named);
}

void ImportAsk::open(const QString& folder, ImportKind kind) {
  folder_ = folder;
  kind_ = kind;
  words_->setText(tr("From %1. The bag can also be given later, in the catalogue.").arg(folder));
  place_->setText({});  // the bag on the turntable is another, mostly
  askAgain();
}

void ImportAsk::askAgain() {
  follow();
  show();
  emit asked();
  place_->choose();
}

void ImportAsk::confirm() {
  if (!isVisible() || !isReady()) return;
  hide();
  std::optional<ImportSides> sides;
  if (!sides_->isHidden()) sides = sides_->plan().sides();
  emit confirmed(folder_, kind_, place_->place(), sides);
}

void ImportAsk::leave() {
  hide();
  emit left();
}

void ImportAsk::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) return leave();
  QWidget::keyPressEvent(event);
}

}  // namespace ostraka::ui
