#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>
#include <nlohmann/json.hpp>

#include "batch/photograph.h"
#include "command.h"
#include "help.h"
#include "interrupt.h"
#include "shown.h"
#include "terminal_progress.h"
#include "window.h"

namespace {

using namespace ostraka;

constexpr const char* kDescription =
    "Ostraka makes complete, measured 3D models of potsherds from photographs of both their sides.";

// What cannot be a command line gets one sentence, and with --json an object as any other error.
int refuse(const CLI::ParseError& error, const CLI::App& root, int argc, char** argv) {
  const std::string sentence = app::sentenceOf(error, root);
  app::show(stderr, "ostraka: %s\n", sentence.c_str());
  for (int i = 1; i < argc; ++i)
    if (std::strcmp(argv[i], "--json") == 0)
      app::printJson({{"error", sentence},
                      {"stopped", false},
                      {"exit_status", static_cast<int>(app::UnusableInputStatus)}});
  return app::UnusableInputStatus;
}

int run(const app::Command& chosen, bool json, bool quiet, bool verbose) {
  const auto loudness = quiet     ? app::Loudness::Quiet
                        : verbose ? app::Loudness::Everything
                                  : app::Loudness::Warnings;
  app::Interrupt interrupt;
  app::TerminalProgress progress(stderr, isatty(STDERR_FILENO) != 0, loudness);
  app::Session session{progress, interrupt.token(), json, [&] { progress.finish(); }};
  // The one place around a job where exceptions, which are bugs or a lack of memory, are caught.
  try {
    return chosen(session);
  } catch (const std::bad_alloc&) {
    return app::fail(session, {ErrorCode::Failed,
                               "Not enough memory; close other programs, or use fewer threads "
                               "(--threads).",
                               {}});
  } catch (const std::exception& error) {
    return app::fail(session,
                     {ErrorCode::Failed,
                      "This is a defect of the program; please report it with OUT/log.txt (" +
                          std::string(error.what()) + ").",
                      {}});
  }
}

int runCommandLine(int argc, char** argv) {
  CLI::App root(kDescription, "ostraka");
  root.formatter(app::plainHelp());
  root.set_version_flag("--version", "ostraka " OSTRAKA_VERSION);
  root.require_subcommand(0, 1);
  root.fallthrough();
  bool json = false, quiet = false, verbose = false;
  root.add_flag("--json", json, "Print the result as JSON on standard output");
  root.add_flag("--quiet", quiet, "Print no progress and no warnings");
  root.add_flag("--verbose", verbose, "Print every line of the log, not only warnings");
  std::string project;
  root.add_option("PROJECT", project, "Opens the window with this project; alone: the window");
  app::Command chosen;
  app::addProcess(root, chosen);
  app::addRegister(root, chosen);
  app::addDense(root, chosen);
  app::addEvaluate(root, chosen);
  app::addRig(root, chosen);
  app::addCapture(root, chosen);
  app::addDevices(root, chosen);
  app::addDoctor(root, chosen);
  app::addDraw(root, chosen);
  app::addPlate(root, chosen);
  app::addCatalogue(root, chosen);
  app::addCluster(root, chosen);
  app::addCompletion(root, chosen);
  app::addManPages(root, chosen);
  try {
    root.parse(argc, argv);
    // A word too many behind a command comes to the root, where it looks like a project.
    if (chosen && !project.empty()) throw CLI::ExtrasError(std::vector<std::string>{project});
    std::error_code failed;
    if (!project.empty() && !std::filesystem::exists(project, failed))
      throw CLI::ParseError("'" + project + "' is neither a command nor a project that is there",
                            CLI::ExitCodes::ValidationError);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return root.exit(error);  // --help, --version
    const std::vector<std::string>& extra = root.get_option("PROJECT")->results();
    if (!extra.empty() && !root.get_subcommands().empty())  // before what is missing
      return refuse(CLI::ExtrasError(extra), root, argc, argv);
    return refuse(error, root, argc, argv);
  }
  if (!chosen) return app::openWindow(project);
  return run(chosen, json, quiet, verbose);
}

}  // namespace

int main(int argc, char** argv) {
  batch::makeOpenCvThrowBadAlloc();
  std::signal(SIGXFSZ, SIG_IGN);  // a limit of file sizes is told as a full disk
  const int status = runCommandLine(argc, argv);
  // What was printed waits in a buffer up to here: a full disk shows only now.
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  app::show(stderr, "%s\n",
            "ostraka: The result could not be written to standard output and is incomplete there; "
            "free space at its destination and run the command again.");
  return app::NotWhole;
}
