#include "torture.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <set>

#include "files/files.h"
#include "flat_rig.h"
#include "simulated_controllers.h"
#include "turntables/comxim.h"
#include "turntables/grbl.h"

namespace ostraka::capture::testing {
namespace {

namespace fs = std::filesystem;

constexpr int kStops = 8;
constexpr int kMostResumes = 60;

struct TorturedRig {
  FlatRig flat;
  std::shared_ptr<SimulatedController> controller;
};

// Opened like a person would: again, until it answers.
std::unique_ptr<devices::Turntable> openTable(const TortureOptions& options, TorturedRig& rig) {
  const auto clock = rig.flat.truth->clock;
  for (int k = 0; k < 20; ++k) {
    auto channel = std::make_unique<SimulatedChannel>(rig.controller, clock);
    Result<std::unique_ptr<devices::Turntable>> table =
        options.driver == "grbl"
            ? turntables::openGrbl(std::move(channel), {.speed_deg_s = 20}, clock, {})
            : turntables::openComXim(
                  std::move(channel),
                  {.dialect = options.driver == "comxim1" ? turntables::ComXimDialect::Brackets
                                                          : turntables::ComXimDialect::Commas,
                   .speed_deg_s = 50},
                  clock, {});
    if (table) return std::move(*table);
  }
  return nullptr;
}

TorturedRig makeRig(const TortureOptions& options) {
  TorturedRig rig;
  rig.flat = makeFlatRig(options.cameras);
  const auto clock = rig.flat.truth->clock;
  const double p = options.table_trouble;
  const Mischief mischief{.lost = p,
                          .late = p,
                          .doubled = p,
                          .garbled = p,
                          .deaf = p,
                          .restart = p / 4,
                          .unplug = p / 4,
                          .seed = options.seed};
  if (options.driver == "grbl")
    rig.controller = std::make_shared<SimulatedGrbl>(clock, mischief);
  else
    rig.controller =
        std::make_shared<SimulatedComXim>(clock, mischief, options.driver == "comxim1" ? 1 : 2);
  rig.flat.truth->turned_by = [controller = rig.controller] { return controller->degrees(); };
  rig.flat.truth->scene.width = 480;
  for (std::size_t c = 0; c < rig.flat.cameras.size(); ++c)
    rig.flat.cameras[c]->chance = [random = std::mt19937_64(options.seed * 100 + c),
                                   q = options.camera_trouble]() mutable {
      using Fault = FlatCamera::Fault;
      constexpr std::array kFaults{Fault::Unplugged, Fault::Silent, Fault::Late,
                                   Fault::Truncated, Fault::Stale,  Fault::Blurred};
      const double drawn = std::uniform_real_distribution<>(0, 1)(random);
      const auto k = static_cast<std::size_t>(drawn / q);
      return k < kFaults.size() ? kFaults[k] : Fault::None;
    };
  return rig;
}

// "front camera 1 at 45.0 #17"
struct Exposure {
  std::string side;
  int camera = -1, number = -1;
  double degrees = 0;
};
Exposure exposureOf(const fs::path& file) {
  Exposure exposure;
  const Result<std::string> bytes = readFile(file);
  if (!bytes) return exposure;
  char side[16] = {};
  if (std::sscanf(noteOf(*bytes).c_str(), "%15s camera %d at %lf #%d", side, &exposure.camera,
                  &exposure.degrees, &exposure.number) != 4)
    exposure.number = -1;
  exposure.side = side;
  return exposure;
}

void inspect(const SideOptions& side, const TortureOptions& options, double stands_at,
             std::set<int>& numbers, TortureCount& count) {
  const std::string name = batch::name(side.side);
  for (int c = 0; c < options.cameras; ++c) {
    double zero = 0;
    for (int s = 0; s < kStops; ++s) {
      char file[64];
      std::snprintf(file, sizeof file, "cam%d_pos%02d.jpg", c, s);
      const Exposure e = exposureOf(side.batch / name / file);
      ++count.photographs;
      if (e.number < 0) {
        ++count.lost;
        continue;
      }
      if (s == 0) zero = e.degrees;
      const double off = std::remainder(e.degrees - zero - 360.0 * s / kStops, 360);
      const bool misnamed = e.side != name || e.camera != c || std::abs(off) > 0.6;
      const bool doubled = !numbers.insert(e.number).second;
      count.misnamed += misnamed;
      count.doubled += doubled;
      if (misnamed || doubled)
        std::fprintf(stderr, "%s %s holds %s camera %d at %.1f #%d, off by %.1f degrees\n",
                     side.batch.filename().c_str(), file, e.side.c_str(), e.camera, e.degrees,
                     e.number, off);
      if (s == kStops - 1 && c == 0)
        count.wrong_end +=
            std::abs(std::remainder(stands_at - zero - 360.0 * s / kStops, 360)) > 0.6;
    }
  }
}

// Until the side is whole; after an error as a person would: plug in again, home, go on.
bool shootUntilDone(TorturedRig& rig, const SideOptions& side, TortureCount& count) {
  QuietProgress quiet;
  const auto on_event = [&](const CaptureEvent& event) {
    count.refused += event.kind == CaptureEventKind::ShotRefused;
    count.troubles += event.kind == CaptureEventKind::Trouble;
  };
  for (int k = 0; k < kMostResumes; ++k) {
    const Result<SideSummary> done = shootSide(rig.flat.devices, side, on_event, quiet, {});
    if (done) return done->kept == kStops * static_cast<int>(rig.flat.cameras.size());
    ++count.resumed;
    devices::Turntable& table = *rig.flat.devices.turntable;
    if (!table.position_deg()) {
      (void)table.reopen({});
      (void)table.home({});
    }
    for (FlatCamera* camera : rig.flat.cameras) (void)camera->reopen({});
  }
  return false;
}

}  // namespace

TortureCount torture(const TortureOptions& options) {
  TortureCount count;
  fs::remove_all(options.folder);
  TorturedRig rig = makeRig(options);
  rig.flat.devices.turntable = openTable(options, rig);
  if (!rig.flat.devices.turntable) {
    ++count.given_up;
    return count;
  }
  std::set<int> numbers;
  for (int batch = 0; count.stops < options.stops; ++batch)
    for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
      if (count.stops >= options.stops) break;
      SideOptions shoot;
      shoot.batch = options.folder / ("b" + std::to_string(batch));
      shoot.side = side;
      shoot.stops = kStops;
      count.given_up += !shootUntilDone(rig, shoot, count);
      count.stops += kStops;
      inspect(shoot, options, rig.controller->degrees(), numbers, count);
      if (side == batch::Side::Back) fs::remove_all(shoot.batch);
    }
  count.simulated_s = rig.flat.truth->clock->now_s();
  fs::remove_all(options.folder);
  return count;
}

}  // namespace ostraka::capture::testing
