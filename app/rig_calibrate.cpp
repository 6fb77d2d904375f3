#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "calibration/calibration_report.h"
#include "command.h"
#include "files/output_place.h"
#include "shown.h"

namespace ostraka::app {
namespace {

using calibration::CalibrationOptions;
using calibration::CalibrationReport;
using calibration::Verdict;
using nlohmann::ordered_json;

const char* name(Verdict verdict) {
  return verdict == Verdict::Good ? "good" : verdict == Verdict::Usable ? "usable" : "not usable";
}

ordered_json asJson(const CalibrationReport& report, const std::string& output) {
  ordered_json cameras = ordered_json::array(), held_out = cameras, lengths = cameras;
  for (const calibration::CameraCalibration& c : report.cameras)
    cameras.push_back({{"camera", c.camera},
                       {"focal_px", c.focal_px},
                       {"focal_sd_px", c.focal_sd_px},
                       {"lens_rms_px", c.lens_rms_px},
                       {"pictures", c.pictures},
                       {"worst_picture", c.worst_picture},
                       {"worst_picture_rms_px", c.worst_picture_rms_px},
                       {"corners_per_region", c.corners_per_region},
                       {"largest_tilt_rad", c.largest_tilt_rad},
                       {"tilted_pictures", c.tilted_pictures},
                       {"plate_residual_px", c.plate_residual_px}});
  for (const calibration::HeldOutDistance& d : report.held_out)
    held_out.push_back({{"markers", {d.first, d.second}},
                        {"expected_mm", d.expected_mm},
                        {"measured_mm", d.measured_mm},
                        {"error_pct", 100 * d.error()}});
  for (const calibration::MeasuredLength& m : report.lengths)
    lengths.push_back({{"markers", {m.length.first, m.length.second}},
                       {"by_hand_mm", m.length.mm},
                       {"found_mm", m.found_mm},
                       {"error_pct", 100 * (m.found_mm / m.length.mm - 1)}});
  return {{"verdict", name(report.verdict)},
          {"verdict_in_words", report.verdict_in_words},
          {"rig", report.rig ? ordered_json(output) : ordered_json()},
          {"cameras", cameras},
          {"reprojection_rms_px", report.reprojection_rms_px},
          {"held_out", held_out},
          {"lengths", lengths},
          {"missing", report.missing},
          {"set_aside", report.set_aside}};
}

// What describes the targets: a rig of the same name would take its place.
std::vector<std::filesystem::path> descriptionsIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const char* side : {"", "front", "back"})
    for (const char* name : {"plate.json", "board.json", "scale.json"})
      files.push_back(folder / side / name);
  return files;
}

int runCalibrate(const std::filesystem::path& folder, const std::filesystem::path& output,
                 const CalibrationOptions& options, Session& session) {
  if (const Result<void> good = checkOutputFile(output, {".json"}, descriptionsIn(folder)); !good)
    return fail(session, good.error());
  if (const Result<void> good = rig::checkRigOutput(output); !good)
    return fail(session, good.error());
  session.progress.begin("calibration", 1.0);
  const Result<CalibrationReport> report =
      calibration::calibrateFolder(folder, options, session.progress, session.stop);
  if (!report) return fail(session, report.error());
  if (report->rig)
    if (const Result<void> written = rig::writeRig(output, *report->rig); !written)
      return fail(session, written.error());
  const int status = report->rig                          ? Whole
                     : calibration::scaleIsRight(*report) ? NotWhole
                                                          : PersonMustDecide;
  return finish(session, status, asJson(*report, output.string()), [&] {
    for (const Message& line : calibration::inWords(*report))
      show(stdout, "%s\n", line.english().c_str());
    if (report->rig)
      show(stdout, "Saved: %s\n", output.c_str());
    else
      show(stdout, "Nothing was saved%s\n",
           status == PersonMustDecide ? ": the scale has to be put right first." : ".");
  });
}

// "0,12,314.2": two markers and millimetres.
std::string parseLength(const std::string& text, CalibrationOptions& options) {
  calibration::MarkerLength length;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%d,%d,%lf%c", &length.first, &length.second, &length.mm, &rest) !=
      3)
    return "Give two markers and a length, as 0,12,314.2";
  options.lengths.push_back(length);
  return {};
}

}  // namespace

void addRigCalibrate(CLI::App& rig, Command& chosen) {
  CLI::App* command = rig.add_subcommand(
      "calibrate", "Lenses, places and scale from photographs of the plate and the board");
  auto options = std::make_shared<CalibrationOptions>();
  auto folder = std::make_shared<std::filesystem::path>();
  auto output = std::make_shared<std::filesystem::path>();
  command
      ->add_option("FOLDER", *folder,
                   "A batch, or a folder with front/ (the plate at each stop), calib/ (the board), "
                   "plate.json and board.json; or pictures of a board alone with board.json")
      ->required();
  command->add_option("--output,-o", *output, "RIG.json to write")->required();
  command
      ->add_option_function<std::vector<std::string>>(
          "--length",
          [options](const std::vector<std::string>& texts) {
            for (const std::string& text : texts)
              if (const std::string wrong = parseLength(text, *options); !wrong.empty())
                throw CLI::ValidationError("--length", wrong);
          },
          "Scale check: A,B,MM as measured by hand between the middles of the outer edges of "
          "markers A and B")
      ->allow_extra_args(false);
  addThreads(*command, options->threads);
  workOf(*command, chosen, runCalibrate, folder, output, options);
}

}  // namespace ostraka::app
