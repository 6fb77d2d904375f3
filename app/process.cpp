#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "command.h"
#include "files/json.h"
#include "intake/computed_again.h"
#include "options.h"
#include "pipeline/process_batch.h"
#include "registration/within.h"
#include "shown.h"

namespace ostraka::app {
namespace {

using nlohmann::ordered_json;
using pipeline::DenseMethod;
using pipeline::ProcessOptions;
using pipeline::ProcessSummary;
using pipeline::SherdSummary;

ordered_json asJson(const ProcessSummary& summary) {
  ordered_json sherds = ordered_json::array();
  for (const SherdSummary& s : summary.sherds)
    sherds.push_back({{"number", s.number},
                      {"front", s.front},
                      {"back", s.back},
                      {"score", orNull(s.score)},
                      {"ambiguous", s.ambiguous},
                      {"decided_by", s.decided_by},
                      {"fracture_rms_mm",
                       s.fracturesCompared() ? ordered_json(s.fracture_rms_mm) : ordered_json()},
                      {"uncertainty_mm", s.uncertainty_mm},
                      {"model", s.has_model},
                      {"munsell", s.munsell ? colour::toJson(*s.munsell) : ordered_json()},
                      {"remark", s.remark}});
  return {{"sherds", sherds},
          {"unpaired_front", summary.unpaired_front},
          {"unpaired_back", summary.unpaired_back},
          {"set_aside", summary.set_aside},
          {"reshoot", summary.reshoot},
          {"moved", summary.moved},
          {"left_out", summary.left_out},
          {"scale_doubts", summary.scale_doubts},
          {"draft", summary.draft},
          {"warnings", summary.warnings},
          {"reprojection_rms_px", summary.reprojection_rms_px},
          {"seconds", summary.seconds},
          {"report", summary.report.string()},
          {"whole", summary.whole()}};
}

void printTable(const ProcessSummary& summary) {
  show(stdout, "%-6s %-8s %-8s %7s %15s %12s  %s\n", "sherd", "front", "back", "score",
       "fracture RMS mm", "within mm", "");
  for (const SherdSummary& s : summary.sherds) {
    const std::string state = std::string(s.ambiguous ? "AMBIGUOUS " : "") +
                              (s.decided_by.empty() ? "" : "decided by " + s.decided_by + " ") +
                              (s.has_model ? "" : "no model ") + s.remark;
    show(stdout, "%-6s %-8s %-8s %7s %15s %12.2f  %s\n", s.number.c_str(), s.front.c_str(),
         s.back.c_str(), s.score ? fixed(*s.score, 4).c_str() : "-",
         s.fracturesCompared() ? fixed(s.fracture_rms_mm, 3).c_str() : "-",
         registration::within95_mm(s.uncertainty_mm), state.c_str());
  }
  printNames("Fronts without a back", summary.unpaired_front);
  printNames("Backs without a front", summary.unpaired_back);
  printNames("To be reshot", summary.reshoot);
  printNames("Pushed while photographed", summary.moved);
  printNames("Set aside", summary.set_aside);
  for (const Message& sentence : summary.left_out) show(stdout, "%s\n", sentence.english().c_str());
  show(stdout, "%zu %s, reprojection %.2f px, %.0f s. Report: %s\n", summary.sherds.size(),
       summary.sherds.size() == 1 ? "sherd" : "sherds", summary.reprojection_rms_px,
       summary.seconds, summary.report.c_str());
  if (summary.draft)
    show(stdout,
         "This is a draft: its measurements are coarse; process it without --draft for final "
         "ones.\n");
  if (!summary.warnings.empty())
    show(stdout,
         summary.warnings.size() == 1 ? "%zu warning; the report names it.\n"
                                      : "%zu warnings; the report names them.\n",
         summary.warnings.size());
  if (summary.ambiguous() > 0)
    show(stdout,
         summary.ambiguous() == 1
             ? "%d pair needs review: the report says why; decide it in the window.\n"
             : "%d pairs need review: the report says why; decide them in the window.\n",
         summary.ambiguous());
  for (const Message& doubt : summary.scale_doubts)
    show(stdout, "Decide this before measuring anything: %s\n", doubt.english().c_str());
}

int runProcess(const ProcessOptions& options, Session& session) {
  const Result<void> queued = [&] {
    Result<void> good = options.check();
    return good ? intake::queueOwnerOf(options.output, session.progress) : good;
  }();
  if (!queued) return fail(session, queued.error(), WhenStopped::GoesOn);
  const Result<ProcessSummary> summary =
      pipeline::processBatch(options, session.progress, session.stop);
  if (!summary) return fail(session, summary.error(), WhenStopped::GoesOn);
  const int status = summary->ambiguous() > 0 || !summary->scale_doubts.empty() ? PersonMustDecide
                     : summary->whole()                                         ? Whole
                                                                                : NotWhole;
  return finish(session, status, asJson(*summary), [&] { printTable(*summary); });
}

}  // namespace

void addProcess(CLI::App& root, Command& chosen) {
  CLI::App* command =
      root.add_subcommand("process", "Turn photographs of sherds into complete models");
  command->footer(
      "PHOTOGRAPHS is a batch folder (front/, back/, plate.json), or a folder with photographs by\n"
      "hand of the front; BACK then has those of the back. A fixed camera over a turning round\n"
      "plate gives such folders, too. Names and formats are as the camera left them.\n"
      "plate.json of the sheet is beside the photographs, in the folder above, or is named.\n"
      "Without it, markers are detected in the photographs; without markers, COLMAP finds the\n"
      "cameras, and only scale.json gives the result a scale.\n"
      "\n"
      "If stopped or killed, the same command resumes after the last complete stage. Open\n"
      "OUT/report.html to see the result.");
  auto options = std::make_shared<ProcessOptions>();
  command
      ->add_option("PHOTOGRAPHS", options->batch,
                   "Batch folder, or folder with the photographs of the front")
      ->required();
  command->add_option("BACK", options->back, "Folder with the photographs of the back");
  command->add_option("--output,-o", options->output, "Folder for the result; made when absent")
      ->required();
  command->add_option("--rig", options->rig, "RIG.json of an earlier calibration");
  command->add_option("--sheet", options->sheet,
                      "Printed sheet or plate under the sherds, as a JSON file like plate.json");
  command
      ->add_option(
          "--marker-mm", options->marker_mm,
          "Without plate.json: side of a marker's black square on the sheet, which is found in "
          "the photographs")
      ->check(CLI::Range(0.5, 1000.0));
  addThreads(*command, options->threads);
  addChoice(*command, "--dense", options->dense,
            {{"builtin", DenseMethod::Builtin},
             {"colmap", DenseMethod::Colmap},
             {"openmvs", DenseMethod::OpenMvs}},
            "builtin", "Dense reconstruction: builtin, colmap or openmvs");
  command
      ->add_option("--masks", options->masks,
                   "Masks: auto (from the plate), given (beside the photographs), or a "
                   "segmentation network as an ONNX file")
      ->capture_default_str();
  command
      ->add_option(
          "--megapixels", options->megapixels,
          "Larger photographs are averaged down to this many megapixels for stereo: more gives "
          "finer models and takes more time")
      ->capture_default_str()
      ->check(CLI::Range(0.3, 1000.0));
  command
      ->add_option("--memory", options->memory_gb,
                   "Memory for masks and stereo, GB: with less, stereo works part by part, and "
                   "masks are made on fewer pixels")
      ->capture_default_str()
      ->check(CLI::Range(1.0, 4000.0));
  command->add_flag_callback(
      "--draft", [options] { options->megapixels = pipeline::kDraftMegapixels; },
      "A quick look, coarser; the same command without it computes the final models");
  addChoice(
      *command, "--texture", options->texture,
      {{"photo", pipeline::TextureColours::Photo}, {"albedo", pipeline::TextureColours::Albedo}},
      "photo",
      "Textures as photographed (photo), or without the light that fell on the sherds "
      "(albedo), which has to stand still from the first photograph to the last");
  addPairing(*command, options->pairing, options->registration, options->boundary);
  command->callback([options, &chosen] {
    checkBoundary(options->registration, options->boundary);
    chosen = [options](Session& session) { return runProcess(*options, session); };
  });
}

}  // namespace ostraka::app
