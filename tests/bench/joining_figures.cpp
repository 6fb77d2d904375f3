// How far pairs lie off beside what is stated of them ("joined to within").
//   joining_figures DIAGRAM.svg (PAIRS.json EVALUATION.json)...
// PAIRS.json of `ostraka register` or `process`, EVALUATION.json of `ostraka evaluate --json` of
// the same folder. Prints what holds of sure and of flagged pairs, and draws each pair.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "files/files.h"
#include "files/json.h"
#include "registration/within.h"

namespace {

using namespace ostraka;

struct Pair {
  double stated_mm, true_mm;  // within which it lies, and where it is
  bool sure;
};

bool addPairs(const char* pairs_file, const char* evaluation_file, std::vector<Pair>& all) {
  const auto pairs = readJson(pairs_file), evaluation = readJson(evaluation_file);
  if (!pairs || !evaluation) return false;
  for (const auto& row : (*evaluation)["pairs"]["rows"])
    for (const auto& pair : (*pairs)["pairs"])
      if (row.contains("rms_mm") && pair["front"] == row["front"] && pair["back"] == row["back"])
        all.push_back({registration::within95_mm(pair["uncertainty_mm"]), row["rms_mm"],
                       !pair["ambiguous"].get<bool>()});
  return true;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const auto at = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  return values[std::clamp<std::size_t>(at, 1, values.size()) - 1];
}

void tell(const char* name, const std::vector<Pair>& pairs) {
  std::vector<double> share, off, stated;
  int within = 0;
  for (const Pair& p : pairs) {
    share.push_back(p.true_mm / p.stated_mm);
    off.push_back(p.true_mm);
    stated.push_back(p.stated_mm);
    within += p.true_mm <= p.stated_mm ? 1 : 0;
  }
  std::printf(
      "%-8s %4zu pairs: off %.3f mm in the median, %.3f at 95 %%, %.3f at most; within %.3f mm in "
      "the median; true / stated %.2f in the median, %.2f at 95 %%, %.2f at most; %d (%.1f %%) lie "
      "within\n",
      name, pairs.size(), quantile(off, 0.5), quantile(off, 0.95), quantile(off, 1),
      quantile(stated, 0.5), quantile(share, 0.5), quantile(share, 0.95), quantile(share, 1),
      within, 100.0 * within / std::max<double>(1, static_cast<double>(pairs.size())));
}

// Both axes logarithmic, from 0.01 to 3 mm.
constexpr double kLeast_mm = 0.01, kMost_mm = 3, kSide = 420, kEdge = 50;
double along(double mm) {
  return kSide * std::log(std::clamp(mm, kLeast_mm, kMost_mm) / kLeast_mm) /
         std::log(kMost_mm / kLeast_mm);
}

// Of a sixth of the pairs each, ordered by what is stated.
std::string quantileLine(std::vector<Pair> pairs, double share, const char* style) {
  constexpr std::size_t kParts = 6;
  std::sort(pairs.begin(), pairs.end(),
            [](const Pair& a, const Pair& b) { return a.stated_mm < b.stated_mm; });
  std::ostringstream line;
  line << "<polyline fill=\"none\" " << style << " points=\"";
  for (std::size_t k = 0; k < kParts; ++k) {
    std::vector<double> stated, off;
    for (std::size_t i = k * pairs.size() / kParts; i < (k + 1) * pairs.size() / kParts; ++i) {
      stated.push_back(pairs[i].stated_mm);
      off.push_back(pairs[i].true_mm);
    }
    line << kEdge + along(quantile(stated, 0.5)) << ',' << kSide - along(quantile(off, share))
         << ' ';
  }
  line << "\"/>\n";
  return line.str();
}

std::string diagram(const std::vector<Pair>& pairs) {
  std::ostringstream svg;
  svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"520\" height=\"490\" "
         "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"520\" height=\"490\" "
         "fill=\"white\"/>\n<g transform=\"translate(0,20)\">\n";
  for (const double mm : {0.01, 0.03, 0.1, 0.3, 1.0, 3.0}) {
    svg << "<path stroke=\"#ddd\" d=\"M" << kEdge + along(mm) << " 0V" << kSide << "M" << kEdge
        << ' ' << kSide - along(mm) << "h" << kSide << "\"/>\n<text text-anchor=\"middle\" x=\""
        << kEdge + along(mm) << "\" y=\"" << kSide + 16 << "\">" << mm
        << "</text>\n<text text-anchor=\"end\" x=\"" << kEdge - 6 << "\" y=\""
        << kSide - along(mm) + 4 << "\">" << mm << "</text>\n";
  }
  for (const Pair& p : pairs)
    svg << "<circle cx=\"" << kEdge + along(p.stated_mm) << "\" cy=\"" << kSide - along(p.true_mm)
        << "\" r=\"2.5\" fill=\"" << (p.sure ? "#1f5fa8" : "none") << "\" stroke=\""
        << (p.sure ? "none" : "#b8560b") << "\"/>\n";
  svg << "<path stroke=\"black\" d=\"M" << kEdge << ' ' << kSide << 'L' << kEdge + kSide
      << " 0\"/>\n"
      << quantileLine(pairs, 0.5, "stroke=\"#444\" stroke-dasharray=\"2 3\" stroke-width=\"2\"")
      << quantileLine(pairs, 0.95, "stroke=\"#444\" stroke-dasharray=\"8 3\" stroke-width=\"2\"")
      << "<text x=\"" << kEdge + 8 << "\" y=\"14\">off, mm</text>\n<text text-anchor=\"end\" x=\""
      << kEdge + kSide << "\" y=\"" << kSide + 34
      << "\">stated: within, mm; dots: filled = sure, rings = flagged; dotted 50 %, dashed 95 %"
         "</text>\n</g></svg>\n";
  return svg.str();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4 || argc % 2 != 0)
    return std::fprintf(stderr, "joining_figures DIAGRAM.svg (PAIRS.json EVALUATION.json)...\n"), 2;
  std::vector<Pair> all, sure, flagged;
  for (int i = 2; i + 1 < argc; i += 2)
    if (!addPairs(argv[i], argv[i + 1], all))
      return std::fprintf(stderr, "%s cannot be read.\n", argv[i]), 1;
  for (const Pair& p : all) (p.sure ? sure : flagged).push_back(p);
  tell("all", all);
  tell("sure", sure);
  tell("flagged", flagged);
  return writeFileAtomically(argv[1], diagram(all)) ? 0 : 1;
}
