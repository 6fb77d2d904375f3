#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "batch/batch.h"
#include "command.h"
#include "files/output_place.h"
#include "files/scratch_folder.h"
#include "shown.h"
#include "virtualrig/predict.h"

namespace ostraka::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using virtualrig::Prediction;
using virtualrig::PredictOptions;
using virtualrig::SizePrediction;

ordered_json asJson(const Prediction& p) {
  ordered_json sizes = ordered_json::array();
  for (const SizePrediction& s : p.sizes)
    sizes.push_back({{"size", s.name},
                     {"width_mm", s.width_mm},
                     {"sherds", s.sherds},
                     {"without_model", s.without_model},
                     {"accuracy_simulated_mm", s.accuracy_mm},
                     {"accuracy_expected_mm", p.expectedAccuracy(s)},
                     {"completeness_pct", s.completeness_percent},
                     {"seen_pct", 100 * s.seen},
                     {"break_seen_pct", 100 * s.break_seen},
                     {"seconds_expected", p.expectedSeconds(s.seconds)}});
  ordered_json moves = ordered_json::array();
  for (const virtualrig::MoveTried& tried : p.moves) {
    ordered_json there = ordered_json::array();
    for (std::size_t k = 0; k < 3; ++k)
      there.push_back({{"size", p.sizes[k].name},
                       {"without_model", tried.sizes[k].without_model},
                       {"accuracy_expected_mm", p.expectedAccuracy(tried.sizes[k])},
                       {"completeness_pct", tried.sizes[k].completeness_percent}});
    moves.push_back({{"camera", p.cameras[static_cast<std::size_t>(tried.move.camera)]},
                     {"raise_deg", tried.move.raise_rad * 180 / M_PI},
                     {"better", tried.better},
                     {"sizes", there}});
  }
  return {{"sizes", sizes},
          {"simulated_width_share", p.width_share},
          {"seconds_simulated", p.seconds},
          {"seconds_expected", p.expectedSeconds(p.seconds)},
          {"seconds_of_any_batch", p.expectedSeconds(p.fixed_seconds)},
          {"processors", p.processors},
          {"threads", p.threads},
          {"photographs", p.photographs},
          {"moves", moves},
          {"cameras", p.cameras},
          {"elevations_rad", p.elevations_rad},
          {"pixels_mm", p.pixels_mm},
          {"remarks", p.remarks}};
}

void print(const Prediction& p) {
  for (std::size_t c = 0; c < p.elevations_rad.size(); ++c)
    show(stdout, "Camera %s: %.0f degrees above the plate, %.3f mm a pixel.\n",
         batch::cameraLetter(p.cameras[c]).c_str(), p.elevations_rad[c] * 180 / M_PI,
         p.pixels_mm[c]);
  show(stdout, "%-8s %9s %13s %15s %10s %14s %14s\n", "sherds", "width mm", "accuracy mm",
       "completeness %", "seen %", "breaks seen %", "seconds each");
  int sherds = 0;
  for (const SizePrediction& s : p.sizes) {
    show(stdout, "%-8s %9.0f %13.3f %15.1f %10.1f %14.1f %14.0f\n", s.name.c_str(), s.width_mm,
         p.expectedAccuracy(s), s.completeness_percent, 100 * s.seen, 100 * s.break_seen,
         p.expectedSeconds(s.seconds));
    if (s.without_model > 0)
      show(stdout, "         %d of %d got no model.\n", s.without_model, s.sherds);
    sherds += s.sherds;
  }
  show(stdout,
       "A batch of %d photographs takes %.0f s on this computer, plus the time of each sherd.\n",
       p.photographs, p.expectedSeconds(p.fixed_seconds));
  // A computer to itself keeps nine tenths of its processors at work.
  if (const double idle = p.processors / (0.9 * p.threads); idle < 0.8)
    show(stdout,
         "Other programs kept it busy: %.1f of %d processors worked at this; with all of them it "
         "takes about %.0f %% of these seconds.\n",
         p.processors, p.threads, 100 * idle);
  if (p.width_share < 1)
    show(stdout,
         "Extrapolated from pictures of %.0f %% of the width, which took %.0f s for %d sherds: the "
         "accuracy and the completeness will be better than this, and the seconds fewer. Leave out "
         "--width for the exact way.\n",
         100 * p.width_share, p.seconds, sherds);
  for (const Message& remark : p.remarks) show(stdout, "%s\n", remark.english().c_str());
}

int runPredict(const fs::path& rig_file, PredictOptions options, Session& session) {
  if (const Result<void> good = checkOutputPlace(options.work); !good)
    return fail(session, good.error());
  const Result<rig::Rig> rig = rig::readRig(rig_file);
  if (!rig) return fail(session, rig.error());
  std::optional<ScratchFolder> scratch;
  if (options.work.empty()) {
    Result<ScratchFolder> made = ScratchFolder::make("ostraka-predict");
    if (!made) return fail(session, made.error());
    scratch.emplace(std::move(*made));
    options.work = scratch->path();
  }
  const Result<Prediction> prediction =
      virtualrig::predict(*rig, options, session.progress, session.stop);
  if (!prediction) return fail(session, prediction.error());
  return finish(session, Whole, asJson(*prediction), [&] { print(*prediction); });
}

}  // namespace

void addRigPredict(CLI::App& rig, Command& chosen) {
  CLI::App* command = rig.add_subcommand(
      "predict", "What a calibrated rig will do: accuracy, completeness, seconds");
  command->footer(
      "Virtual sherds of about 26, 48 and 82 mm, matte and on the standard dark plate, are\n"
      "photographed by the rig's own cameras at its stops and go through the whole chain; the\n"
      "models are compared with the truth. 90 % of a model's surface is within 'accuracy' of\n"
      "the truth; 'completeness' is the share of the truth within 0.25 mm of the model. 'seen'\n"
      "comes from rays: by three photographs of a side; breaks by both sides. Rays also say which\n"
      "camera, 10 or 20 degrees higher or lower, would look at the sherds more squarely, or close "
      "a\n"
      "step between cameras that is too wide for pictures to match; the same\n"
      "sherds are then photographed from there, and it is recommended only if their models become\n"
      "better. With a smaller --width accuracy and seconds are extrapolated: errors with the size\n"
      "of a pixel, time with its square. Depth of field, gloss and an unsteady turntable are not\n"
      "simulated: real figures can only be worse. Small sherds vary most: two of them may differ\n"
      "by a third, --sherds-per-size 4 tells more.");
  auto options = std::make_shared<PredictOptions>();
  auto file = std::make_shared<fs::path>();
  command->add_option("RIG.json", *file, "As 'ostraka rig calibrate' wrote it")->required();
  command->add_option(
      "--width", options->width,
      "Of the simulated pictures, pixels; quicker and coarser than left out, which means "
      "what 'ostraka process' works on: the rig's own, or its --megapixels");
  command
      ->add_option("--sherds-per-size", options->sherds_per_size, "Small, medium, large: of each")
      ->capture_default_str();
  command
      ->add_option("--moves", options->moves,
                   "Of cameras, to simulate at most, until one makes better models; 0: none. Each "
                   "takes as long as the rest")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Start of all chance")->capture_default_str();
  command->add_option("--work", options->work,
                      "New folder that keeps the simulated batch and its models");
  addThreads(*command, options->threads);
  workOf(*command, chosen, runPredict, file, options);
}

}  // namespace ostraka::app
