#include "command.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "options.h"
#include "pairing/candidates.h"
#include "shown.h"

namespace ostraka::app {

ExitStatus statusOf(const Error& error) {
  const bool input = error.code == ErrorCode::UnusableInput || error.code == ErrorCode::NotEnough ||
                     error.code == ErrorCode::Damaged;
  return input ? UnusableInputStatus : NotWhole;
}

void addThreads(CLI::App& command, int& threads) {
  command
      .add_option("--threads", threads,
                  "Threads; 0 = all processors. The result does not depend on it")
      ->check(CLI::Range(0, 1024));
}

void addPairing(CLI::App& command, pairing::Method& pairing, registration::Method& registration,
                registration::Boundary& boundary) {
  addChoice(command, "--pairing", pairing,
            {{"default", pairing::Method::Default}, {"paper", pairing::Method::Paper}}, "default",
            "Pairing: default, or paper (Wang et al. 2023)");
  addChoice(command, "--registration", registration, registration::methodsByName(), "default",
            "Registration: default, or a method of another paper: bbicp (Bilateral Boundary "
            "ICP, Wang et al. 2023), trimmed (ICP, Chetverikov et al. 2002), gicp (Segal et "
            "al. 2009), fpfh-ransac (Rusu et al. 2009, Buch et al. 2013), 4pcs (Aiger et al. "
            "2008), k4pcs (keypoints, Theiler et al. 2014), super4pcs (Mellado et al. 2014), "
            "fgr (Zhou et al. 2016)");
  addChoice(command, "--boundary", boundary, registration::boundariesByName(), "strip",
            "What bbicp takes for the boundary of a scan: strip (the lower end of the fracture "
            "strip), or paper (distance to the masks and gaps between neighbours, Wang et al. "
            "2023; scans without masks: the gaps alone)");
}

void checkBoundary(registration::Method registration, registration::Boundary boundary) {
  if (boundary != registration::Boundary::Strip &&
      registration != registration::Method::BilateralBoundary)
    throw CLI::ValidationError("--boundary",
                               "needs --registration bbicp; no other method has a "
                               "boundary");
}

void printNames(const char* title, std::span<const std::string> names) {
  if (!names.empty())
    show(stdout, "%s: %s\n", title, shownName(joined(names, " ")).c_str());
}

void printJson(const nlohmann::ordered_json& value) {
  const auto replace = nlohmann::ordered_json::error_handler_t::replace;
  std::string text = value.dump(1, ' ', false, replace);
  // What shown() spells is no JSON; its own escapes are.
  if (shown(text) != text) text = value.dump(1, ' ', true, replace);
  std::puts(text.c_str());
}

int finish(const Session& session, int status, nlohmann::ordered_json result,
           const std::function<void()>& print) {
  session.finishProgress();
  result["exit_status"] = status;
  if (session.json)
    printJson(result);
  else
    print();
  return status;
}

int finish(const Session& session, int status, nlohmann::ordered_json result,
           const std::string& words) {
  return finish(session, status, std::move(result),
                [&words] { show(stdout, "%s\n", words.c_str()); });
}

static const char* wordsOf(WhenStopped stopped) {
  switch (stopped) {
    case WhenStopped::GoesOn:
      return "Cancelled. Complete stages are kept; run the same command to continue from there.";
    case WhenStopped::RemovedItsBatch:
      return "Cancelled. The incomplete batch was removed.";
    case WhenStopped::BeginsAnew:
      break;
  }
  return "Cancelled. Run the same command to start again.";
}

int fail(const Session& session, const Error& error, WhenStopped when_stopped) {
  const bool stopped = error.code == ErrorCode::Cancelled;
  std::string sentence = error.sentence().english();
  if (stopped && error.where.empty()) sentence = wordsOf(when_stopped);
  session.finishProgress();
  show(stderr, "ostraka: %s\n", sentence.c_str());
  if (session.json)
    printJson({{"error", sentence}, {"stopped", stopped}, {"exit_status", statusOf(error)}});
  return statusOf(error);
}

}  // namespace ostraka::app
