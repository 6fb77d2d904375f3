#include "ui/merge/merge_model.h"

#include <QCollator>
#include <algorithm>
#include <utility>

#include "records/records.h"
#include "ui/frame/project_session.h"
#include "ui/jobs/when_done.h"
#include "ui/merge/merge_words.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

constexpr int kMostNamed = 4;

}  // namespace

void MergeModel::openProject(ProjectSession* session) {
  if (state_ == State::Entering && session == session_) return emit changed();
  delete job_.data();
  session_ = session;
  state_ = State::Choosing;
  folder_.clear();
  problem_.clear();
  report_.reset();
  conflicts_.clear();
  settled_.clear();
  earlier_.clear();
  emit changed();
}

void MergeModel::setFolder(const QString& folder) {
  if (!session_ || state_ == State::Entering) return;
  ProjectSession* session = session_;
  openProject(session);
  folder_ = folder;
  run(merge::MergeMode::Preview);
}

const merge::Choice* MergeModel::choiceOf(const merge::Conflict& conflict) const {
  const auto found = settled_.find(conflict.id);
  return found == settled_.end() ? nullptr : &found->second;
}

int MergeModel::unsettled() const {
  return static_cast<int>(std::ranges::count_if(
      conflicts_, [this](const merge::Conflict& one) { return choiceOf(one) == nullptr; }));
}

void MergeModel::settle(const std::vector<int>& conflicts, const merge::Choice& choice) {
  if (state_ != State::Settling) return;
  merge::Settled settled = settled_;
  for (const int i : conflicts)
    if (const merge::Conflict& conflict = conflicts_.at(static_cast<std::size_t>(i));
        conflict.offers(choice.take)) {
      merge::Choice& made = settled[conflict.id] = choice;
      if (conflict.isOfTwoSherds() && made.number.empty() && made.take != merge::Take::One)
        made.number = made.take == merge::Take::A ? conflict.new_b : conflict.new_a;
    }
  earlier_.push_back(std::exchange(settled_, std::move(settled)));
  problem_.clear();
  emit changed();
}

void MergeModel::settleRestForThis() {
  std::vector<int> rest;
  for (std::size_t i = 0; i < conflicts_.size(); ++i)
    if (!choiceOf(conflicts_[i])) rest.push_back(static_cast<int>(i));
  settle(rest, {merge::Take::A, {}});
}

void MergeModel::undo() {
  if (!canUndo()) return;
  settled_ = std::move(earlier_.back());
  earlier_.pop_back();
  emit changed();
}

QString MergeModel::summary() const {
  if (state_ == State::Comparing) return tr("Comparing…");
  if (!report_) return {};
  const merge::MergeReport& report = *report_;
  if (state_ == State::Done)
    return tr("Merged %1. %2").arg(folder_.section('/', -1), countWords(report));
  const bool nothing = report.added + report.changed + report.files == 0 && conflicts_.empty();
  return nothing ? tr("This project already has everything that the other one holds.")
                 : countWords(report);
}

QStringList MergeModel::newNumbers() const {
  QStringList numbers;
  if (!report_) return numbers;
  for (const auto& [id, number] : report_->new_numbers)
    numbers << QStringLiteral("%1 → %2").arg(QString::fromStdString(number.first),
                                             QString::fromStdString(number.second));
  QCollator order;
  order.setNumericMode(true);
  std::sort(numbers.begin(), numbers.end(), order);
  return numbers;
}

QString MergeModel::notes() const {
  QStringList lines;
  if (!problem_.isEmpty()) lines << problem_;
  if (!report_) return lines.join('\n');
  const QStringList numbers = newNumbers();
  QStringList renumbered, missing;
  for (const auto& [there, here] : report_->renumbered)
    renumbered << QStringLiteral("%1 → %2").arg(QString::fromStdString(there),
                                                QString::fromStdString(here));
  for (const std::string& file : report_->missing) missing << QString::fromStdString(file);
  if (!renumbered.isEmpty())
    lines << tr("Batches that get another number here: %1").arg(firstOf(renumbered, kMostNamed));
  if (!numbers.isEmpty() && state_ != State::Done)  // then the list has all of them
    lines << tr("Sherds that get another number here: %1").arg(firstOf(numbers, kMostNamed));
  if (!missing.isEmpty())
    lines << tr("Missing in the other project: %n file(s), %1", nullptr,
                static_cast<int>(missing.size()))
                 .arg(firstOf(missing, kMostNamed));
  if (!report_->kept.empty()) lines << keptWords(report_->kept);
  return lines.join('\n');
}

bool MergeModel::canEnter() const {
  return session_ && state_ == State::Settling && report_ && unsettled() == 0 &&
         report_->added + report_->changed + report_->files + static_cast<int>(conflicts_.size()) >
             0;
}

void MergeModel::enter() {
  if (canEnter()) run(merge::MergeMode::Enter);
}

void MergeModel::cancel() {
  if (job_) job_->cancel();
}

void MergeModel::run(merge::MergeMode mode) {
  state_ = mode == merge::MergeMode::Preview ? State::Comparing : State::Entering;
  problem_.clear();
  records::Provenance provenance;
  if (mode == merge::MergeMode::Enter) provenance = session_->provenance();
  provenance.source = "merge";
  const auto work = [a = session_->folder(), b = std::filesystem::path(folder_.toStdString()), mode,
                     settled = settled_, provenance](
                        Progress& progress, std::stop_token stop) -> Result<merge::MergeReport> {
    Result<upkeep::Project> project = upkeep::Project::open(a, {}, {stop, &progress});
    if (!project) return project.error();
    return merge::mergeInto(*project, b, mode, settled, provenance, progress, stop);
  };
  job_ = session_->jobs().start(makeJob(work), this);
  connect(job_, &JobHandle::progressed, this, [this] {
    problem_.clear();  // it waits no longer
    emit changed();
  });
  connect(job_, &JobHandle::noted, this, [this](NoteLevel level, const QString& words) {
    if (level == NoteLevel::Warning) problem_ = words;
    emit changed();
  });
  whenDone<merge::MergeReport>(job_, this,
                               [this, mode](const auto& report) { ended(mode, report); });
  emit changed();
}

void MergeModel::ended(merge::MergeMode mode, const Result<merge::MergeReport>& report) {
  const bool entering = mode == merge::MergeMode::Enter;
  problem_.clear();
  if (!report) {
    state_ = entering ? State::Settling : State::Choosing;
    problem_ = report.error().code == ErrorCode::Cancelled ? tr("Cancelled. Nothing was merged.")
                                                           : sentenceOf(report.error());
    return emit changed();
  }
  report_ = *report;
  conflicts_ = report->conflicts;
  state_ = report->entered && entering ? State::Done : State::Settling;
  earlier_.clear();
  if (entering && !report->entered)
    problem_ = tr("Nothing was merged yet: what you chose leads to further conflicts.");
  emit changed();
  if (state_ == State::Done) emit entered(summary());
}

}  // namespace ostraka::ui
