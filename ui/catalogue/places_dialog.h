#pragma once
#include <QDialog>
#include <optional>

#include "catalogue/renamed_places.h"
#include "store/row.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace ostraka::ui {

class ProjectSession;

/// Trenches, contexts and bags of the project: one that was typed wrongly gets its right name, and
/// becomes one with the place that has that name already. What comes of it stands there before.
class PlacesDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit PlacesDialog(ProjectSession& session, QWidget* parent = nullptr);
  /// Chooses the context of this sherd, or its bag.
  void showPlaceOf(store::SherdRow sherd);

 private:
  void buildLayout();
  void fill();
  QTreeWidgetItem* add(QTreeWidgetItem* in, const char* words, catalogue::PlaceId place,
                       const std::string& name);
  void choose(catalogue::PlaceId place);
  std::optional<catalogue::PlaceId> chosen() const;
  void showChosen();
  void preview();
  void apply();

  ProjectSession& session_;
  QTreeWidget* places_ = nullptr;
  QLineEdit* name_ = nullptr;
  QLabel* told_ = nullptr;
  QPushButton* rename_ = nullptr;
  catalogue::Renaming would_;
};

}  // namespace ostraka::ui
