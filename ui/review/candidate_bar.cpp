#include "ui/review/candidate_bar.h"

#include <QEvent>
#include <QMenu>
#include <QToolButton>

#include "ui/look/look.h"
#include "ui/look/state_colours.h"
#include "ui/pairs/free_words.h"
#include "ui/pairs/pair_review.h"
#include "ui/pairs/review_words.h"
#include "ui/widgets/flow_row.h"
#include "ui/widgets/parts.h"

namespace ostraka::ui {
namespace {

constexpr int kMost = 5, kMostCompact = 2;  // the others are in the menu

}  // namespace

CandidateBar::CandidateBar(PairReview& review, QWidget* parent)
    : QWidget(parent), review_(review), hand_(review.hand()), most_(kMost) {
  row_ = new FlowRow(this);
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  others_ = named<QToolButton>("otherBacks", this);
  others_->setText(tr("Another back…"));
  others_->setPopupMode(QToolButton::InstantPopup);
  others_->setFocusPolicy(Qt::TabFocus);
  others_->setMenu(new QMenu(others_));
  connect(others_->menu(), &QMenu::aboutToShow, this, &CandidateBar::fillOthers);
  connect(&hand_, &CardInHand::candidatesChanged, this, &CandidateBar::rebuild);
  connect(&hand_, &CardInHand::trialChanged, this, &CandidateBar::mark);
  connect(&hand_, &CardInHand::sceneChanged, this, &CandidateBar::mark);
  connect(&review_, &PairReview::waitingChanged, this, &CandidateBar::rebuild);
  rebuild();
}

void CandidateBar::setCompact(bool compact) {
  if (most_ == (compact ? kMostCompact : kMost)) return;
  most_ = compact ? kMostCompact : kMost;
  rebuild();
}

void CandidateBar::rebuild() {
  for (QToolButton* button : buttons_) button->deleteLater();
  buttons_.clear();
  const auto& candidates = hand_.candidates();
  // Nine keys; the rest is in the menu.
  const int shown = std::min(most_, static_cast<int>(candidates.size()));
  for (int i = 0; i < shown; ++i) {
    auto* button = named<QToolButton>(QStringLiteral("candidate%1").arg(i + 1), this);
    button->setCheckable(true);
    button->setMinimumHeight(targetSize(*this));
    button->setFocusPolicy(Qt::TabFocus);
    button->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    connect(button, &QToolButton::clicked, &review_, [this, i] { hand_.choose(i); });
    row_->insertWidget(i, button);
    buttons_.append(button);
  }
  others_->setEnabled(review_.batch().isOpen() && hand_.front() >= 0);
  mark();
}

// Of the one in hand what is shown, of the others what the program found.
void CandidateBar::write(int i) {
  const review::ReviewCandidate& c = hand_.candidates()[static_cast<std::size_t>(i)];
  const decisions::CandidateTable& table = review_.batch().table();
  const bool tried = i == hand_.chosen() && hand_.trial().made != Made::Program;
  const double fracture = !tried               ? c.fracture_rms_mm
                          : hand_.isMeasured() ? hand_.fit().fracture_rms_mm
                                               : 0;
  const QString back = nameOf(table.backs, c.back);
  const QString score = tried ? madeWord(hand_.trial().made) : scoreWords(c.score);
  QString second = fracture > 0 ? tr("gap %1").arg(mm(fracture))
                   : tried      ? tr("no contact")
                                : tr("by outline alone");
  const int holder = review_.batch().holderOf(c.back);
  if (holder >= 0 && holder != hand_.front())
    second = tr("%1, with %2").arg(second, nameOf(table.fronts, holder));
  QToolButton* button = buttons_[i];
  button->setText(tr("%1   %2   %3\n%4").arg(QString::number(i + 1), back, score, second));
  button->setAccessibleName(
      tr("Candidate %1: %2, %3, %4").arg(QString::number(i + 1), back, score, second));
}

void CandidateBar::mark() {
  const StateColours colours(palette());
  for (int i = 0; i < buttons_.size(); ++i) {
    const bool chosen = i == hand_.chosen();
    write(i);
    QFont font = this->font();
    font.setBold(chosen);
    QPalette look;
    if (chosen) look.setColor(QPalette::Button, colours.behind(State::Selected));
    buttons_[i]->setChecked(chosen);
    buttons_[i]->setFont(font);
    buttons_[i]->setPalette(look);
  }
}

void CandidateBar::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) mark();
}

void CandidateBar::fillOthers() {
  QMenu* menu = others_->menu();
  menu->clear();
  if (!review_.batch().isOpen()) return;
  const decisions::CandidateTable& table = review_.batch().table();
  for (int b = 0; b < static_cast<int>(table.backs.size()); ++b) {
    const int holder = review_.batch().holderOf(b);
    const QString name = nameOf(table.backs, b);
    const QString words = holder < 0 ? tr("%1, nobody's").arg(name)
                                     : tr("%1, with %2").arg(name, nameOf(table.fronts, holder));
    connect(menu->addAction(words), &QAction::triggered, &review_,
            [this, b] { hand_.chooseBack(b); });
  }
}

}  // namespace ostraka::ui
