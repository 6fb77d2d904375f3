#pragma once
#include <QObject>
#include <QPointer>
#include <QStringList>
#include <functional>
#include <memory>
#include <optional>

#include "ui/jobs/job.h"
#include "ui/jobs/question.h"
#include "ui/wizard/rig_source.h"

namespace ostraka::ui {

class ProjectSession;

/// The rig that a project photographs with: which one it is, its opened devices, and what they do,
/// one thing at a time.
class RigConnection final : public QObject {
  Q_OBJECT

 public:
  using Done = std::function<void(const JobOutcome&)>;

  explicit RigConnection(QObject* parent);
  ~RigConnection() override;

  void setSession(ProjectSession* session);  ///< null closes; what runs is dropped in silence
  /// It waits for the end of what runs. What does not open leaves its place to the one that worked
  /// before.
  void choose(RigSource source);
  bool canRestore() const { return previous_.has_value(); }

  const RigSource& source() const { return source_; }
  const std::shared_ptr<capture::RigDevices>& devices() const { return devices_; }  ///< null: none
  int cameras() const;
  bool isFor(int batch) const;  ///< its devices were opened for this batch, or serve every one
  /// Its work was cancelled, and has not come to its end yet.
  bool isStopping() const { return work_ != nullptr && stopping_; }
  bool isBusy() const { return work_ != nullptr || after_preview_ != nullptr; }
  const QString& question() const { return question_.sentence(); }  ///< at the rig
  const QStringList& holders() const { return holders_; }           ///< programs that hold a camera

  void open(int batch);
  void close() { devices_.reset(); }
  /// Takes a live picture unless it is busy; done hears nothing when other work goes before.
  void preview(Job job, Done done);
  /// A camera does one thing at a time: the live picture ends first.
  void whenFree(std::function<void()> act);
  JobHandle* work(Job job, Done done);  ///< only when it is free
  void answer() { question_.answer(true); }
  void cancel();  ///< of what runs or is about to
  void findHolders();
  void forgetHolders();
  void release();  ///< the cameras from the programs that hold them

 public slots:
  void clear();
  void restore();         ///< the one that worked before, after clear
  void forgetPrevious();  ///< nothing to restore

 signals:
  void changed();  ///< what it does, asks, or is held by
  void waited();   ///< another rig was chosen while this one is busy
  void taken();    ///< source() is another, and not open yet
  void begun();    ///< no live pictures until it is free again
  void opened();
  void released();
  void failed(const ostraka::Error& error);                  ///< to open, or to release
  void tried(const std::optional<ostraka::Error>& why_not);  ///< null: it is open

 private:
  bool takeWaiting();
  void takeDevices(const Result<std::shared_ptr<capture::RigDevices>>& devices);
  JobHandle* start(Job job, Done done);

  QPointer<ProjectSession> session_;
  RigSource source_;
  std::optional<RigSource> waiting_, previous_;  ///< until the present work ended; that worked
  std::shared_ptr<capture::RigDevices> devices_;
  int opened_for_ = 0;  ///< the index of the batch that devices_ were opened for
  QPointer<JobHandle> work_, preview_, holders_job_;
  std::function<void()> after_preview_;
  Question question_;
  QStringList holders_;
  bool stopping_ = false;  ///< work_ was cancelled
};

}  // namespace ostraka::ui
