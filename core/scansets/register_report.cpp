#include "scansets/register_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "cloud/point_cloud.h"
#include "files/files.h"
#include "files/json.h"
#include "paper/markup.h"
#include "paper/report_page.h"
#include "registration/within.h"

namespace ostraka::scansets {
namespace {

using nlohmann::ordered_json;

/// Both sides' points in one picture, along two axes given in the front's frame.
std::string overlay(const PointCloud& front, const PointCloud& back, const Eigen::Vector3d& right,
                    const Eigen::Vector3d& upwards) {
  constexpr double kWidth = 260, kMargin = 6;  // pixels on screen
  Eigen::Vector2d low(1e30, 1e30), high(-1e30, -1e30);
  const auto flat = [&](const Eigen::Vector3f& p) {
    return Eigen::Vector2d(right.dot(p.cast<double>()), -upwards.dot(p.cast<double>()));
  };
  for (const PointCloud* cloud : {&front, &back}) {
    for (const Eigen::Vector3f& p : cloud->points) {
      low = low.cwiseMin(flat(p)), high = high.cwiseMax(flat(p));
    }
  }
  if (low.x() > high.x()) return {};  // no point, as of a slice through a gap
  const double scale = (kWidth - 2 * kMargin) / std::max(1e-9, (high - low).maxCoeff());
  const double height = (high.y() - low.y()) * scale + 2 * kMargin;
  std::string svg = "<svg width=\"" + fixed(kWidth, 0) + "\" height=\"" + fixed(height, 0) +
                    "\" role=\"img\" aria-label=\"front and back overlaid\">";
  for (const auto& [cloud, color] : {std::pair(&front, "#1b6ca8"), std::pair(&back, "#d1495b")}) {
    svg +=
        std::string("<path fill=\"none\" stroke-width=\"1.2\" stroke-linecap=\"round\" stroke=\"") +
        color + "\" d=\"";
    for (const Eigen::Vector3f& p : cloud->points) {
      const Eigen::Vector2d at = (flat(p) - low) * scale + Eigen::Vector2d(kMargin, kMargin);
      svg += "M" + fixed(at.x(), 1) + " " + fixed(at.y(), 1) + "h0";
    }
    svg += "\"/>";
  }
  return svg + "</svg>";
}

/// A slice of a millimetre around the middle, seen from the side: the wall and its two faces.
std::string pictures(const scan::Scan& front, const scan::Scan& back,
                     const decisions::SherdPair& pair, double mm) {
  PointCloud moved = back.cloud;
  for (Eigen::Vector3f& p : moved.points) p *= static_cast<float>(pair.registration.scale);
  moved = transformed(moved, pair.registration.front_from_back);
  const Eigen::Vector3d up = front.up.normalized(), right = up.unitOrthogonal();
  const Eigen::Vector3d ahead = up.cross(right);
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : front.cloud.points) middle += p.cast<double>();
  middle /= static_cast<double>(std::max<std::size_t>(1, front.cloud.size()));
  const auto slice = [&](const PointCloud& cloud) {
    std::vector<int> kept;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const double off = ahead.dot(cloud.points[i].cast<double>() - middle);
      if (std::abs(off) < 0.5 * mm) kept.push_back(static_cast<int>(i));
    }
    return subset(cloud, kept);
  };
  const auto sparse = [&](const PointCloud& cloud) { return thinned(cloud, mm); };
  return overlay(sparse(front.cloud), sparse(moved), right, ahead) +
         overlay(slice(front.cloud), slice(moved), right, up);
}

std::string listed(const std::vector<std::string>& words) {
  return words.empty() ? "none" : markupText(joined(words, ", "));
}

