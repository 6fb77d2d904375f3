#pragma once
#include <QWidget>

#include "ui/capture/rig_source.h"

class QComboBox;
class QSpinBox;
class QCheckBox;

namespace ostraka::ui {

/// No rig yet: the virtual one, a rig file, or pictures that exist already.
class RigPage final : public QWidget {
  Q_OBJECT

 public:
  explicit RigPage(QWidget* parent = nullptr);
  void setChoice(const RigChoice& choice);

 public slots:
  /// Space: what has the focus, and else the one big button.
  void goOn();

 signals:
  void chosen(const ostraka::ui::RigChoice& choice);
  void importPhotographs();
  void importScans();

 private:
  void chooseVirtual();
  void chooseFile();

  RigChoice choice_;
  QSpinBox* sherds_;
  QComboBox* width_;
  QCheckBox* lookalikes_;
};

}  // namespace ostraka::ui
