#pragma once
#include <QObject>
#include <QPointer>
#include <QString>
#include <optional>
#include <set>
#include <vector>

#include "exchange/export_folder.h"
#include "store/row.h"

namespace ostraka::ui {

class ProjectSession;

/// Which sherds are exported.
struct ExportSelection {
  enum class What { All, Filtered, Chosen };
  What what = What::All;
  QString filter;                       ///< as it was typed
  std::vector<store::SherdRow> chosen;  ///< what could be chosen, also of the others
};

/// Errors: a filter that is not understood.
Result<std::vector<store::SherdRow>> rowsOf(const catalogue::Catalogue& catalogue,
                                            const ExportSelection& selection);

/// What a person chooses to export: which sherds, in which forms, and the folder it goes to. Each
/// project remembers its forms and the folder that its exports lie in.
class ExportChoices final : public QObject {
  Q_OBJECT

 public:
  explicit ExportChoices(QObject* parent);

  /// All sherds, in the forms that its project remembers, to a folder that is free; tells nobody.
  /// Null closes it.
  void setSession(ProjectSession* session);

  const ExportSelection& selection() const { return selection_; }
  const std::set<exchange::Form>& forms() const { return forms_; }
  std::optional<double> drawingScale() const { return drawing_scale_; }
  std::size_t mostModelBytes() const { return most_model_bytes_; }
  const QString& target() const { return target_; }
  exchange::ExportOptions options() const;

  void setAll();
  void setFilter(const QString& line);
  void setChosen(std::vector<store::SherdRow> sherds);
  /// What could be chosen; what is exported stays.
  void offerChosen(std::vector<store::SherdRow> sherds);
  void setForm(exchange::Form form, bool wanted);
  void setDrawingScale(std::optional<double> scale);  ///< nothing: what fits the sheet
  void setMostModelBytes(std::size_t bytes);          ///< 0: as large as they are
  void setTarget(const QString& folder);

  /// Another folder beside the target where that is there already. Tells nobody.
  void takeFreeTarget();
  /// The project remembers where the target lies.
  void keepTarget();

 signals:
  void contentChanged();  ///< other sherds or forms: its size is another
  void targetChanged();
  void offerChanged();  ///< what could be chosen, though it is not

 private:
  void readChoices();
  void keepChoices() const;

  QPointer<ProjectSession> session_;
  ExportSelection selection_;
  std::set<exchange::Form> forms_ = exchange::ExportOptions().forms;
  std::optional<double> drawing_scale_ = 1;
  std::size_t most_model_bytes_ = 0;
  QString target_, parent_;
};

}  // namespace ostraka::ui
