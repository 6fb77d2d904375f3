#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <vector>

#include "base/parallel.h"
#include "base/text.h"
#include "colmap/colmap_program.h"
#include "command.h"
#include "shown.h"
#include "window.h"

namespace ostraka::app {
namespace {

namespace fs = std::filesystem;

enum class State { Good, Slow, Missing };

struct Finding {
  State state = State::Good;
  std::string subject;  ///< "memory"
  std::string words;    ///< what is there, and what to do
};

std::string gigabytes(double bytes) {
  return fixed(bytes / 1e9, 1) + " GB";
}

Finding processors() {
  const int threads = availableThreads();
  std::ifstream info("/proc/cpuinfo");
  std::string line, model;
  bool avx2 = false;
  while (std::getline(info, line)) {
    if (line.starts_with("model name") && model.empty())
      model = line.substr(std::min(line.size(), line.find(':') + 2));
    if (line.starts_with("flags")) avx2 = avx2 || line.find(" avx2") != std::string::npos;
  }
  const std::string words = std::to_string(threads) + " (" + model + ")";
  if (threads < 2) return {State::Slow, "processors", words + "; two compute twice as fast"};
  if (!avx2) return {State::Slow, "processors", words + " without AVX2: stereo takes longer"};
  return {State::Good, "processors", words};
}

Finding memory() {
  std::ifstream info("/proc/meminfo");
  double total = 0, available = 0;
  for (std::string key, unit; info >> key;) {
    double value = 0;
    info >> value;
    std::getline(info, unit);
    if (key == "MemTotal:") total = value * 1024;
    if (key == "MemAvailable:") available = value * 1024;
  }
  const std::string words = gigabytes(total) + ", " + gigabytes(available) + " free";
  if (total < 3.5e9)
    return {State::Slow, "memory", words + "; 4 GB are wanted for photographs of 24 megapixels"};
  if (available < 1.5e9) return {State::Slow, "memory", words + "; close other programs"};
  return {State::Good, "memory", words};
}

// Megabytes a second with everything on the disk, as photographs are written; below 0: refused.
double writingSpeed(const fs::path& folder) {
  std::string pattern = (folder / ".ostraka_doctor_XXXXXX").string();
  const int file = ::mkstemp(pattern.data());
  if (file < 0) return -1;
  const std::vector<char> block(std::size_t{1} << 20, 'o');
  constexpr int kBlocks = 24;
  const auto begin = std::chrono::steady_clock::now();
  bool whole = true;
  for (int i = 0; i < kBlocks && whole; ++i)
    whole = ::write(file, block.data(), block.size()) == static_cast<ssize_t>(block.size());
  whole = ::fsync(file) == 0 && whole;
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  ::close(file);
  ::unlink(pattern.c_str());
  return whole ? kBlocks / seconds : -1;
}

Finding disk(const fs::path& folder) {
  std::error_code error;
  const fs::space_info space = fs::space(folder, error);
  if (error) return {State::Missing, "disk", folder.string() + ": " + error.message()};
  const double speed = writingSpeed(folder);
  const std::string words = folder.string() + ": " +
                            gigabytes(static_cast<double>(space.available)) + " free" +
                            (speed < 0 ? "" : ", writes " + fixed(speed, 0) + " MB a second");
  if (speed < 0) return {State::Missing, "disk", words + "; nothing can be written there"};
  if (static_cast<double>(space.available) < 5e9)
    return {State::Missing, "disk", words + "; a batch takes about 1 GB: free some space"};
  if (speed < 20) return {State::Slow, "disk", words + "; that is slow for photographs"};
  return {State::Good, "disk", words};
}

Finding program(const std::string& name, const std::string& use) {
  const auto found = colmap::findProgram(name);
  if (found) return {State::Good, name, found->string()};
  return {State::Good, name, "not installed; it is optional: " + use};
}

Finding openGl() {
  std::optional<bool> works;
  const std::string words = openGlWords(works);
  if (!works) return {State::Good, "OpenGL", words};
  if (!*works) return {State::Missing, "OpenGL", words + ". The window works, without 3D views"};
  if (words.find("llvmpipe") != std::string::npos)
    return {State::Slow, "OpenGL", words + "; drawn by the processor: turning is less smooth"};
  return {State::Good, "OpenGL", words};
}

bool usable(const fs::path& device) {
  return ::access(device.c_str(), R_OK | W_OK) == 0;
}

// Devices of a kind: which there are, and which may not be used.
Finding devices(const std::string& subject, const fs::path& folder,
                const std::vector<std::string>& beginnings, const std::string& repair) {
  int there = 0;
  std::string refused;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (std::ranges::none_of(beginnings, [&](const std::string& b) { return name.starts_with(b); }))
      continue;
    ++there;
    if (!usable(at->path())) refused += " " + at->path().string();
  }
  if (there == 0) return {State::Good, subject, "none is plugged in"};
  if (!refused.empty())
    return {State::Missing, subject, "no permission for" + refused + "; " + repair};
  return {State::Good, subject, std::to_string(there) + " found, all may be used"};
}

bool isRunning(const std::string& program) {
  std::error_code error;
  for (fs::directory_iterator at("/proc", error), end; !error && at != end; at.increment(error)) {
    std::ifstream name(at->path() / "comm");
    std::string running;
    // The kernel keeps fifteen letters of a name.
    if (std::getline(name, running) && running == program.substr(0, 15)) return true;
  }
  return false;
}

std::vector<Finding> examine(const fs::path& folder) {
  std::vector<Finding> findings{processors(), memory(), disk(folder), openGl()};
  findings.push_back(program("colmap", "poses of photographs without a marker plate"));
  findings.push_back(program("DensifyPointCloud", "OpenMVS as another stereo"));
  findings.push_back(devices("turntables (serial)", "/dev", {"ttyUSB", "ttyACM"},
                             "add yourself to the group 'dialout' and log in again"));
  findings.push_back(devices("cameras (video)", "/dev", {"video"},
                             "add yourself to the group 'video' and log in again"));
  if (isRunning("gvfs-gphoto2-volume-monitor"))
    findings.push_back({State::Slow, "gvfs",
                        "the desktop takes cameras for itself; 'systemctl --user stop "
                        "gvfs-gphoto2-volume-monitor' lets them go"});
  if (isRunning("ModemManager"))
    findings.push_back({State::Slow, "ModemManager",
                        "it talks to turntables as if they were modems for ten seconds after they "
                        "are plugged in; the udev rules of the package prevent that"});
  return findings;
}

int runDoctor(const fs::path& folder, Session& session) {
  const std::vector<Finding> findings = examine(folder);
  const bool missing = std::ranges::any_of(
      findings, [](const Finding& finding) { return finding.state == State::Missing; });
  const auto name = [](State state) {
    return state == State::Good ? "good" : state == State::Slow ? "slow" : "missing";
  };
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Finding& finding : findings)
    list.push_back(
        {{"verdict", name(finding.state)}, {"subject", finding.subject}, {"words", finding.words}});
  return finish(session, missing ? NotWhole : Whole, {{"findings", list}}, [&] {
    for (const Finding& finding : findings)
      show(stdout, "%-8s %s: %s.\n", name(finding.state), finding.subject.c_str(),
           finding.words.c_str());
  });
}

}  // namespace

void addDoctor(CLI::App& root, Command& chosen) {
  CLI::App* command =
      root.add_subcommand("doctor", "Say what is missing or slow on this computer, in words");
  auto folder = std::make_shared<std::string>(".");
  command->add_option("FOLDER", *folder, "Where projects are kept: its disk is looked at")
      ->check(CLI::ExistingDirectory)
      ->capture_default_str();
  workOf(*command, chosen, runDoctor, folder);
}

}  // namespace ostraka::app
