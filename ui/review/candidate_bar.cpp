#include "ui/review/candidate_bar.h"

#include <QEvent>
#include <QMenu>
#include <QToolButton>

#include "ui/frame/flow_row.h"
#include "ui/frame/look.h"
#include "ui/frame/state_colours.h"
#include "ui/review/pair_review_model.h"
#include "ui/review/review_words.h"

namespace ostraka::ui {

CandidateBar::CandidateBar(PairReviewModel& model, QWidget* parent)
    : QWidget(parent), model_(model) {
  row_ = new FlowRow(this);
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  others_ = new QToolButton(this);
  others_->setObjectName("otherBacks");
  others_->setText(tr("Another back …"));
  others_->setPopupMode(QToolButton::InstantPopup);
  others_->setMinimumHeight(targetSize(*this));
  others_->setFocusPolicy(Qt::TabFocus);
  others_->setMenu(new QMenu(others_));
  connect(others_->menu(), &QMenu::aboutToShow, this, &CandidateBar::fillOthers);
  row_->addWidget(others_);
  connect(&model_, &PairReviewModel::candidatesChanged, this, &CandidateBar::rebuild);
  connect(&model_, &PairReviewModel::trialChanged, this, &CandidateBar::mark);
  connect(&model_, &PairReviewModel::waitingChanged, this, &CandidateBar::rebuild);
  rebuild();
}

void CandidateBar::rebuild() {
  for (QToolButton* button : buttons_) button->deleteLater();
  buttons_.clear();
  const auto& candidates = model_.candidates();
  // Nine keys; the rest is in the menu.
  const int shown = std::min<int>(5, static_cast<int>(candidates.size()));
  for (int i = 0; i < shown; ++i) {
    const pipeline::ReviewCandidate& c = candidates[static_cast<std::size_t>(i)];
    const QString back =
        QString::fromStdString(model_.live()->table().backs[static_cast<std::size_t>(c.back)].id);
    const QString score = c.score > 0 ? percent(c.score) : tr("under 1 %");
    QString second = c.rim_rms_mm > 0 ? tr("rim %1").arg(mm(c.rim_rms_mm)) : tr("no rim");
    const int holder = model_.holderOf(c.back);
    if (holder >= 0 && holder != model_.front())
      second =
          tr("%1, with %2")
              .arg(second, QString::fromStdString(
                               model_.live()->table().fronts[static_cast<std::size_t>(holder)].id));
    auto* button = new QToolButton(this);
    button->setObjectName(QStringLiteral("candidate%1").arg(i + 1));
    button->setCheckable(true);
    button->setText(tr("%1   %2   %3\n%4").arg(QString::number(i + 1), back, score, second));
    button->setAccessibleName(
        tr("Candidate %1: %2, %3, %4").arg(QString::number(i + 1), back, score, second));
    button->setMinimumHeight(targetSize(*this));
    button->setFocusPolicy(Qt::TabFocus);
    button->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    connect(button, &QToolButton::clicked, &model_, [this, i] { model_.choose(i); });
    row_->insertWidget(i, button);
    buttons_.append(button);
  }
  others_->setEnabled(model_.isOpen() && model_.front() >= 0);
  mark();
}

void CandidateBar::mark() {
  const StateColours colours(palette());
  for (int i = 0; i < buttons_.size(); ++i) {
    const bool chosen = i == model_.chosen();
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
  if (!model_.isOpen()) return;
  const auto& backs = model_.live()->table().backs;
  for (int b = 0; b < static_cast<int>(backs.size()); ++b) {
    const int holder = model_.holderOf(b);
    const QString id = QString::fromStdString(backs[static_cast<std::size_t>(b)].id);
    const QString words =
        holder < 0
            ? tr("%1, nobody's").arg(id)
            : tr("%1, with %2")
                  .arg(id, QString::fromStdString(
                               model_.live()->table().fronts[static_cast<std::size_t>(holder)].id));
    connect(menu->addAction(words), &QAction::triggered, &model_,
            [this, b] { model_.chooseBack(b); });
  }
}

}  // namespace ostraka::ui
