#pragma once
#include <QObject>
#include <QPointer>
#include <QString>
#include <optional>

#include "exchange/export_folder.h"
#include "ui/jobs/job.h"

namespace ostraka::ui {

class ExportChoices;
class ProjectSession;

/// An export: how large what is chosen will be, how far it is, and how it ended. Runs without a
/// display.
class ExportModel final : public QObject {
  Q_OBJECT

 public:
  enum class State { Choosing, Running, Done, Failed };

  explicit ExportModel(QObject* parent = nullptr);
  void openProject(ProjectSession* session);  ///< nullptr closes it

  /// Whether anybody looks. The size is asked of each sherd and file, so only then.
  void setWatched(bool watched);

  /// What is exported, in which forms and where to.
  ExportChoices* choices() const { return choices_; }

  State state() const { return state_; }
  bool canStart() const;
  QString sizeText() const;  ///< "212 sherds, 640 files, 3.1 GB, about 2 minutes"
  QString problem() const { return problem_; }
  QString progressText() const;
  double fraction() const { return fraction_; }
  QString closingLine() const;  ///< "212 sherds, 3.1 GB, manifest checked"
  QStringList warnings() const;

  void start();
  void cancel();

 signals:
  void changed();
  void finished();

 private:
  void chooseAnew();
  void followTarget();
  void forgetDone();
  void measureSize();
  void ended(const Result<exchange::Exported>& done);

  ProjectSession* session_ = nullptr;
  ExportChoices* choices_;
  QString problem_;
  State state_ = State::Choosing;
  bool watched_ = false;
  std::optional<exchange::ExportSize> size_;
  std::optional<exchange::Exported> done_;
  double fraction_ = 0, seconds_left_ = -1;
  QPointer<JobHandle> sizing_, running_;
};

}  // namespace ostraka::ui
