#include "decisions/mask_strokes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>
#include <set>
#include <tuple>

#include "base/limits.h"
#include "base/message.h"
#include "batch/moved_batch.h"
#include "batch/peoples_files.h"
#include "files/files.h"
#include "files/json.h"
#include "files/json_numbers.h"
#include "files/json_text.h"
#include "rig/camera.h"

namespace ostraka::decisions {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* kFormatName = "ostraka-mask-strokes/1";
constexpr double kMostRadius_px = 4000, kMostPlace_px = 1e5;

fs::path strokesFile(const fs::path& output) {
  return output / batch::kMaskStrokesFile;
}

ordered_json strokeJson(const MaskStroke& s) {
  ordered_json path = ordered_json::array();
  for (const Eigen::Vector2d& p : s.path_px) path.push_back({p.x(), p.y()});
  ordered_json value = {{"side", batch::name(s.side)},
                        {"camera", s.camera},
                        {"stop", s.stop},
                        {"paint", s.paint == MaskPaint::Sherd ? "sherd" : "plate"},
                        {"radius_px", s.radius_px},
                        {"path_px", path},
                        {"by", s.by},
                        {"at", s.at},
                        {"photograph", s.photograph}};
  return value;
}

bool isUsable(const MaskStroke& s) {
  const auto near = [](double v) { return std::isfinite(v) && std::abs(v) <= kMostPlace_px; };
  return s.radius_px > 0 && s.radius_px <= kMostRadius_px && !s.path_px.empty() &&
         std::all_of(s.path_px.begin(), s.path_px.end(),
                     [&](const Eigen::Vector2d& p) { return near(p.x()) && near(p.y()); });
}

bool areTooMany(const std::vector<MaskStroke>& strokes) {
  struct Sum {
    std::uint64_t strokes = 0, points = 0;
  };
  std::map<std::tuple<batch::Side, int, int, std::string>, Sum> of_photographs;
  return std::any_of(strokes.begin(), strokes.end(), [&](const MaskStroke& s) {
    Sum& sum = of_photographs[{s.side, s.camera, s.stop, s.photograph}];
    sum.points += s.path_px.size();
    return ++sum.strokes > limits::kMaskStrokes.most || sum.points > limits::kMaskPoints.most;
  });
}

std::string keyOf(const PaintedPhotograph& photograph) {
  return photograph.name() + " " + photograph.sha256;
}

MaskStroke strokeFrom(const json& value) {
  MaskStroke s;
  s.side = value.at("side").get<std::string>() == "back" ? batch::Side::Back : batch::Side::Front;
  s.camera = wholeAt(value, "camera");
  s.stop = wholeAt(value, "stop");
  s.paint = value.at("paint").get<std::string>() == "sherd" ? MaskPaint::Sherd : MaskPaint::Plate;
  s.radius_px = numberAt(value, "radius_px");
  for (const json& p : value.at("path_px"))
    s.path_px.emplace_back(numberIn(p.at(0), "path_px"), numberIn(p.at(1), "path_px"));
  s.by = value.value("by", "");
  s.at = value.value("at", "");
  s.photograph = value.at("photograph").get<std::string>();
  return s;
}

}  // namespace

Result<std::vector<MaskStroke>> readMaskStrokes(const fs::path& output) {
  const fs::path file = strokesFile(output);
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return std::vector<MaskStroke>{};
  const Result<std::string> text = readFile(file, limits::kJsonBytes.most);
  if (!text) return text.error();
  return parseMaskStrokes(*text, file.string());
}

Result<std::vector<MaskStroke>> parseMaskStrokes(std::string_view text, const std::string& where) {
  std::vector<MaskStroke> strokes;
  const Result<json> value = parseJson(text, where);
  if (!value) return value.error();
  const Error bad = Error::unusable(
      message("Not a list of mask strokes; restore an earlier one, or delete it."), where);
  try {
    if (value->at("format") != kFormatName) return bad;
    for (const json& one : value->at("strokes")) {
      strokes.push_back(strokeFrom(one));
      if (!isUsable(strokes.back())) return bad;
    }
  } catch (const json::exception& refused) {
    return unusableJson(refused, bad.what, bad.where);
  }
  if (areTooMany(strokes)) return bad;
  return strokes;
}

