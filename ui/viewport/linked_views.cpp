#include "ui/viewport/linked_views.h"

#include <QScopedValueRollback>
#include <algorithm>

namespace ostraka::ui {

void LinkedViews::setView(std::size_t place, SherdView* view) {
  if (views_[place] == view) return;
  if (views_[place]) disconnect(views_[place], nullptr, this, nullptr);
  views_[place] = view;
  connect(view, &SherdView::viewMoved, this, [this, place] { follow(place); });
  note();
}

void LinkedViews::note() {
  for (std::size_t i = 0; i < views_.size(); ++i)
    if (views_[i]) poses_[i] = views_[i]->viewPose();
}

// The turn that the picture of the one made, made by the picture of the other.
void LinkedViews::follow(std::size_t moved) {
  if (busy_) return;
  const ViewPose before = poses_[moved], now = views_[moved]->viewPose();
  poses_[moved] = now;
  const std::size_t other = 1 - moved;
  if (!views_[other]) return;
  ViewPose pose = poses_[other];
  if (together_)
    pose.view_from_front =
        now.view_from_front * before.view_from_front.transpose() * pose.view_from_front;
  pose.half_height_mm = now.half_height_mm;
  const bool same = pose.half_height_mm == poses_[other].half_height_mm &&
                    pose.view_from_front.isApprox(poses_[other].view_from_front, 1e-9);
  if (same) return;  // it was moved sideways, or is drawn anew
  const QScopedValueRollback<bool> busy(busy_, true);
  views_[other]->setViewPose(pose);
  note();
}

void LinkedViews::setSection(bool section) {
  const QScopedValueRollback<bool> busy(busy_, true);
  for (const QPointer<SherdView>& view : views_)
    if (view) view->setSection(section);
  note();
}

void LinkedViews::reset() {
  const QScopedValueRollback<bool> busy(busy_, true);
  double half_height_mm = 0;
  for (const QPointer<SherdView>& view : views_)
    if (view) {
      view->resetView();
      half_height_mm = std::max(half_height_mm, view->viewPose().half_height_mm);
    }
  for (const QPointer<SherdView>& view : views_)
    if (view) {
      ViewPose pose = view->viewPose();
      pose.half_height_mm = half_height_mm;
      view->setViewPose(pose);
    }
  note();
}

}  // namespace ostraka::ui
