#pragma once
#include <QObject>
#include <QPointer>
#include <QString>
#include <optional>
#include <vector>

#include "merge/merge.h"
#include "ui/jobs/job.h"

namespace ostraka::ui {

class ProjectSession;

/// Another project that is to come into the open one: what would come, what both say differently
/// and how a person settles it, then entered whole or not at all. Runs without a display.
class MergeModel final : public QObject {
  Q_OBJECT

 public:
  enum class State { Choosing, Comparing, Settling, Entering, Done };

  explicit MergeModel(QObject* parent = nullptr) : QObject(parent) {}
  void openProject(ProjectSession* session);  ///< nullptr closes it
  ProjectSession* session() const { return session_; }

  State state() const { return state_; }
  bool isBusy() const { return state_ == State::Comparing || state_ == State::Entering; }
  const QString& folder() const { return folder_; }
  void setFolder(const QString& folder);  ///< compares at once; nothing is entered

  const std::optional<merge::MergeReport>& report() const { return report_; }
  const std::vector<merge::Conflict>& conflicts() const { return conflicts_; }
  const merge::Choice* choiceOf(const merge::Conflict& conflict) const;
  int unsettled() const;
  /// Those of them that offer it. A number that two sherds have: without another one of the choice,
  /// the sherd that loses it gets the one that is proposed.
  void settle(const std::vector<int>& conflicts, const merge::Choice& choice);
  void settleRestForThis();
  bool canUndo() const { return !earlier_.empty() && state_ == State::Settling; }
  void undo();  ///< the last settling, whatever it settled

  QString summary() const;
  /// Batches that get another number, files that are missing, what went wrong: a line each.
  QString notes() const;
  /// All sherds with another number, "before → now", a line each.
  QStringList newNumbers() const;
  double fraction() const { return job_ ? job_->progress().fraction : 0; }

  bool canEnter() const;
  void enter();
  void cancel();

 signals:
  void changed();
  void entered(const QString& sentence);

 private:
  void run(merge::MergeMode mode);
  void ended(merge::MergeMode mode, const Result<merge::MergeReport>& report);

  ProjectSession* session_ = nullptr;
  State state_ = State::Choosing;
  QString folder_, problem_;
  std::optional<merge::MergeReport> report_;
  std::vector<merge::Conflict> conflicts_;  ///< of the report
  merge::Settled settled_;
  std::vector<merge::Settled> earlier_;  ///< before each settling
  QPointer<JobHandle> job_;
};

}  // namespace ostraka::ui
