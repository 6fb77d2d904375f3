// A thousand stops while everything goes wrong now and then, or the sequence's own time a stop.
//   capture_torture grbl|comxim1|comxim2 [STOPS] [SEED]
//   capture_torture overhead
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>

#include "../core/capture/flat_rig.h"
#include "../core/capture/torture.h"

namespace {

using namespace ostraka;
namespace fs = std::filesystem;

int runTorture(const char* driver, int stops, std::uint64_t seed) {
  capture::testing::TortureOptions options;
  options.driver = driver;
  options.stops = stops;
  options.seed = seed;
  options.cameras = 1;
  options.folder = fs::temp_directory_path() / (std::string("ostraka_bench_") + driver);
  const std::clock_t before = std::clock();
  const auto c = capture::testing::torture(options);
  std::printf(
      "%s: %d stops, %d photographs: lost %d, doubled %d, misnamed %d; wrong at the end %d, given "
      "up "
      "%d; refused %d, troubles %d, gone on %d times; %.0f simulated s, %.0f CPU s\n",
      driver, c.stops, c.photographs, c.lost, c.doubled, c.misnamed, c.wrong_end, c.given_up,
      c.refused, c.troubles, c.resumed, c.simulated_s,
      static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
  return c.lost + c.doubled + c.misnamed + c.wrong_end + c.given_up == 0 ? 0 : 1;
}

// Three cameras of 1600 x 1200 pixels, eight stops, a table that needs 2.25 s a stop, real time.
int runOverhead() {
  auto rig = capture::testing::makeFlatRig(3);
  rig.truth->clock = devices::steadyClock();
  rig.truth->scene.width = 1600;
  rig.devices.clock = rig.truth->clock;
  rig.devices.settle_s = 1.0;
  capture::SideOptions options;
  options.batch = fs::temp_directory_path() / "ostraka_bench_overhead";
  fs::remove_all(options.batch);
  QuietProgress quiet;
  const auto done = capture::shootSide(rig.devices, options, {}, quiet, {});
  fs::remove_all(options.batch);
  if (!done) {
    std::printf("%s\n", done.error().sentence().english().c_str());
    return 1;
  }
  std::printf("overhead: %.1f ms a stop, %d photographs\n", 1000 * done->overhead_s / options.stops,
              done->kept);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  if (std::string(argv[1]) == "overhead") return runOverhead();
  return runTorture(argv[1], argc > 2 ? std::atoi(argv[2]) : 1000,
                    argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
}
