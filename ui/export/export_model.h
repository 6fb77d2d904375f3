#pragma once
#include <QObject>
#include <QPointer>
#include <QString>
#include <optional>
#include <vector>

#include "archive/archive.h"
#include "exchange/export_folder.h"
#include "store/row.h"
#include "ui/jobs/job.h"

namespace ostraka::ui {

class ProjectSession;

/// Which sherds are exported, or all of the project as an archive that can be restored.
struct ExportSelection {
  enum class What { All, Filtered, Chosen, Project };
  What what = What::All;
  QString filter;                       ///< as it was typed
  std::vector<store::SherdRow> chosen;  ///< what could be chosen, also of the others
};

/// An export or an archive: what is chosen, how large it will be, how far it is, and how it ended.
/// Each project remembers its forms and the folder that its exports lie in. Runs without a display.
class ExportModel final : public QObject {
  Q_OBJECT

 public:
  enum class State { Choosing, Running, Done, Failed };

  explicit ExportModel(QObject* parent = nullptr) : QObject(parent) {}
  void openProject(ProjectSession* session);  ///< nullptr closes it

  /// Whether anybody looks. The size is asked of each sherd and file, so only then.
  void setWatched(bool watched);

  const ExportSelection& selection() const { return selection_; }
  const exchange::ExportOptions& options() const { return options_; }
  QString target() const { return QString::fromStdString(options_.target.string()); }
  void choose(ExportSelection selection);
  void setOptions(exchange::ExportOptions options);  ///< its forms and their sizes
  void setTarget(const QString& folder);

  State state() const { return state_; }
  bool canStart() const;
  QString sizeText() const;  ///< "212 sherds, 640 files, 3.1 GB, about 2 minutes"
  QString problem() const { return problem_; }
  QString progressText() const;
  double fraction() const { return running_ ? running_->progress().fraction : 0; }
  const QString& closingLine() const { return closing_; }  ///< "212 sherds, 3.1 GB, …"
  const QStringList& warnings() const { return warnings_; }
  bool isArchive() const { return selection_.what == ExportSelection::What::Project; }

  void start();
  void cancel();

 signals:
  void changed();
  void finished();

 private:
  void readChoices();
  void keepChoices() const;
  exchange::ExportOptions worded() const;  ///< the options in the window's language
  void chooseAnew();
  void forgetDone();
  void measureSize();
  void countQueued();
  void run(JobHandle* job);
  void exported(const Result<exchange::Exported>& done);
  void archived(const Result<archive::Archived>& done);
  void ended(const Error* why_not);

  ProjectSession* session_ = nullptr;
  ExportSelection selection_;
  exchange::ExportOptions options_;
  QString parent_;  ///< the folder that exports lie in
  QString problem_;
  State state_ = State::Choosing;
  bool watched_ = false;
  std::optional<exchange::ExportSize> size_;
  int queued_ = 0;  ///< batches that an archive would hold without their results
  QString closing_;
  QStringList warnings_;
  QPointer<JobHandle> sizing_, running_;
};

}  // namespace ostraka::ui
