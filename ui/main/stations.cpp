#include "ui/capture/capture_station.h"
#include "ui/catalogue/catalogue_station.h"
#include "ui/export/export_station.h"
#include "ui/main/main_window.h"
#include "ui/map/map_station.h"
#include "ui/queue/queue_station.h"
#include "ui/review/review_station.h"

namespace ostraka::ui {

std::vector<Station*> makeStations(CaptureStation* capture, QueueStation* queue, QWidget* parent) {
  return {capture,
          queue,
          new ReviewStation(parent),
          new MapStation(parent),
          new CatalogueStation(parent),
          new ExportStation(parent)};
}

}  // namespace ostraka::ui