std::string html(const RegisterSummary& summary, const decisions::PairTable& table,
                 std::span<const scan::Scan> fronts, std::span<const scan::Scan> backs) {
  std::string page =
      std::string(kReportHead) +
      "<title>Ostraka: registered scans</title><style>body{font-family:sans-serif;margin:2em;"
      "color:#222}table{border-collapse:collapse}td,th{border-bottom:1px solid #ccc;padding:.4em "
      ".8em;text-align:left;vertical-align:top}.ask{background:#fff3cd}svg{margin-right:1em}"
      "</style><h1>Registered scans</h1>";
  page += "<p>" + std::to_string(summary.pairs.size()) + " pairs, " +
          std::to_string(summary.ambiguous()) +
          " to review. Fronts without a back: " + listed(summary.unpaired_front) +
          ". Backs without a front: " + listed(summary.unpaired_back) + ".</p>";
  for (const Message& warning : summary.warnings) {
    page += "<p class=\"ask\">" + markupText(warning.english()) + "</p>";
  }
  page +=
      "<p>Blue: front. Red: back. Left: seen from above; right: a 1 mm slice through the "
      "middle.</p><table><tr><th>Sherd</th><th>Front</th><th>Back</th><th>Confidence</"
      "th><th>Fracture RMS</th><th>Fracture overlap</th><th>Uncertainty (95 "
      "%)</th><th>Remark</th><th>Both sides</th></tr>";
  for (std::size_t i = 0; i < summary.pairs.size(); ++i) {
    const RegisterSummary::Pair& p = summary.pairs[i];
    const pairing::Decision& d = table.pairs[i].decision;
    std::string remark = p.ambiguous ? "Needs review: " + p.reason
                         : p.score   ? "Certain."
                                     : "Nearest outline.";
    for (const pairing::Alternative& a : d.alternatives) {
      remark += " Or " + fronts[static_cast<std::size_t>(a.front)].id + " with " +
                backs[static_cast<std::size_t>(a.back)].id + " (" + fixed(100 * a.score, 1) +
                " %).";
    }
    page += std::string("<tr") + (p.ambiguous ? " class=\"ask\"" : "") + "><td>" + p.number +
            "</td><td>" + markupText(p.front) + "</td><td>" + markupText(p.back) + "</td><td>" +
            (p.score ? fixed(100 * *p.score, 2) + " %" : "–") + "</td><td>" +
            (p.fracturesCompared() ? fixed(p.fracture_rms_mm, 3) + " mm</td><td>" +
                                         fixed(100 * p.fracture_overlap, 0) + " %</td><td>"
                                   : std::string("–</td><td>–</td><td>")) +
            fixed(registration::within95_mm(p.uncertainty_mm), 2) + " mm</td><td>" +
            markupText(remark) + "</td><td>" +
            pictures(fronts[static_cast<std::size_t>(d.front)],
                     backs[static_cast<std::size_t>(d.back)], table.pairs[i], summary.mm) +
            "</td></tr>";
  }
  return page + "</table></html>\n";
}

}  // namespace

ordered_json toJson(const RegisterSummary::Pair& pair) {
  const auto ofFractures = [&](double figure) {
    return pair.fracturesCompared() ? ordered_json(figure) : ordered_json();
  };
  return {{"number", pair.number},
          {"front", pair.front},
          {"back", pair.back},
          {"score", orNull(pair.score)},
          {"margin", orNull(pair.margin)},
          {"ambiguous", pair.ambiguous},
          {"reason", pair.reason},
          {"fracture_rms_mm", ofFractures(pair.fracture_rms_mm)},
          {"fracture_overlap", ofFractures(pair.fracture_overlap)},
          {"uncertainty_mm", pair.uncertainty_mm}};
}

Result<void> writeRegisterReport(const std::filesystem::path& output,
                                 const RegisterSummary& summary, const decisions::PairTable& table,
                                 std::span<const scan::Scan> fronts,
                                 std::span<const scan::Scan> backs,
                                 const std::string& inputs_hash) {
  const Result<void> wrote =
      writeFileAtomically(output / "report.html", html(summary, table, fronts, backs));
  if (!wrote) return wrote.error();
  ordered_json pairs = ordered_json::array();
  for (std::size_t i = 0; i < summary.pairs.size(); ++i) {
    pairs.push_back(toJson(summary.pairs[i]));
    pairs.back()["contour_rms_mm"] = table.pairs[i].contour_rms_mm;
  }
  return writeJson(output / "report.json", {{"command", "register"},
                                            {"inputs_hash", inputs_hash},
                                            {"pairs", pairs},
                                            {"unpaired_front", summary.unpaired_front},
                                            {"unpaired_back", summary.unpaired_back},
                                            {"candidates", table.candidates},
                                            {"unusable_scans", summary.unusable},
                                            {"warnings", summary.warnings},
                                            {"seconds", summary.seconds}});
}

}  // namespace ostraka::scansets
