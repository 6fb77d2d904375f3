// Rim diameters of virtual sherds against the truth: RESULTS.md, 'Rims'.
// rim_accuracy FIRST_SEED COUNT NOISE_MM [rim|wall] prints a line per sherd and the summary over
// those that keep at least a tenth of the rim.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "drawing/rim.h"
#include "tests/core/drawing/true_rim.h"

int main(int argc, char** argv) {
  using namespace ostraka;
  if (argc < 4) {
    std::fprintf(stderr, "usage: rim_accuracy FIRST_SEED COUNT NOISE_MM [rim|wall]\n");
    return 2;
  }
  const auto first = std::strtoull(argv[1], nullptr, 10);
  const int count = std::atoi(argv[2]);
  const double noise = std::atof(argv[3]);
  const bool wall = argc > 4 && std::strcmp(argv[4], "wall") == 0;
  std::vector<double> errors;
  int inside = 0, missed = 0, stated = 0, stated_inside = 0, stated_of_all = 0;
  for (int i = 0; i < count; ++i) {
    const auto truth = drawing::trueSherd(wall ? vessels::SherdPart::Wall : vessels::SherdPart::Rim,
                                          first + i, noise);
    const drawing::Walls walls = drawing::findWalls(truth.sherd.mesh);
    const auto rim = drawing::findRim(walls);
    std::printf("%llu %-10s kept %4.1f %% true %6.1f ", first + i, truth.sherd.kind.c_str(),
                100 * truth.kept, truth.diameter_mm);
    if (rim)
      std::printf(
          "found %6.1f (%.1f-%.1f) kept %4.1f off %.3f lip %.3f smoother %.2f arc %.1f p %.2f",
          rim->diameter_mm, rim->low_mm, rim->high_mm, 100 * rim->kept, rim->residual_mm,
          rim->lip_scatter_mm, rim->smoother, rim->arc_mm, rim->probability);
    const bool counts = truth.kept >= 0.1;
    const bool states = rim && rim->saysDiameter();
    std::printf("%s%s\n", states ? " stated" : "", counts ? " *" : "");
    stated_of_all += states ? 1 : 0;
    if (!counts) continue;
    missed += rim ? 0 : 1;
    errors.push_back(rim ? std::abs(rim->diameter_mm / truth.diameter_mm - 1) : 1);
    const bool within =
        rim && rim->low_mm <= truth.diameter_mm && truth.diameter_mm <= rim->high_mm;
    inside += within ? 1 : 0;
    stated += states ? 1 : 0;
    stated_inside += states && within ? 1 : 0;
  }
  if (errors.empty()) return 0;
  std::sort(errors.begin(), errors.end());
  std::printf(
      "%zu sherds with a tenth or more: median error %.2f %%, 90 %% %.2f %%, worst %.2f %%, "
      "truth inside the interval %d (%.0f %%), not found %d; diameter stated of %d, %d of these "
      "inside; stated of all sherds %d of %d\n",
      errors.size(), 100 * errors[errors.size() / 2], 100 * errors[errors.size() * 9 / 10],
      100 * errors.back(), inside, 100.0 * inside / static_cast<double>(errors.size()), missed,
      stated, stated_inside, stated_of_all, count);
  return 0;
}
