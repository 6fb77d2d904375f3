#include "ui/sherds/surface_choice.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace ostraka::ui {
namespace {

using drawing::Dpi, drawing::Surface;

// In the order of the choices.
constexpr std::pair<Surface, Dpi> kSurfaces[] = {{Surface::Relief, Dpi::Usual},
                                                 {Surface::Painted, Dpi::Usual},
                                                 {Surface::Orthophoto, Dpi::Usual},
                                                 {Surface::Orthophoto, Dpi::Fine}};

}  // namespace

SurfaceChoice::SurfaceChoice(QWidget* parent) : QComboBox(parent) {
  addItem(tr("Shaded form"));
  addItem(tr("With paint and slip"));
  for (const Dpi dpi : {Dpi::Usual, Dpi::Fine})
    addItem(tr("Orthophoto, %1 dpi").arg(static_cast<int>(dpi)));
}

Surface SurfaceChoice::surface() const {
  return kSurfaces[std::max(0, currentIndex())].first;
}

Dpi SurfaceChoice::dpi() const {
  return kSurfaces[std::max(0, currentIndex())].second;
}

void SurfaceChoice::choose(Surface surface, Dpi dpi) {
  const auto* found =
      std::find(std::begin(kSurfaces), std::end(kSurfaces), std::pair(surface, dpi));
  setCurrentIndex(found == std::end(kSurfaces)
                      ? 0
                      : static_cast<int>(std::distance(std::begin(kSurfaces), found)));
}

}  // namespace ostraka::ui
