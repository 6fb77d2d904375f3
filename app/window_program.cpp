// The window: ostraka-window [PROJECT]. `ostraka` becomes this program (window.h).
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include "batch/photograph.h"
#include "ui/main/run_window.h"
#include "window.h"

int main(int argc, char** argv) {
  using namespace ostraka;
  batch::makeOpenCvThrowBadAlloc();
  std::signal(SIGXFSZ, SIG_IGN);  // a limit of file sizes is told as a full disk
  const std::string argument = argc > 1 ? argv[1] : "";
  if (argument == app::kLookAtOpenGl) {
    std::optional<bool> works;
    const std::string words = ui::openGlOfThisComputer(works);
    std::printf("%s%s", !works ? "?" : *works ? "+" : "-", words.c_str());
    return 0;
  }
  std::optional<std::filesystem::path> project;
  if (!argument.empty()) project = argument;
  return ui::runWindow(argc, argv, project);
}
