#include "capture/sequence.h"

#include <poll.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "batch/batch.h"
#include "capture/manifest.h"
#include "capture/rig_devices.h"
#include "command.h"
#include "files/output_place.h"
#include "shown.h"
#include "virtualrig/virtual_camera.h"

namespace ostraka::app {
namespace {

namespace fs = std::filesystem;
using capture::CaptureEvent;
using capture::CaptureEventKind;
using capture::RigDevices;
using capture::ShotName;
using capture::SideCheck;
using capture::SideOptions;
using capture::SideSummary;

enum class Sides { Front, Back, Both };

struct CaptureArguments {
  std::string rig;  // a file, or "virtual"
  Sides side = Sides::Front;
  fs::path output;
  int stops = 8;
  std::vector<std::string> again;
  virtualrig::VirtualDevicesOptions virtual_rig;
};

// "5B": camera B at the fifth stop, as people count.
Result<ShotName> shotFromWord(const std::string& word) {
  std::size_t digits = 0;
  while (digits < word.size() && digits < 3 && word[digits] >= '0' && word[digits] <= '9') ++digits;
  const char letter = digits + 1 == word.size() ? word[digits] : '?';
  if (digits == 0 || letter < 'A' || letter > 'Z')
    return Error::unusable("--again takes a position and a camera, such as 5B; not " + word + ".");
  return ShotName{std::stoi(word.substr(0, digits)) - 1, letter - 'A'};
}

// A sentence to the terminal, then Enter; the end of the input means no.
bool askOnTerminal(const Message& sentence, std::stop_token stop) {
  show(stderr, "\n%s Then press Enter. ", sentence.english().c_str());
  std::fflush(stderr);
  while (!stop.stop_requested()) {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (::poll(&input, 1, 100) <= 0) continue;
    char letter = 0;
    const ssize_t n = ::read(STDIN_FILENO, &letter, 1);
    if (n <= 0) return false;
    if (letter == '\n') return true;
  }
  return false;
}

Result<RigDevices> openDevices(const CaptureArguments& arguments, Session& session) {
  if (arguments.rig == "virtual") return virtualrig::openVirtualRig(arguments.virtual_rig);
  return capture::openRigDevices(arguments.rig, askOnTerminal, session.stop);
}

// A table without a switch counts from where it stands; the photographs of a side that was begun
// before tell where that is.
Result<void> startPosition(RigDevices& devices, const SideOptions& options, Session& session) {
  if (devices.turntable->position_deg()) return {};
  const Result<void> homed = devices.turntable->home(session.stop);
  if (homed || homed.error().code != ErrorCode::Missing) return homed;
  const auto missing = capture::missingShots(options, static_cast<int>(devices.cameras.size()));
  if (!missing) return missing.error();
  const bool fresh =
      missing->size() == devices.cameras.size() * static_cast<std::size_t>(options.stops);
  if (!fresh) return {};
  session.progress.note(
      NoteLevel::Info,
      "capture: the turntable has no zero switch; angles count from its present position");
  return devices.turntable->zeroHere(session.stop);
}

void tell(const CaptureEvent& event, Session& session) {
  const std::string shot = "capture: position " + std::to_string(event.stop + 1) + ", camera " +
                           batch::cameraLetter(event.camera);
  switch (event.kind) {
    case CaptureEventKind::PressShutter:
      session.finishProgress();
      show(stderr, "Press the shutter of camera %s.\n", batch::cameraLetter(event.camera).c_str());
      break;
    case CaptureEventKind::ShotKept:
      for (const Message& sentence : event.check.sentences())
        session.progress.note(NoteLevel::Warning, about(shot, sentence));
      break;
    default:
      break;
  }
}

struct SideResult {
  SideSummary summary;
  std::vector<Message> sentences;  // everything that asks a person
};

// Nothing where the front was not photographed.
Result<std::optional<SideCheck>> checkFront(const CaptureArguments& arguments,
                                            const RigDevices& devices, Session& session) {
  const Result<capture::Manifest> manifest = capture::readManifest(arguments.output);
  if (!manifest) return manifest.error();
  std::vector<std::vector<fs::path>> files(devices.cameras.size());
  for (int s = 0; s < arguments.stops; ++s)
    for (std::size_t c = 0; c < files.size(); ++c)
      if (const auto* entry = manifest->find(batch::Side::Front, s, static_cast<int>(c)))
        files[c].push_back(arguments.output / entry->file);
  if (std::all_of(files.begin(), files.end(), [](const auto& one) { return one.empty(); }))
    return std::optional<SideCheck>();
  Result<SideCheck> checked = capture::checkSide(files, devices.plate, {}, session.stop);
  if (!checked) return checked.error();
  return std::optional(std::move(*checked));
}

Result<SideResult> shoot(const CaptureArguments& arguments, batch::Side side, RigDevices& devices,
                         Session& session) {
  SideOptions options;
  options.batch = arguments.output;
  options.side = side;
  options.stops = arguments.stops;
  for (const std::string& word : arguments.again) {
    const Result<ShotName> shot = shotFromWord(word);
    if (!shot) return shot.error();
    options.retake.push_back(*shot);
  }
  if (const Result<void> ready = startPosition(devices, options, session); !ready)
    return ready.error();
  session.progress.begin(batch::name(side), arguments.side == Sides::Both ? 0.5 : 1.0);
  Result<SideSummary> done = capture::shootSide(
      devices, options, [&](const CaptureEvent& event) { tell(event, session); }, session.progress,
      session.stop);
  if (!done) {
    Error error = done.error();
    if (error.code != ErrorCode::Cancelled)
      error.what = inOne(error.what,
                         "The photographs so far are saved; run the same command again to resume.");
    return error;
  }
  SideResult result{*done, done->check.sentences};
  if (!done->flagged.empty())
    result.sentences.push_back(
        "Photographs kept despite problems: " + std::to_string(done->flagged.size()) +
        "; check them before you continue.");
  if (side == batch::Side::Back) {
    const Result<std::optional<SideCheck>> front = checkFront(arguments, devices, session);
    if (!front) return front.error();
    if (!*front)
      result.sentences.push_back(
          "This batch has no photographs of the front: take them with --side front into the same "
          "folder.");
    else
      for (Message& sentence : capture::compareSides(**front, done->check))
        result.sentences.push_back(std::move(sentence));
  }
  return result;
}

nlohmann::ordered_json asJson(const SideResult& result, batch::Side side, int stops) {
  nlohmann::ordered_json flagged = nlohmann::ordered_json::array();
  for (const ShotName& shot : result.summary.flagged)
    flagged.push_back({{"stop", shot.stop}, {"camera", shot.camera}});
  return {{"side", batch::name(side)},
          {"photographs", result.summary.kept},
          {"flagged", flagged},
          {"sherds", result.summary.check.sherds},
          {"touching", result.summary.check.touching},
          {"sentences", result.sentences},
          {"overhead_s_per_stop", result.summary.overhead_s / stops}};
}

void print(const SideResult& result, batch::Side side, const CaptureArguments& arguments) {
  show(stdout, "%s: %d photographs, %d sherd%s.\n", batch::name(side), result.summary.kept,
       result.summary.check.sherds, result.summary.check.sherds == 1 ? "" : "s");
  for (const Message& sentence : result.sentences)
    show(stdout, "  %s\n", sentence.english().c_str());
  if (result.sentences.empty())
    show(stdout, "  %s\n",
         side == batch::Side::Front ? "You may turn the sherds over now."
                                    : "You may clear the plate.");
  if (arguments.side == Sides::Front)
    show(stdout, "Then: the same command with --side back\n");
  else if (side == batch::Side::Back && result.sentences.empty())
    show(stdout, "Next: ostraka process %s --output OUT\n", arguments.output.c_str());
}

int runCapture(const CaptureArguments& arguments, Session& session) {
  if (arguments.side == Sides::Both && arguments.rig != "virtual")
    return fail(session, {ErrorCode::UnusableInput,
                          "A person has to turn the sherds over in between: photograph the front, "
                          "then the back.",
                          {}});
  if (const Result<void> good = checkOutputPlace(arguments.output, "batches"); !good)
    return fail(session, good.error());
  Result<RigDevices> devices = openDevices(arguments, session);
  if (!devices) return fail(session, devices.error());
  std::vector<batch::Side> sides;
  if (arguments.side != Sides::Back) sides.push_back(batch::Side::Front);
  if (arguments.side != Sides::Front) sides.push_back(batch::Side::Back);
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  std::vector<std::pair<batch::Side, SideResult>> results;
  bool asks = false;
  for (const batch::Side side : sides) {
    Result<SideResult> result = shoot(arguments, side, *devices, session);
    if (!result) return fail(session, result.error(), WhenStopped::GoesOn);
    asks = asks || !result->sentences.empty();
    list.push_back(asJson(*result, side, arguments.stops));
    results.emplace_back(side, std::move(*result));
  }
  if (arguments.rig == "virtual") {
    session.progress.begin("calibration", 0);
    const Result<void> written = virtualrig::writeVirtualCalibration(
        arguments.virtual_rig, arguments.output, session.progress, session.stop);
    if (!written) return fail(session, written.error());
  }
  return finish(session, asks ? PersonMustDecide : Whole,
                {{"batch", arguments.output.string()}, {"sides", list}}, [&] {
                  for (const auto& [side, result] : results) print(result, side, arguments);
                });
}

}  // namespace

void addCapture(CLI::App& root, Command& chosen) {
  CLI::App* command =
      root.add_subcommand("capture", "Photograph one side of a batch; resumes where it stopped");
  auto arguments = std::make_shared<CaptureArguments>();
  command->add_option("--rig", arguments->rig, "RIG.json, or the word virtual")->required();
  command->add_option("--side", arguments->side, "front, back, or both (virtual rig only)")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Sides>{
          {"front", Sides::Front}, {"back", Sides::Back}, {"both", Sides::Both}}))
      ->required();
  command->add_option("--output,-o", arguments->output, "Folder of the batch")->required();
  command->add_option("--stops", arguments->stops, "Turntable positions in a turn")
      ->capture_default_str();
  command->add_option("--again", arguments->again,
                      "Photographs to retake, such as 5B: camera B at position 5");
  auto& rig = arguments->virtual_rig;
  command->add_option("--seed", rig.seed, "Virtual rig: start of all chance")
      ->capture_default_str();
  command->add_option("--sherds", rig.sherds, "Virtual rig: number of sherds")
      ->capture_default_str();
  command->add_option("--width", rig.width, "Virtual rig: width of a photograph in pixels")
      ->capture_default_str();
  command->add_option("--turn-speed", rig.turn_deg_s,
                      "Virtual rig: degrees per second of the turntable; 0: immediately");
  command->add_option("--settle", rig.settle_s, "Virtual rig: seconds that the table settles");
  command->callback([arguments, &chosen] {
    arguments->virtual_rig.stops = arguments->stops;
    chosen = [arguments](Session& session) { return runCapture(*arguments, session); };
  });
}

}  // namespace ostraka::app
