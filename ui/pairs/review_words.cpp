#include "ui/pairs/review_words.h"

#include <QLocale>
#include <cmath>

#include "base/text.h"
#include "ui/pairs/free_words.h"

namespace ostraka::ui {
namespace {

using decisions::CandidateTable;
using pairing::Doubt;
using registration::FailedCheck;
using review::CardState;
using review::ReviewCard;

constexpr double kToldApart = 0.05;  // chances that differ by more are not the same to a person

// Names that begin a sentence.
QString capitalised(QString sentence) {
  return sentence.isEmpty() ? sentence : sentence.replace(0, 1, sentence.at(0).toUpper());
}

QString rivalSentence(const ReviewCard& card, const CandidateTable& table) {
  const double apart = std::abs(card.fracture_rms_mm - card.rival_fracture_rms_mm);
  const bool fractures = card.fracture_rms_mm > 0 && card.rival_fracture_rms_mm > 0;
  if (card.rival_back >= 0)
    return capitalised((fractures ? tr("%1 and %2 both fit %3: their fractures differ by only %4.")
                                  : tr("%1 and %2 both fit %3."))
                           .arg(nameOf(table.backs, card.back),
                                nameOf(table.backs, card.rival_back),
                                nameOf(table.fronts, card.front), mm(apart)));
  if (card.rival_front >= 0)
    return capitalised(
        tr("%1 would fit %2 almost as well.")
            .arg(nameOf(table.backs, card.back), nameOf(table.fronts, card.rival_front)));
  return tr("Another partner fits almost as well.");
}

QString askSentence(const ReviewCard& card, const CandidateTable& table, const CardStory& story) {
  switch (card.doubt) {
    case Doubt::Displaced:
      if (story.lost_back >= 0)
        return tr("Its back %1 was given to %2: is %3 the right one now?")
            .arg(plainNumber(table.backs, story.lost_back), nameOf(table.fronts, story.lost_to),
                 nameOf(table.backs, card.back));
      return tr("Its back was given to another front: is %1 the right one now?")
          .arg(nameOf(table.backs, card.back));
    case Doubt::OtherPartner:
      return rivalSentence(card, table);
    case Doubt::Unrelated:
      return capitalised(
          tr("%1 fits barely better than an unrelated back.").arg(nameOf(table.backs, card.back)));
    case Doubt::OtherPose:
      return tr("Ambiguous: a second position fits almost as well.");
    case Doubt::NotSure:
      return tr("%1 confident; below %2, a person decides.")
          .arg(scoreWords(card.score), percent(pairing::AssignOptions().flag_below));
    case Doubt::SharedBack:
      return tr("Another front takes the same back.");
    case Doubt::SelfCheck:
      return failedCheckSentence(card.failed_check, card.check_value);
    case Doubt::None:
      break;
  }
  return {};
}

QString aloneSentence(const CandidateTable& table, const CardStory& story) {
  if (story.lost_back < 0) return tr("No back was found for it. Choose one, or set it aside.");
  const QString lost = plainNumber(table.backs, story.lost_back),
                to = nameOf(table.fronts, story.lost_to);
  if (!story.next)
    return tr("Its back %1 was given to %2. Choose another one, or set it aside.").arg(lost, to);
  return tr("Its back %1 was given to %2; next best %3, %4.")
      .arg(lost, to, nameOf(table.backs, story.next->back), scoreWords(story.next->score));
}

// What was decided for others may leave a front one back only; its candidates' chances are those
// before any decision.
QString sureSentence(const ReviewCard& card) {
  if (!card.score) return tr("The nearest outline; no probability is known.");
  for (const review::ReviewCandidate& own : card.candidates)
    if (own.back == card.back && own.score < *card.score - kToldApart)
      return tr("Sure by what was decided for others: %1; by itself %2.")
          .arg(percent(*card.score), scoreWords(own.score));
  return tr("%1 confident").arg(percent(*card.score));
}

}  // namespace

QString scoreWords(std::optional<double> score) {
  if (!score) return tr("no probability");
  return *score > 0 ? percent(*score) : tr("under 1 %");
}

QString mm(double value, int digits) {
  return tr("%1 mm").arg(QLocale().toString(value, 'f', digits));
}

QString percent(double share) {
  if (share > 0 && share < 0.01) return tr("under 1 %");
  return tr("%1 %").arg(QLocale().toString(wholePercent(share)));
}

QString failedCheckSentence(FailedCheck failed_check, double value) {
  switch (failed_check) {
    case FailedCheck::UpsideDown:
      return tr("The back lies upside down: both sides face the same way.");
    case FailedCheck::FacesCross:
      return tr("The faces cross: %1 of the front lies behind the back.").arg(percent(value));
    case FailedCheck::NoSharedFracture:
      return value < 0.02 ? tr("The two scans share almost no fracture; only their outlines match.")
                          : tr("The two scans share only %1 of the fracture.").arg(percent(value));
    case FailedCheck::FractureMisfits:
      return tr("The fractures do not fit: %1 apart.").arg(mm(value));
    case FailedCheck::FractureLoose:
      return tr("The fracture barely fixes the position: uncertain by %1.").arg(mm(value));
    case FailedCheck::RivalPlace:
      return tr("A position %1 along the contour fits almost as well.").arg(mm(value, 1));
    case FailedCheck::OutlinesAlone:
      return tr("The fractures cannot be compared; only the outlines match.");
    case FailedCheck::None:
      break;
  }
  return {};
}

QString stateWord(CardState state) {
  switch (state) {
    case CardState::Ask:
      return tr("Check");
    case CardState::Alone:
      return tr("No back");
    case CardState::Sure:
      return tr("Sure");
    case CardState::Decided:
      return tr("Decided");
    case CardState::Aside:
      return tr("Set aside");
    case CardState::Reshoot:
      return tr("Reshoot");
  }
  return {};
}

State stateColour(CardState state) {
  switch (state) {
    case CardState::Ask:
    case CardState::Alone:
      return State::Ask;
    case CardState::Reshoot:
      return State::Failed;
    case CardState::Aside:
      return State::Aside;
    default:
      return State::Sure;
  }
}

QString hardlyMeetSentence(const review::LiveFit& fit) {
  return tr("Only %1 of the fractures touch.").arg(percent(fit.fracture_overlap));
}

QString madeWord(Made made) {
  switch (made) {
    case Made::ByHand:
      return tr("by hand");
    case Made::StartPoint:
      return tr("start point");
    case Made::Settled:
      return tr("refined");
    case Made::Program:
      break;
  }
  return {};
}

QString triedSentence(const Trial& trial, std::optional<double> score, const review::LiveFit* fit,
                      const ReviewCard& card, const CandidateTable& table) {
  const QString back = nameOf(table.backs, trial.back);
  const QString chance = scoreWords(score), meets = percent(fit ? fit->fracture_overlap : 0);
  QString text;
  if (trial.made == Made::ByHand)
    text =
        fit ? tr("Turned by hand: %1 of the fractures touch.").arg(meets) : tr("Turned by hand.");
  else if (trial.made == Made::StartPoint)
    text = fit ? tr("Trying another start point: %1 of the fractures touch.").arg(meets)
               : tr("Trying another start point.");
  else if (trial.made == Made::Settled)
    text = fit ? tr("Refined by the fractures: %1 of them touch.").arg(meets)
               : tr("Refined by the fractures.");
  else if (!fit)
    text = tr("Trying %1: %2.").arg(back, chance);
  else if (fit->fracture_rms_mm > 0)
    text = tr("Trying %1: %2, fractures %3 apart.").arg(back, chance, mm(fit->fracture_rms_mm));
  else
    text = tr("Trying %1: %2; its fractures do not touch.").arg(back, chance);
  if (card.back < 0 || card.back == trial.back) return capitalised(text);
  text = capitalised(text);
  const QString instead = nameOf(table.backs, card.back);
  return text + QLatin1Char(' ') +
         (card.state == CardState::Decided
              ? tr("%1 decided for %2.").arg(QString::fromStdString(card.decided_by), instead)
              : tr("The program says %1, %2.").arg(instead, scoreWords(card.score)));
}

QString doubtSentence(const ReviewCard& card, const CandidateTable& table, const CardStory& story) {
  const QString by = QString::fromStdString(card.decided_by);
  const QString on = QString::fromStdString(card.decided_at.substr(0, 10));
  switch (card.state) {
    case CardState::Ask:
      return askSentence(card, table, story);
    case CardState::Alone:
      return aloneSentence(table, story);
    case CardState::Sure:
      return sureSentence(card);
    case CardState::Decided:
      return (story.by_hand ? tr("Decided by %1 on %2, turned by hand.")
                            : tr("Decided by %1 on %2."))
          .arg(by, on);
    case CardState::Aside:
      return tr("Set aside by %1 on %2.").arg(by, on);
    case CardState::Reshoot:
      return tr("To be reshot, decided by %1 on %2.").arg(by, on);
  }
  return {};
}

}  // namespace ostraka::ui
