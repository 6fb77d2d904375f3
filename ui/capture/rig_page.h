#pragma once
#include <QWidget>

#include "ui/wizard/rig_source.h"

class QAbstractButton;
class QComboBox;
class QSpinBox;
class QCheckBox;

namespace ostraka::ui {

class EmptyState;
class MessagePanel;

/// No rig yet: pictures that exist already, a rig file, or the virtual rig, which asks first.
class RigPage final : public QWidget {
  Q_OBJECT

 public:
  explicit RigPage(QWidget* parent = nullptr);
  void setChoice(const RigChoice& choice);
  void setImporting(bool importing);  ///< photographs: one import at a time
  void setCanKeep(bool can);          ///< the rig that worked before
  void setCanLeave(bool can);         ///< the rig that the project has
  QAbstractButton* primary() const { return import_; }

 public slots:
  /// Space: what has the focus, and else the one big button.
  void goOn();

 signals:
  void chosen(const ostraka::ui::RigChoice& choice);
  void importPhotographs();
  void importScans();
  void kept();
  void left();  ///< the project is to have no rig

 protected:
  void hideEvent(QHideEvent* event) override;

 private:
  void askForVirtual();
  void chooseVirtual();
  void chooseFile();

  RigChoice choice_;
  EmptyState* empty_;
  QString asks_, explains_;  ///< while nothing is imported
  QAbstractButton *import_ = nullptr, *scans_ = nullptr, *keep_ = nullptr, *leave_ = nullptr;
  MessagePanel* ask_;
  QSpinBox* sherds_;
  QComboBox* width_;
  QCheckBox* near_duplicates_;
};

}  // namespace ostraka::ui
