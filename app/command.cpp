#include "command.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace ostraka::app {

ExitStatus statusOf(const Error& error) {
  const bool input = error.code == ErrorCode::UnusableInput || error.code == ErrorCode::NotEnough;
  return input ? UnusableInputStatus : NotWhole;
}

void printJson(const nlohmann::ordered_json& value) {
  const auto replace = nlohmann::ordered_json::error_handler_t::replace;
  std::printf("%s\n", value.dump(1, ' ', false, replace).c_str());
}

int fail(const Session& session, const Error& error) {
  const bool stopped = error.code == ErrorCode::Cancelled;
  const std::string sentence =
      stopped
          ? "Stopped on request; what was whole is kept, and the same command goes on from there."
          : error.sentence();
  session.finishProgress();
  std::fprintf(stderr, "ostraka: %s\n", sentence.c_str());
  if (session.json)
    printJson({{"error", sentence}, {"stopped", stopped}, {"exit_status", statusOf(error)}});
  return statusOf(error);
}

}  // namespace ostraka::app
