#pragma once
#include <QWidget>

#include "ui/settings/window_settings.h"

class QComboBox;
class QLineEdit;
class QSlider;
class QLabel;
class QPushButton;
class QSpinBox;

namespace ostraka::ui {

class NumberingEdit;
class PageArea;
class ProjectEdit;
class RightsEdit;
class VocabularyEdit;
class ProjectSession;

/// The settings as a page of the window; each change holds at once.
class SettingsPage final : public QWidget {
  Q_OBJECT

 public:
  explicit SettingsPage(QWidget* parent = nullptr);
  void setSettings(const WindowSettings& settings);
  /// The open project, whose numbering and words stand here too; null when none is open.
  void setSession(ProjectSession* session);
  /// Its part of this object name into view, with the cursor in its first field: "numbering".
  void showPart(const QString& name);
  void say(const QString& sentence);  ///< above everything; empty: nothing

 signals:
  void changed(const ostraka::ui::WindowSettings& settings);
  void projectRenamed();
  void closed();
  void restartWanted();  ///< for the language that was chosen

 private:
  void buildLayout();
  void gather();
  void followLanguage();

  WindowSettings settings_;
  QComboBox *theme_, *language_;
  QPushButton* restart_;
  QSlider* text_;
  QLabel *text_words_, *said_;
  QLineEdit* initials_;
  QSpinBox* threads_;
  ProjectEdit* project_;
  NumberingEdit* numbering_;
  VocabularyEdit* vocabulary_;
  RightsEdit* rights_;
  PageArea* area_ = nullptr;
  bool filling_ = false;
};

}  // namespace ostraka::ui
