#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "command.h"
#include "options.h"
#include "registration/within.h"
#include "scansets/register_report.h"
#include "scansets/register_scans.h"
#include "shown.h"

namespace ostraka::app {
namespace {

using nlohmann::ordered_json;
using scansets::RegisterOptions;
using scansets::RegisterSummary;

ordered_json asJson(const RegisterSummary& summary) {
  ordered_json pairs = ordered_json::array();
  for (const RegisterSummary::Pair& p : summary.pairs) pairs.push_back(scansets::toJson(p));
  return {{"pairs", pairs},
          {"unpaired_front", summary.unpaired_front},
          {"unpaired_back", summary.unpaired_back},
          {"unusable", summary.unusable},
          {"warnings", summary.warnings},
          {"seconds", summary.seconds},
          {"pairs_file", summary.pairs_file.string()},
          {"whole", summary.whole()}};
}

void printTable(const RegisterSummary& summary) {
  show(stdout, "%-6s %-8s %-8s %7s %7s %15s %8s %12s\n", "sherd", "front", "back", "score",
       "margin", "fracture RMS mm", "overlap", "within mm");
  for (const RegisterSummary::Pair& p : summary.pairs)
    show(stdout, "%-6s %-8s %-8s %7s %7s %15s %8s %12.2f  %s%s\n",
         shownName(p.number).c_str(), shownName(p.front).c_str(), shownName(p.back).c_str(),
         p.score ? fixed(*p.score, 4).c_str() : "-",
         p.margin ? fixed(*p.margin, 4).c_str() : "-",
         p.fracturesCompared() ? fixed(p.fracture_rms_mm, 3).c_str() : "-",
         p.fracturesCompared() ? fixed(p.fracture_overlap, 2).c_str() : "-",
         registration::within95_mm(p.uncertainty_mm), p.ambiguous ? "AMBIGUOUS " : "",
         p.reason.c_str());
  printNames("Fronts without a back", summary.unpaired_front);
  printNames("Backs without a front", summary.unpaired_back);
  show(stdout, "%zu %s in %.1f s: %s\n", summary.pairs.size(),
       summary.pairs.size() == 1 ? "pair" : "pairs", summary.seconds, summary.pairs_file.c_str());
  if (summary.unusable > 0)
    show(stdout, "%d %s could not be used.\n", summary.unusable,
         summary.unusable == 1 ? "file" : "files");
  if (summary.ambiguous() > 0)
    show(stdout, summary.ambiguous() == 1 ? "%d pair needs review.\n" : "%d pairs need review.\n",
         summary.ambiguous());
}

int runRegister(const RegisterOptions& options, Session& session) {
  const Result<RegisterSummary> summary =
      scansets::registerScans(options, session.progress, session.stop);
  if (!summary) return fail(session, summary.error());
  const int status = summary->ambiguous() > 0 ? PersonMustDecide
                     : summary->whole()       ? Whole
                                              : NotWhole;
  return finish(session, status, asJson(*summary), [&] { printTable(*summary); });
}

}  // namespace

void addRegister(CLI::App& root, Command& chosen) {
  CLI::App* command = root.add_subcommand(
      "register", "Pair and register scans that are split already: one PLY per sherd and side");
  auto options = std::make_shared<RegisterOptions>();
  command->add_option("--front", options->front, "Folder of the front scans (*.ply, mm)")
      ->required();
  command->add_option("--back", options->back, "Folder of the back scans (*.ply, mm)")->required();
  command->add_option("--output,-o", options->output, "Folder for the result; made when absent")
      ->required();
  addChoice(*command, "--scale", options->scale,
            {{"fixed", pairing::Scale::Fixed}, {"free", pairing::Scale::Free}}, "fixed",
            "fixed: both sides are in mm; free: the sides' scales differ; bbicp then finds each "
            "pair's own on the way (Ying et al. 2009)");
  addPairing(*command, options->pairing, options->registration, options->boundary);
  addThreads(*command, options->threads);
  command->callback([options, &chosen] {
    checkBoundary(options->registration, options->boundary);
    chosen = [options](Session& session) { return runRegister(*options, session); };
  });
}

}  // namespace ostraka::app
