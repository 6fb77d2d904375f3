#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "base/text.h"
#include "batch/photograph.h"
#include "colour/munsell_proposals.h"
#include "files/files.h"
#include "images/jpeg_image.h"
#include "pairing/contour.h"
#include "pairing/turning_angles.h"
#include "paper/markup.h"
#include "paper/report_page.h"
#include "pipeline/report.h"
#include "registration/within.h"

namespace ostraka::pipeline {
namespace {

constexpr const char* kStyle = R"(
body{font:16px/1.45 system-ui,sans-serif;color:#1a1a1a;background:#fff;
  max-width:1180px;margin:24px auto;padding:0 16px}
h1{font-size:26px}h2{font-size:20px;margin-top:32px;border-bottom:2px solid #ddd}
table{border-collapse:collapse;font-variant-numeric:tabular-nums}
td,th{padding:4px 10px;border-bottom:1px solid #ddd;text-align:right}
td.words,th.words{text-align:left}img{max-width:100%;border:1px solid #ccc}
figure{margin:0}.sides{display:flex;gap:12px;flex-wrap:wrap}.sides figure{flex:1 1 480px}
.sherd{display:flex;gap:16px;flex-wrap:wrap;align-items:flex-start;
  margin:12px 0;padding:12px;border:1px solid #ddd}
.doubt{border-left:8px solid #b35900}.ask{color:#8a4300;font-weight:600}
figcaption{color:#555;font-size:14px}
)";

// Blue and red as the fractures in the paper; the dashes tell them apart without colours.
constexpr const char* kFrontStroke = "stroke=\"#0050c8\" stroke-width=\"1.5\"";
constexpr const char* kBackStroke =
    "stroke=\"#c81e1e\" stroke-width=\"1.5\" stroke-dasharray=\"5 3\"";

std::string picture(const std::string& bytes, const char* type, const std::string& words) {
  return "<img alt=\"" + markupText(words) + "\" src=\"data:image/" + type + ";base64," +
         base64(bytes) + "\">";
}

// The view from highest above: there the sherds hide each other least.
int highestView(const std::vector<rig::PosedImage>& images) {
  int best = -1;
  for (std::size_t i = 0; i < images.size(); ++i)
    if (best < 0 || images[i].centre().normalized().z() >
                        images[static_cast<std::size_t>(best)].centre().normalized().z() + 1e-3)
      best = static_cast<int>(i);
  return best;
}

void label(cv::Mat& photograph, const std::string& text, const cv::Point& at) {
  const double size = photograph.cols / 1000.0;
  const int thick = std::max(1, static_cast<int>(2 * size));
  cv::putText(photograph, text, at, cv::FONT_HERSHEY_SIMPLEX, size, {0, 0, 0}, 3 * thick,
              cv::LINE_AA);
  cv::putText(photograph, text, at, cv::FONT_HERSHEY_SIMPLEX, size, {255, 255, 255}, thick,
              cv::LINE_AA);
}

std::string sidePicture(const ReportInput& input, batch::Side side) {
  const std::vector<rig::PosedImage> images = input.poses->of(side);
  const int view = highestView(images);
  if (view < 0) return {};
  const rig::PosedImage& image = images[static_cast<std::size_t>(view)];
  Result<cv::Mat> photograph = batch::readPhotograph(image.file);
  if (!photograph) return "<p>" + markupText(photograph.error().sentence().english()) + "</p>";
  cv::Mat drawn =
      batch::reducedTo(*photograph, image.intrinsics.width, image.intrinsics.height).clone();
  const Masks& masks = side == batch::Side::Front ? *input.front_masks : *input.back_masks;
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(masks[static_cast<std::size_t>(view)] >= 128, outlines, cv::RETR_EXTERNAL,
                   cv::CHAIN_APPROX_NONE);
  cv::drawContours(drawn, outlines, -1, {80, 220, 255}, 2, cv::LINE_AA);
  for (const ReportSherd& sherd : input.sherds) {
    const PointCloud& cloud = (side == batch::Side::Front ? sherd.front : sherd.back)->cloud;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3f& p : cloud.points)
      mean += p.cast<double>() / static_cast<double>(cloud.size());
    const Eigen::Vector2d pixel = image.project(mean);
    label(drawn, sherd.number, {static_cast<int>(pixel.x()) - 12, static_cast<int>(pixel.y()) + 8});
  }
  const std::string words =
      std::string(batch::name(side)) + " side, " +
      (input.way == batch::Way::FreeCamera ? std::filesystem::path(image.file).filename().string()
                                           : "camera " + batch::cameraLetter(image.camera) +
                                                 ", position " + std::to_string(image.stop + 1));
  return "<figure>" + picture(images::encodedJpeg(drawn, {.quality = 85}), "jpeg", words) +
         "<figcaption>" + words + "</figcaption></figure>";
}

using Line = std::vector<Eigen::Vector2d>;

// Both outlines seen from above the front, mm; the back's through the registration.
Line outlineInFront(const scan::Scan& scan, const Eigen::Isometry3d& front_from_scan) {
  const Result<pairing::Contour> contour = pairing::traceContour(scan.cloud, scan.up);
  if (!contour) return {};
  const Eigen::Isometry3d scan_from_plane = contour->plane_from_scan.inverse();
  Line line;
  for (std::size_t i = 0; i < contour->points.size(); ++i) {
    const double height = i < contour->heights.size() ? contour->heights[i] : 0.0;
    const Eigen::Vector3d p =
        front_from_scan *
        (scan_from_plane * Eigen::Vector3d(contour->points[i].x(), contour->points[i].y(), height));
    line.push_back(p.head<2>());
  }
  return line;
}

std::string svgLine(const Line& line, const Eigen::Vector2d& low, double scale, double height,
                    const char* style, bool closed) {
  std::ostringstream path;
  path.setf(std::ios::fixed);
  path.precision(1);
  path << "<path fill=\"none\" " << style << " d=\"";
  for (std::size_t i = 0; i < line.size(); ++i)
    path << (i ? 'L' : 'M') << (line[i].x() - low.x()) * scale + 8 << ' '
         << height - 8 - (line[i].y() - low.y()) * scale;
  path << (closed ? "Z" : "") << "\"/>";
  return path.str();
}

std::string overlay(const Line& front, const Line& back) {
  if (front.empty() || back.empty()) return "<p>No outline.</p>";
  Eigen::Vector2d low = front[0], high = front[0];
  for (const Line* line : {&front, &back})
    for (const Eigen::Vector2d& p : *line) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const double scale = 284 / std::max(1.0, (high - low).maxCoeff());
  const std::string bar = fixed(10 * scale, 1);
  return "<figure><svg width=\"300\" height=\"320\" role=\"img\" aria-label=\"outlines "
         "overlaid\">" +
         svgLine(front, low, scale, 300, kFrontStroke, true) +
         svgLine(back, low, scale, 300, kBackStroke, true) + "<path d=\"M8 310h" + bar +
         "\" stroke=\"#000\" stroke-width=\"3\"/><text x=\"" + fixed(14 + 10 * scale, 1) +
         "\" y=\"315\" font-size=\"13\">10 mm</text></svg><figcaption>Outlines: front solid, back "
         "dashed</figcaption></figure>";
}

// Two curves over the share of the outline, in a frame with the quarters of a turn. radians.
std::string anglePlot(const std::vector<double>& front, const std::vector<double>& back) {
  constexpr double kLeft = 40, kWidth = 284, kBottom = 292, kHeight = 284;
  constexpr double kQuarter = std::numbers::pi / 2;
  const auto [front_low, front_high] = std::minmax_element(front.begin(), front.end());
  const auto [back_low, back_high] = std::minmax_element(back.begin(), back.end());
  const double low = kQuarter * std::floor(std::min(*front_low, *back_low) / kQuarter),
               high = kQuarter * std::ceil(std::max(*front_high, *back_high) / kQuarter);
  const double scale = kHeight / std::max(kQuarter, high - low);
  std::string svg = "<g font-size=\"11\" fill=\"#555\" stroke-width=\"1\">";
  for (double angle = low; angle < high + kQuarter / 2; angle += kQuarter) {
    const std::string y = fixed(kBottom - (angle - low) * scale, 1);
    svg += "<path d=\"M" + fixed(kLeft, 0) + " " + y + "h" + fixed(kWidth, 0) +
           "\" stroke=\"#ddd\"/><text text-anchor=\"end\" x=\"" + fixed(kLeft - 5, 0) + "\" y=\"" +
           y + "\" dy=\"4\">" + fixed(angle * 180 / std::numbers::pi, 0) + "&deg;</text>";
  }
  for (const int percent : {0, 50, 100})
    svg += "<text text-anchor=\"middle\" x=\"" + fixed(kLeft + percent * kWidth / 100, 0) +
           "\" y=\"" + fixed(kBottom + 18, 0) + "\">" + std::to_string(percent) + " %</text>";
  svg += "</g>";
  const auto curve = [&](const std::vector<double>& sums) {
    Line line;
    for (std::size_t i = 0; i < sums.size(); ++i)
      line.emplace_back(
          kLeft - 8 + static_cast<double>(i) * kWidth / static_cast<double>(sums.size()),
          (sums[i] - low) * scale);
    return line;
  };
  return svg + svgLine(curve(front), {0, 0}, 1, kBottom + 8, kFrontStroke, false) +
         svgLine(curve(back), {0, 0}, 1, kBottom + 8, kBackStroke, false);
}

// Accumulated turning angles of both outlines, the back's from its best start point.
std::string descriptors(const Line& front, Line back) {
  constexpr int kSamples = 200;
  if (front.empty() || back.empty()) return {};
  if (pairing::signedArea(back) < 0) std::reverse(back.begin(), back.end());
  const auto a = pairing::turningAngles(front, kSamples),
             b = pairing::turningAngles(back, kSamples);
  if (!a || !b) return {};
  const std::vector<double> costs = pairing::shiftCosts(*a, *b, pairing::Offset::None);
  const int shift = static_cast<int>(std::min_element(costs.begin(), costs.end()) - costs.begin());
  const std::vector<double> front_sums = pairing::accumulated(*a, 0),
                            back_sums = pairing::accumulated(*b, shift);
  return "<figure><svg width=\"350\" height=\"320\" role=\"img\" aria-label=\"turning angles\">" +
         anglePlot(front_sums, back_sums) +
         "</svg><figcaption>Accumulated turning angles along the outline, difference " +
         fixed(costs[static_cast<std::size_t>(shift)] * 180 / std::numbers::pi, 1) +
         "&deg;</figcaption></figure>";
}

std::string measureLine(const nlohmann::ordered_json& figures) {
  if (!figures.value("model", false)) return "<p class=\"ask\">No model.</p>";
  const nlohmann::ordered_json& m = figures.at("measures");
  const auto get = [&](const char* name, int digits) {
    return fixed(m.at(name).get<double>(), digits);
  };
  return "<p>Length " + get("length_mm", 1) + " mm, width " + get("width_mm", 1) +
         " mm, thickness " + get("thickness_min_mm", 1) + " to " + get("thickness_max_mm", 1) +
         " mm (mean " + get("thickness_mean_mm", 1) + "), area " + get("area_mm2", 0) +
         " mm&sup2;, volume " + get("volume_mm3", 0) +
         " mm&sup3;. Unseen by any camera: " + fixed(100 * figures.value("filled_share", 0.0), 1) +
         " % of the surface, orange in the picture.</p>";
}

std::string munsellLine(const nlohmann::ordered_json& figures) {
  if (!figures.contains("munsell")) return {};
  const auto proposals = colour::parseMunsellProposals(figures["munsell"].dump());
  const std::string words = proposals ? colour::englishOf(*proposals) : std::string();
  return words.empty() ? words : "<p>" + markupText(words) + "</p>";
}

std::string decidedWords(const DecidedPair& pair) {
  return "Decided by " + pair.decided_by + ", " + pair.decided_at.substr(0, 10) + ".";
}

std::string shareWords(double share) {
  return share > 0 && share < 0.01 ? "under 1 %" : std::to_string(wholePercent(share)) + " %";
}

std::string confidence(const DecidedPair& pair) {
  return pair.score ? shareWords(*pair.score) : "–";
}

std::string sherdSection(const ReportSherd& sherd) {
  const DecidedPair& pair = *sherd.pair;
  std::string html = "<section class=\"sherd" + std::string(pair.ambiguous ? " doubt" : "") +
                     "\"><div><h3>Sherd " + sherd.number + "</h3><p>" +
                     markupText(sherd.front->id) + " and " + markupText(sherd.back->id) +
                     (pair.score ? ", confidence " + confidence(pair) : "") + "</p>";
  if (pair.ambiguous) html += "<p class=\"ask\">Needs review: " + markupText(pair.reason) + "</p>";
  if (!pair.decided_by.empty()) html += "<p>" + markupText(decidedWords(pair)) + "</p>";
  html += measureLine(sherd.figures) + munsellLine(sherd.figures);
  if (const Result<std::string> preview = readFile(sherd.preview))
    html += picture(*preview, "png", "model of sherd " + sherd.number);
  const Line front = outlineInFront(*sherd.front, Eigen::Isometry3d::Identity()),
             back = outlineInFront(*sherd.back, pair.front_from_back);
  return html + "</div>" + overlay(front, back) + descriptors(front, back) + "</section>\n";
}

std::string pairTable(const ReportInput& input) {
  std::string html =
      "<table><tr><th>Sherd</th><th>Front</th><th>Back</th><th>Confidence</th><th>Lead over the "
      "next</"
      "th><th>Fractures apart mm</th><th>Fracture overlap</th><th>Uncertainty mm (95 %)</th><th "
      "class=\"words\">Remark</th></tr>";
  for (const ReportSherd& sherd : input.sherds) {
    const DecidedPair& p = *sherd.pair;
    html += "<tr><td>" + sherd.number + "</td><td>" + markupText(sherd.front->id) + "</td><td>" +
            markupText(sherd.back->id) + "</td><td>" + confidence(p) + "</td><td>" +
            (p.margin ? fixed(*p.margin, 2) : "–") + "</td><td>" +
            (p.fracturesCompared()
                 ? fixed(p.fracture_rms_mm, 3) + "</td><td>" + shareWords(p.fracture_overlap)
                 : std::string("–</td><td>–")) +
            "</td><td>" + fixed(registration::within95_mm(p.uncertainty_mm), 2) +
            "</td><td class=\"words\">" +
            (p.ambiguous ? "<span class=\"ask\">review</span> " : "") +
            markupText(p.decided_by.empty() ? p.reason : decidedWords(p)) + "</td></tr>";
  }
  html += "</table>";
  const auto lone = [&](const std::vector<std::string>& ids, const char* words) {
    if (ids.empty()) return;
    html += std::string("<p class=\"ask\">") + words;
    for (const std::string& id : ids) html += " " + markupText(id);
    html += "</p>";
  };
  lone(input.unpaired_front, "Fronts without a back:");
  lone(input.unpaired_back, "Backs without a front:");
  lone(input.reshoot, "To reshoot:");
  lone(input.set_aside, "Set aside:");
  return html;
}

std::string colourLines(const ReportInput& input) {
  std::string lines;
  for (const ReportStage& stage : input.stages) {
    const nlohmann::ordered_json& figures = stage.record.notes.figures;
    if (figures.contains("ciede2000_median"))
      lines +=
          "<p>Colours are corrected by the colour chart; its patches differ from their "
          "reference by " +
          fixed(figures["ciede2000_median"], 1) + " (median) and " +
          fixed(figures["ciede2000_95"], 1) + " (95 %), CIEDE2000.</p>";
    if (figures.contains("light_uncertainty"))
      lines += "<p>Textures are without the light that fell on the sherds, which is known to " +
               fixed(100 * figures["light_uncertainty"].get<double>(), 1) +
               " % (one standard deviation).</p>";
  }
  return lines;
}

std::string stageTable(const ReportInput& input) {
  std::string html =
      "<table><tr><th class=\"words\">Stage</th><th>Seconds</th><th>Peak memory MB</th></tr>";
  for (const ReportStage& stage : input.stages)
    html += "<tr><td class=\"words\">" + markupText(stage.name) + "</td><td>" +
            fixed(stage.record.seconds, 1) + "</td><td>" + fixed(stage.record.peak_memory_mb, 0) +
            "</td></tr>";
  return html + "</table>";
}

}  // namespace

std::string reportHtml(const ReportInput& input) {
  const auto doubtful = std::count_if(input.sherds.begin(), input.sherds.end(),
                                      [](const ReportSherd& s) { return s.pair->ambiguous; });
  std::string html =
      std::string(kReportHead) + "<title>Ostraka: " + markupText(input.batch_name) +
      "</title><style>" + kStyle + "</style><h1>Batch " + markupText(input.batch_name) +
      "</h1><p>" + std::to_string(input.sherds.size()) + " sherds, " +
      (doubtful == 0 ? std::string("all pairs certain.")
                     : "<span class=\"ask\">" + std::to_string(doubtful) + " to review.</span>") +
      "</p><p>" + markupText(input.scale.english()) + "</p>";
  for (const Message& doubt : input.scale_doubts)
    html += "<p class=\"ask\">Resolve this before you measure anything: " +
            markupText(doubt.english()) + "</p>";
  if (input.draft)
    html +=
        "<p class=\"ask\">This is a draft from downsampled photographs: its measurements are "
        "coarse. Reprocess the batch without --draft before you number or publish anything.</p>";
  if (!input.warnings.empty()) {
    html += "<h2>Warnings</h2><ul>";
    for (const Message& warning : input.warnings)
      html += "<li>" + markupText(warning.english()) + "</li>";
    html += "</ul>";
  }
  html += "<h2>The plate</h2><div class=\"sides\">" + sidePicture(input, batch::Side::Front) +
          sidePicture(input, batch::Side::Back) + "</div>";
  html += "<h2>Pairs</h2>" + pairTable(input) + "<h2>Sherds</h2>" + colourLines(input);
  for (const ReportSherd& sherd : input.sherds) html += sherdSection(sherd);
  return html + "<h2>Processing time</h2>" + stageTable(input) + "</html>\n";
}

}  // namespace ostraka::pipeline
