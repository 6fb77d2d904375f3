#pragma once
#include <QColor>

namespace ostraka::ui {

/// Signed distances as colours: the one scale of every map of distances. Blue below zero, white at
/// zero, orange above; what was not seen or not met has a colour of its own, which is on no scale.
class DistanceScale {
 public:
  /// Distances of this size and larger have the colours of the ends.
  explicit DistanceScale(double reach_mm) : reach_mm_(reach_mm) {}

  double reach_mm() const { return reach_mm_; }
  /// Not a number: notSeen().
  QColor of(double distance_mm) const;
  static QColor notSeen();

 private:
  double reach_mm_;
};

}  // namespace ostraka::ui
