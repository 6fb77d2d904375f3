#include "ui/capture/capture_screen.h"
#include "ui/catalogue/catalogue_screen.h"
#include "ui/export/export_screen.h"
#include "ui/main/work_page.h"
#include "ui/map/map_screen.h"
#include "ui/queue/queue_screen.h"
#include "ui/review/review_screen.h"

namespace ostraka::ui {

std::vector<Screen*> makeScreens(CaptureScreen* capture, QueueScreen* queue, QWidget* parent) {
  return {capture,
          queue,
          new ReviewScreen(parent),
          new MapScreen(parent),
          new CatalogueScreen(parent),
          new ExportScreen(parent)};
}

}  // namespace ostraka::ui
