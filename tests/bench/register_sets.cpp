// register_sets SCANS_DIR OUT_DIR THREADS SET...: what `ostraka register` does, set by set, with
// the seconds per pair. Judge with evaluate.py pairs.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "scansets/register_scans.h"

int main(int argc, char** argv) {
  if (argc < 5) return std::fprintf(stderr, "register_sets SCANS OUT THREADS SET...\n"), 2;
  const std::filesystem::path scans = argv[1], out = argv[2];
  for (int i = 4; i < argc; ++i) {
    ostraka::scansets::RegisterOptions options;
    options.front = scans / argv[i] / "front";
    options.back = scans / argv[i] / "back";
    options.output = out / argv[i];
    options.threads = std::atoi(argv[3]);
    ostraka::QuietProgress quiet;
    const auto summary = ostraka::scansets::registerScans(options, quiet, {});
    if (!summary)
      return std::fprintf(stderr, "%s\n", summary.error().sentence().english().c_str()), 1;
    std::printf("%-12s %2zu pairs, %d to decide, %zu + %zu alone, %.2f s, %.2f s a pair\n", argv[i],
                summary->pairs.size(), summary->ambiguous(), summary->unpaired_front.size(),
                summary->unpaired_back.size(), summary->seconds,
                summary->seconds / static_cast<double>(summary->pairs.size()));
    for (const auto& p : summary->pairs) {
      std::printf("  %s %s score %.4f margin %.4f fracture %.3f mm met %.2f uncertain %.3f %s\n",
                  p.front.c_str(), p.back.c_str(), p.score.value_or(0), p.margin.value_or(0),
                  p.fracture_rms_mm, p.fracture_overlap, p.uncertainty_mm, p.reason.c_str());
    }
  }
  return 0;
}
