#pragma once
#include <QComboBox>

#include "drawing/view.h"

namespace ostraka::ui {

/// How the surfaces of sherds are drawn, and at how many dots per inch.
class SurfaceChoice final : public QComboBox {
  Q_OBJECT

 public:
  explicit SurfaceChoice(QWidget* parent = nullptr);
  drawing::Surface surface() const;
  drawing::Dpi dpi() const;
  void choose(drawing::Surface surface, drawing::Dpi dpi);
};

}  // namespace ostraka::ui
