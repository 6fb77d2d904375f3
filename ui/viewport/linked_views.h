#pragma once
#include <QObject>
#include <QPointer>
#include <array>
#include <cstddef>

#include "ui/viewport/sherd_view.h"

namespace ostraka::ui {

/// Two sherds beside each other, always in the same scale. Turning one turns the other by the same
/// angle, so that a difference that a person set by turning one alone remains. The views must have
/// the same height.
class LinkedViews final : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  void setView(std::size_t place, SherdView* view);  ///< 0 or 1
  bool areTogether() const { return together_; }
  void setTogether(bool together) { together_ = together; }
  void setSection(bool section);
  /// Both obliquely from above, and the larger one whole.
  void reset();

 private:
  void follow(std::size_t moved);
  void note();  ///< how both stand now

  std::array<QPointer<SherdView>, 2> views_;
  std::array<ViewPose, 2> poses_;
  bool together_ = true, busy_ = false;
};

}  // namespace ostraka::ui
