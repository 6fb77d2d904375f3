#pragma once
#include <QObject>
#include <QPointer>
#include <QString>
#include <optional>
#include <vector>

#include "exchange/export_folder.h"
#include "store/row.h"
#include "ui/jobs/job.h"

namespace ostraka::ui {

class ProjectSession;

/// What is exported, in which forms, where to, and how far it is. Each project remembers its forms
/// and the folder that its exports lie in. Runs without a display.
class ExportModel final : public QObject {
  Q_OBJECT

 public:
  enum class What { All, Filtered, Chosen };
  enum class State { Choosing, Running, Done, Failed };

  explicit ExportModel(QObject* parent = nullptr);
  void openProject(ProjectSession* session);  ///< nullptr closes it

  /// Whether anybody looks. The size is asked of each sherd and file, so only then.
  void setWatched(bool watched);

  What what() const { return what_; }
  const QString& filter() const { return filter_; }
  const std::vector<store::SherdRow>& chosen() const { return chosen_; }
  const std::set<exchange::Form>& forms() const { return forms_; }
  const QString& target() const { return target_; }
  std::optional<double> drawingScale() const { return drawing_scale_; }
  double deviation_mm() const { return deviation_mm_; }
  void setAll();
  void setFilter(const QString& line);
  void setChosen(std::vector<store::SherdRow> sherds);
  /// What could be chosen; what is exported stays.
  void offerChosen(std::vector<store::SherdRow> sherds);
  void setForm(exchange::Form form, bool wanted);
  void setDrawingScale(std::optional<double> scale);  ///< nothing: what fits the sheet
  /// Models with fewer triangles, this far off at most, mm; 0: as computed.
  void setDeviation(double deviation_mm);
  void setTarget(const QString& folder);

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
  void forgetDone();
  void measureSize();
  void readChoices();
  void keepChoices() const;
  QString proposedTarget() const;
  void ended(const Result<exchange::Exported>& done);
  exchange::ExportOptions options() const;

  ProjectSession* session_ = nullptr;
  What what_ = What::All;
  QString filter_, target_, problem_, parent_;
  std::vector<store::SherdRow> chosen_;
  std::set<exchange::Form> forms_ = exchange::ExportOptions().forms;
  std::optional<double> drawing_scale_ = 1;
  double deviation_mm_ = 0;
  State state_ = State::Choosing;
  bool watched_ = false;
  std::optional<exchange::ExportSize> size_;
  std::optional<exchange::Exported> done_;
  double fraction_ = 0, seconds_left_ = -1;
  QPointer<JobHandle> sizing_, running_;
};

}  // namespace ostraka::ui
