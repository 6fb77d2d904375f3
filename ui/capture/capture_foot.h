#pragma once
#include <vector>

#include "ui/widgets/side_by_side.h"
#include "ui/wizard/capture_text.h"

class QAbstractButton;
class QAction;

namespace ostraka::ui {

class BigButton;
class CaptureWizard;
class CountEdit;
class PlaceEdit;
class ToolRow;

/// The foot of the wizard: the bag, the count, the cameras, and the one big button.
class CaptureFoot final : public SideBySide {
  Q_OBJECT

 public:
  struct Acts {
    QAction *next, *stop;
    std::vector<QAction*> cameras;
    QList<QAction*> more;
  };
  CaptureFoot(CaptureWizard* wizard, const Acts& acts, QWidget* parent);
  PlaceEdit* place() const { return place_; }
  CountEdit* count() const { return count_; }
  QAbstractButton* button() const;
  void follow();
  void setCompact(bool compact);

 signals:
  void entered();  ///< Return in a field: the person is done with it

 private:
  void resizeEvent(QResizeEvent* event) override;
  void showButton();
  void shareWidth();
  QWidget* buildFields();
  QWidget* buildTools(const Acts& acts);

  CaptureWizard* wizard_;
  CaptureText text_;
  QWidget* fields_ = nullptr;
  PlaceEdit* place_;
  CountEdit* count_;
  BigButton* button_;
  ToolRow* tools_;
};

}  // namespace ostraka::ui