ordered_json toJson(const std::vector<MaskStroke>& strokes) {
  ordered_json list = ordered_json::array();
  for (const MaskStroke& stroke : strokes) list.push_back(strokeJson(stroke));
  return list;
}

std::string textOf(const std::vector<MaskStroke>& strokes) {
  return jsonText({{"format", kFormatName}, {"strokes", toJson(strokes)}});
}

StrokesOn strokesOn(const std::vector<MaskStroke>& strokes, batch::Side side, int camera, int stop,
                    const std::string& photograph_sha256) {
  StrokesOn on;
  for (const MaskStroke& s : strokes) {
    if (s.side != side || s.camera != camera || s.stop != stop) continue;
    if (s.photograph == photograph_sha256)
      on.holding.push_back(s);
    else
      on.taken_again = true;
  }
  return on;
}

std::string PaintedPhotograph::name() const {
  return batch::name(side) + ("/cam" + std::to_string(camera)) + (stop < 10 ? "_pos0" : "_pos") +
         std::to_string(stop);
}

PaintedPhotograph paintedOn(const MaskStroke& stroke) {
  return {stroke.side, stroke.stop, stroke.camera, stroke.photograph};
}

std::map<PaintedPhotograph, std::vector<MaskStroke>> byPhotograph(
    const std::vector<MaskStroke>& strokes) {
  std::map<PaintedPhotograph, std::vector<MaskStroke>> photographs;
  for (const MaskStroke& s : strokes) photographs[paintedOn(s)].push_back(s);
  return photographs;
}

bool goesOn(const std::vector<MaskStroke>& list, const std::vector<MaskStroke>& other) {
  return list.size() >= other.size() && std::equal(other.begin(), other.end(), list.begin());
}

std::string hashOf(const std::vector<MaskStroke>& strokes) {
  return sha256(toJson(strokes).dump());
}

std::string knownText(const std::vector<MaskStroke>& strokes) {
  json known = json::object();
  for (const auto& [photograph, list] : byPhotograph(strokes))
    known[keyOf(photograph)] = {list.size(), hashOf(list)};
  return known.dump();
}

bool haveKnown(const std::vector<MaskStroke>& strokes, const std::string& known) {
  std::map<std::string, std::vector<MaskStroke>> lists;
  for (auto& [photograph, list] : byPhotograph(strokes)) lists[keyOf(photograph)] = list;
  const json all = jsonOrDiscarded(known);
  for (const auto& [photograph, told] : all.items()) {
    if (!told.is_array() || told.size() != 2 || !told[0].is_number_unsigned()) continue;
    std::vector<MaskStroke>& list = lists[photograph];
    if (list.size() < told[0].get<std::size_t>()) return false;
    list.resize(told[0].get<std::size_t>());
    if (told[1] != hashOf(list)) return false;
  }
  return true;
}

std::vector<MaskStroke> commonStart(const std::vector<MaskStroke>& a,
                                    const std::vector<MaskStroke>& b) {
  std::vector<MaskStroke> common;
  auto of_b = byPhotograph(b);
  for (const auto& [photograph, list] : byPhotograph(a)) {
    const std::vector<MaskStroke>& other = of_b[photograph];
    common.insert(common.end(), list.begin(),
                  std::mismatch(list.begin(), list.end(), other.begin(), other.end()).first);
  }
  return common;
}

std::string photographHash(const fs::path& photograph) {
  const Result<std::string> bytes = readFile(photograph);
  return bytes ? sha256(*bytes) : std::string();
}

Result<void> writeMaskStrokes(const fs::path& output, const std::vector<MaskStroke>& strokes) {
  if (areTooMany(strokes))
    return Error::unusable(message("A mask holds at most 1,000 strokes and 100,000 points; nothing "
                                   "is saved until you undo "
                                   "some."),
                           strokesFile(output).string());
  return writeFileAtomically(strokesFile(output), textOf(strokes));
}

