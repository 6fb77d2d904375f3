#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "command.h"
#include "options.h"
#include "virtualrig/simulate.h"

namespace ostraka::app {
namespace {

using rendering::HandHeldOptions;
using rendering::PlateColor;
using virtualrig::Fault;
using virtualrig::ScanNoise;
using virtualrig::SimulateOptions;

std::string nextStep(const SimulateOptions& options) {
  const std::string folder = options.output.string();
  const std::string chain = options.scans_only
                                ? "register --front " + folder + "/front --back " + folder + "/back"
                                : "process " + folder;
  return "ostraka " + chain + " --output OUT, then ostraka evaluate OUT --truth " + folder +
         (options.scans_only ? "" : "/truth");
}

int runSimulate(const SimulateOptions& options, Session& session) {
  if (const Result<void> checked = options.check(); !checked) return fail(session, checked.error());
  session.progress.begin(options.scans_only ? "scans" : "photographs", 1.0);
  const Result<void> made = virtualrig::simulateBatch(options, session.progress, session.stop);
  if (!made) return fail(session, made.error(), WhenStopped::RemovedItsBatch);
  const std::string output = options.output.string();
  return finish(session, Whole,
                {{"output", output}, {"sherds", options.sherds}, {"seed", options.seed}},
                "A batch of " + std::to_string(options.sherds) +
                    " virtual sherds, with its truth: " + output + "\nNext: " + nextStep(options));
}

// Photographs by hand over a sheet, which exclude what only a rig has.
void addHandHeld(CLI::App& command, SimulateOptions& options, rendering::HandHeldOptions& hand) {
  using namespace virtualrig;
  CLI::Option* by_hand = command.add_option_function<int>(
      "--hand-held",
      [&options, &hand](int photographs) {
        hand.photographs = photographs;
        options.hand_held = hand;
      },
      "No rig: this many hand-held photographs per side over a printed sheet on a table");
  using rendering::CameraKind, rendering::LightKind, rendering::TableKind, rig::SheetSize;
  addChoice(command, "--sheet", hand.sheet,
            {{"a4", SheetSize::A4}, {"a3", SheetSize::A3}, {"letter", SheetSize::Letter}}, "a4",
            "The printed sheet")
      ->needs(by_hand);
  addChoice(command, "--table", hand.table,
            {{"wood", TableKind::Wood},
             {"cloth", TableKind::Cloth},
             {"granite", TableKind::Granite},
             {"cutting-mat", TableKind::CuttingMat}},
            "wood", "The surface under the sheet")
      ->needs(by_hand);
  addChoice(command, "--light", hand.light,
            {{"window", LightKind::Window},
             {"lamp", LightKind::Lamp},
             {"flash", LightKind::Flash},
             {"overcast", LightKind::Overcast},
             {"sun", LightKind::Sun}},
            "window", "The light of the room")
      ->needs(by_hand);
  addChoice(
      command, "--camera", hand.camera,
      {{"phone", CameraKind::Phone}, {"dslr", CameraKind::Dslr}, {"compact", CameraKind::Compact}},
      "phone", "What takes the photographs")
      ->needs(by_hand);
  command.add_option("--bend", hand.bend_mm, "How far the sheet bends up from the table, mm")
      ->capture_default_str()
      ->needs(by_hand);
  command
      .add_option("--clutter", hand.clutter,
                  "Objects beside the sherds, 0 to 4: scale bar, label, colour card, pencil")
      ->capture_default_str()
      ->needs(by_hand);
  for (const char* of_a_rig : {"--stops", "--plate", "--scans-only", "--scan-noise", "--fault"})
    by_hand->excludes(command.get_option(of_a_rig));
}

void addSimulate(CLI::App& rig, Command& chosen) {
  CLI::App* command = rig.add_subcommand(
      "simulate",
      "Write a batch of a virtual rig, or of photographs by hand, with the complete truth");
  auto options = std::make_shared<SimulateOptions>();
  command->add_option("--output,-o", options->output, "New or empty folder for the batch")
      ->required();
  command->add_option("--seed", options->seed, "Start of all chance")->capture_default_str();
  command->add_option("--sherds", options->sherds, "Number of sherds")->capture_default_str();
  command
      ->add_option("--mesh", options->meshes,
                   "Photograph this closed mesh (PLY, mm) instead of sherds; once per object")
      ->check(CLI::ExistingFile)
      ->excludes("--sherds");
  command->add_option("--width", options->width, "Width of a photograph in pixels")
      ->capture_default_str();
  command->add_option("--stops", options->stops, "Turntable positions in a turn")
      ->capture_default_str();
  addChoice(*command, "--plate", options->plate,
            {{"dark", PlateColor::Dark},
             {"mid", PlateColor::Grey},
             {"grey", PlateColor::Grey},
             {"light", PlateColor::Light},
             {"white", PlateColor::White}},
            "dark", "Colour of the plate: dark, mid, light or white");
  command->add_flag("--plain", options->plain, "Plain clay: neither slip nor paint");
  command->add_option("--gloss", options->gloss,
                      "Share of shiny sherds, 0 to 1, among usual, black, grey and white clays");
  command->add_option("--fstop", options->fstop,
                      "Depth of field at this f-number; 0: everything sharp");
  command->add_flag("--scramble", options->scramble, "The sherds change places at the flip");
  command
      ->add_option("--near-duplicates", options->near_duplicates, "Groups of two that look alike")
      ->capture_default_str();
  command->add_option("--touching", options->touching, "Pairs of sherds that touch each other")
      ->capture_default_str();
  command->add_flag("--scans-only", options->scans_only, "Scans of both sides, no photographs");
  addChoice(*command, "--scan-noise", options->scan_noise,
            {{"scanner", ScanNoise::Scanner}, {"stereo", ScanNoise::Stereo}}, "scanner",
            "How the scans err: scanner or stereo");
  addThreads(*command, options->threads);
  command->footer(
      "Faults, to see what the program says of them: blur (one camera out of focus at three "
      "stops),\n"
      "missing (three photographs), moved (a sherd pushed by 4 mm half-way round), covered (a "
      "cloth\n"
      "on a third of the markers), shadow (of a hand, at one stop), truncated (two files cut "
      "off).");
  command->add_option("--fault", options->fault, "A deliberate fault, see below")
      ->transform(
          CLI::CheckedTransformer(std::map<std::string, Fault>{{"blur", Fault::Blur},
                                                               {"missing", Fault::Missing},
                                                               {"moved", Fault::Moved},
                                                               {"covered", Fault::Covered},
                                                               {"shadow", Fault::Shadow},
                                                               {"truncated", Fault::Truncated}}));
  auto hand = std::make_shared<rendering::HandHeldOptions>();
  addHandHeld(*command, *options, *hand);
  command->callback([options, hand, &chosen] {
    if (!options->meshes.empty()) options->sherds = static_cast<int>(options->meshes.size());
    if (options->hand_held) options->hand_held = *hand;  // the options after it count, too
    chosen = [options](Session& session) { return runSimulate(*options, session); };
  });
}

}  // namespace

void addRig(CLI::App& root, Command& chosen) {
  CLI::App* rig = root.add_subcommand("rig", "Cameras and turntable: calibrate, predict, simulate");
  rig->require_subcommand(1);
  addRigCalibrate(*rig, chosen);
  addRigPredict(*rig, chosen);
  addSimulate(*rig, chosen);
}

}  // namespace ostraka::app
