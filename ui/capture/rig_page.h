#pragma once
#include <QWidget>

#include "ui/wizard/rig_source.h"

class QAbstractButton;
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
  void setCanKeep(bool can);  ///< the rig that worked before
  QAbstractButton* primary() const { return use_; }

 public slots:
  /// Space: what has the focus, and else the one big button.
  void goOn();

 signals:
  void chosen(const ostraka::ui::RigChoice& choice);
  void importPhotographs();
  void importScans();
  void kept();

 private:
  void chooseVirtual();
  void chooseFile();

  RigChoice choice_;
  QAbstractButton *use_ = nullptr, *keep_ = nullptr;
  QSpinBox* sherds_;
  QComboBox* width_;
  QCheckBox* near_duplicates_;
};

}  // namespace ostraka::ui