bool masksWantComputing(const fs::path& output) {
  const Result<std::vector<MaskStroke>> strokes = readMaskStrokes(output);
  const Result<json> report = readJson(output / "report.json");
  if (!strokes || !report) return false;
  std::multiset<std::string> now, followed;
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
    std::vector<MaskStroke> own = *strokes;
    std::erase_if(own, [&](const MaskStroke& s) { return s.side != side; });
    if (!own.empty()) now.insert(sha256(toJson(own).dump()));
  }
  for (const json& stage : report->value("stages", json::array()))
    if (stage.contains("figures") && stage["figures"].contains("strokes_sha256"))
      followed.insert(stage["figures"]["strokes_sha256"].get<std::string>());
  return now != followed;
}

void paintStroke(cv::Mat1b& mask, const MaskStroke& stroke) {
  if (!isUsable(stroke)) return;
  std::vector<cv::Point> path;
  for (const Eigen::Vector2d& p : stroke.path_px) path.emplace_back(cvRound(p.x()), cvRound(p.y()));
  const int radius = std::max(1, cvRound(stroke.radius_px));
  // Painted apart, where it reaches: its soft edge takes nothing from what is there.
  const cv::Rect reach = cv::boundingRect(path) + cv::Size(2 * radius + 4, 2 * radius + 4) -
                         cv::Point(radius + 2, radius + 2);
  const cv::Rect within = reach & cv::Rect({}, mask.size());
  if (within.empty()) return;
  for (cv::Point& p : path) p -= within.tl();
  cv::Mat1b painted(within.size(), 0);
  if (path.size() == 1)
    cv::circle(painted, path[0], radius, 255, cv::FILLED, cv::LINE_AA);
  else
    cv::polylines(painted, path, false, 255, 2 * radius, cv::LINE_AA);
  // As plain matrices: of two Mat1b std::max would be taken.
  const cv::Mat brush = painted, others = 255 - painted;
  cv::Mat whole = mask(within);
  if (stroke.paint == MaskPaint::Sherd)
    cv::max(whole, brush, whole);
  else
    cv::min(whole, others, whole);
}

Result<std::vector<MaskedPhotograph>> maskedPhotographs(const fs::path& output) {
  const fs::path work = output / "work";
  const Result<std::vector<rig::PosedImage>> images = rig::readCameras(work / "rig/cameras.json");
  if (!images) return images.error();
  std::vector<MaskedPhotograph> all;
  for (const rig::PosedImage& image : *images) {
    const fs::path mask =
        work / (std::string("masks_") + batch::name(image.side)) / maskName(image);
    std::error_code ignored;
    if (!fs::exists(mask, ignored)) continue;
    all.push_back(
        {image.side, image.camera, image.stop, batch::photographNow(image.file, output), mask});
  }
  if (all.empty())
    return Error::unusable(message("This batch has no masks yet; process it first."),
                           output.string());
  std::sort(all.begin(), all.end(), [](const MaskedPhotograph& a, const MaskedPhotograph& b) {
    return std::tuple(a.side, a.stop, a.camera) < std::tuple(b.side, b.stop, b.camera);
  });
  return all;
}

std::string maskFolder(const fs::path& output, batch::Side side) {
  const std::string edited = std::string("edited_") + batch::name(side);
  const Result<std::vector<MaskStroke>> strokes = readMaskStrokes(output);
  std::error_code ignored;
  const bool any = strokes && std::any_of(strokes->begin(), strokes->end(),
                                          [&](const MaskStroke& s) { return s.side == side; });
  return any && fs::exists(output / "work" / edited / "stage.json", ignored)
             ? edited
             : std::string("masks_") + batch::name(side);
}

bool hasMasks(const fs::path& output) {
  std::error_code ignored;
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back})
    if (fs::is_directory(output / "work" / maskFolder(output, side), ignored)) return true;
  return false;
}

}  // namespace ostraka::decisions
