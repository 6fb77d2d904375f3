#include "ui/capture/capture_station.h"
#include "ui/main/main_window.h"
#include "ui/queue/queue_station.h"

namespace ostraka::ui {

std::vector<Station*> makeStations(CaptureStation* capture, QueueStation* queue, QWidget*) {
  return {capture, queue};
}

}  // namespace ostraka::ui
