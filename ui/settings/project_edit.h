#pragma once
#include <QPointer>
#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;

namespace ostraka::ui {

class ProjectSession;

/// Part of the settings: what the open project is called, its site code, and what the textures of
/// its batches show.
class ProjectEdit final : public QWidget {
  Q_OBJECT

 public:
  explicit ProjectEdit(QWidget* parent = nullptr);
  /// Hidden without a project.
  void setSession(ProjectSession* session);

 signals:
  void renamed();  ///< the project has another name or site code

 private:
  struct Name {
    QString title, code;
    bool operator==(const Name&) const = default;
  };
  void saveName();
  void saveTextures();
  void showProject();

  QPointer<ProjectSession> session_;
  Name held_;  ///< in the catalogue
  QLineEdit *name_, *code_;
  QComboBox* textures_;
  QLabel* told_;
};

}  // namespace ostraka::ui
