#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>

#include "command.h"
#include "interrupt.h"
#include "terminal_progress.h"
#include "window.h"

namespace {

using namespace ostraka;

constexpr const char* kDescription =
    "Ostraka makes complete, measured 3D models of potsherds from photographs of both their sides.";
constexpr const char* kFooter =
    "Exit status: 0 the result is whole, 1 it is not (or was stopped; the same command goes on),\n"
    "2 the input cannot be used, 3 a person must decide (ambiguous pairs).";

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
                               "The memory does not suffice; close other programs, or use fewer "
                               "threads (--threads).",
                               {}});
  } catch (const std::exception& error) {
    return app::fail(session,
                     {ErrorCode::Failed,
                      "This is a defect of the program; please report it with OUT/log.txt (" +
                          std::string(error.what()) + ").",
                      {}});
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App root(kDescription, "ostraka");
  root.footer(kFooter);
  root.set_version_flag("--version", "ostraka 0.1.0");
  root.require_subcommand(0, 1);
  root.fallthrough();
  bool json = false, quiet = false, verbose = false;
  root.add_flag("--json", json, "Print the result as JSON on standard output");
  root.add_flag("--quiet", quiet, "Print no progress and no warnings");
  root.add_flag("--verbose", verbose, "Print every line of the log, not only warnings");
  std::string project;
  root.add_option("PROJECT", project, "Opens the window with this project; alone: the window")
      ->check(CLI::ExistingPath);
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
  app::addCompletion(root, chosen);
  app::addManPages(root, chosen);
  try {
    root.parse(argc, argv);
    if (chosen && !project.empty())
      throw CLI::ExtrasError(root.get_name(), {project + ": one argument too many"});
  } catch (const CLI::ParseError& error) {
    const int status = root.exit(error);
    return status == 0 ? app::Whole : app::UnusableInputStatus;
  }
  if (!chosen) return app::openWindow(argc, argv, project);
  return run(chosen, json, quiet, verbose);
}
