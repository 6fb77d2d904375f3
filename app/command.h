#pragma once
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <stop_token>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "registration/register_sides.h"

namespace CLI {
class App;
}
namespace ostraka::drawing {
enum class Dpi;
enum class Surface;
}  // namespace ostraka::drawing
namespace ostraka::pairing {
enum class Method;
}

namespace ostraka::app {

/// What the shell gets to know: README, 'Exit status'.
enum ExitStatus { Whole = 0, NotWhole = 1, UnusableInputStatus = 2, PersonMustDecide = 3 };

ExitStatus statusOf(const Error& error);

/// What every sub-command is handed when it runs.
struct Session {
  Progress& progress;
  std::stop_token stop;
  bool json = false;                     ///< the result as JSON on standard output instead of words
  std::function<void()> finishProgress;  ///< ends the line of progress, before other output
};

/// The work of the sub-command that was chosen.
using Command = std::function<int(Session&)>;

/// Each adds its sub-command to the root; when it was chosen on the command line, `chosen` becomes
/// its work.
void addProcess(CLI::App& root, Command& chosen);
void addRegister(CLI::App& root, Command& chosen);
void addDense(CLI::App& root, Command& chosen);
void addEvaluate(CLI::App& root, Command& chosen);
void addRig(CLI::App& root, Command& chosen);
void addRigCalibrate(CLI::App& rig, Command& chosen);
void addRigPredict(CLI::App& rig, Command& chosen);
void addCapture(CLI::App& root, Command& chosen);
void addDevices(CLI::App& root, Command& chosen);
void addDoctor(CLI::App& root, Command& chosen);
void addDraw(CLI::App& root, Command& chosen);
void addPlate(CLI::App& root, Command& chosen);
void addCatalogue(CLI::App& root, Command& chosen);
void addCluster(CLI::App& root, Command& chosen);
void addCompletion(CLI::App& root, Command& chosen);
void addManPages(CLI::App& root, Command& chosen);

/// When the command is chosen on the command line, its work is to run with what was read.
void workOf(auto& command, Command& chosen, auto run, auto... arguments) {
  command.callback([&chosen, run, arguments...] {
    chosen = [run, arguments...](Session& session) { return run(*arguments..., session); };
  });
}

/// Options that several commands have.
void addThreads(CLI::App& command, int& threads);
void addSurface(CLI::App& command, drawing::Surface& surface, drawing::Dpi& dpi);
void addPairing(CLI::App& command, pairing::Method& pairing, registration::Method& registration,
                registration::Boundary& boundary);
/// Throws CLI::ValidationError where the boundary is chosen for a method that has none.
void checkBoundary(registration::Method registration, registration::Boundary boundary);

/// What the same command does after a person stopped it.
enum class WhenStopped { BeginsAnew, GoesOn, RemovedItsBatch };

/// Says what went wrong on standard error, with --json as an object on standard output, and gives
/// the exit status.
int fail(const Session& session, const Error& error,
         WhenStopped when_stopped = WhenStopped::BeginsAnew);

/// "title: a b c" on standard output; nothing where there are no names.
void printNames(const char* title, std::span<const std::string> names);

/// The result of a command: with --json an object that ends in its exit_status, else what `print`
/// prints, or the words with a line's end. Gives the status.
int finish(const Session& session, int status, nlohmann::ordered_json result,
           const std::function<void()>& print);
int finish(const Session& session, int status, nlohmann::ordered_json result,
           const std::string& words);

/// JSON to standard output, indented, with a line's end.
void printJson(const nlohmann::ordered_json& value);

}  // namespace ostraka::app
