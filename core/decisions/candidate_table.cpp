#include "decisions/candidate_table.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "base/message.h"
#include "files/json.h"
#include "files/json_numbers.h"

namespace ostraka::decisions {
namespace {

using batch::Side;
using nlohmann::json;
using nlohmann::ordered_json;
using registration::FailedCheck;

constexpr std::array<const char*, 8> kFailedChecks = {"",
                                                      "upside_down",
                                                      "faces_cross",
                                                      "no_shared_fracture",
                                                      "fracture_misfits",
                                                      "fracture_loose",
                                                      "rival_place",
                                                      "outlines_alone"};
constexpr std::array<const char*, 8> kDoubts = {"",          "self_check", "other_partner",
                                                "unrelated", "other_pose", "not_sure",
                                                "displaced", "shared_back"};
constexpr const char* kPaper = "paper";  // of the key "pairing"; absent: the default

FailedCheck failedCheckOf(const std::string& name) {
  for (std::size_t i = 0; i < kFailedChecks.size(); ++i)
    if (name == kFailedChecks[i]) return static_cast<FailedCheck>(i);
  return FailedCheck::None;
}

ordered_json scansJson(const std::vector<ScanRef>& scans, const std::vector<std::string>& files) {
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < scans.size(); ++i) {
    list.push_back({{"id", scans[i].id},
                    {"place_mm", {scans[i].place_mm.x(), scans[i].place_mm.y()}},
                    {"file", i < files.size() ? files[i] : ""}});
    if (!scans[i].photographs.empty()) list.back()["photographs"] = scans[i].photographs;
  }
  return list;
}

void readScans(const json& list, batch::Side side, std::vector<ScanRef>& scans,
               std::vector<std::string>& files) {
  for (const json& value : list) {
    const json& at = value.at("place_mm");
    scans.push_back({side, value.at("id").get<std::string>(),
                     Eigen::Vector2d(numberIn(at.at(0), "at"), numberIn(at.at(1), "at")),
                     value.value("photographs", "")});
    files.push_back(value.at("file").get<std::string>());
  }
}

ordered_json toJson(const RegisteredCandidate& c, const CandidateTable& table) {
  ordered_json starts = ordered_json::array();
  const bool paper = table.method == pairing::Method::Paper;
  const auto likelihood = [&](double value) {
    return paper ? ordered_json() : ordered_json(value);
  };
  for (const pairing::StartPose& start : c.starts)
    starts.push_back({{"shift", start.shift},
                      {"contour_rms_mm", start.contour_rms_mm},
                      {"log_likelihood", likelihood(start.log_likelihood)},
                      {"T_front_from_back", ostraka::toJson(start.front_from_back)}});
  const registration::Registration& r = c.registration;
  ordered_json value = {{"front", table.fronts[static_cast<std::size_t>(c.evidence.front)].id},
                        {"back", table.backs[static_cast<std::size_t>(c.evidence.back)].id},
                        {"log_likelihood", likelihood(c.evidence.log_likelihood)},
                        {"fracture_rms_mm", r.fracture_rms_mm},
                        {"fracture_overlap", r.fracture_overlap},
                        {"uncertainty_mm", r.uncertainty_mm},
                        {"runner_up_gap", r.runner_up_gap},
                        {"runner_up_mm", r.runner_up_mm},
                        {"crossing_share", r.crossing_share},
                        {"thickness_mm", r.thickness_mm},
                        {"scale", r.scale},
                        {"check_failed", r.check_failed},
                        {"failed_check", name(r.failed_check)},
                        {"reason", r.reason},
                        {"start", r.start},
                        {"T_front_from_back", ostraka::toJson(r.front_from_back)},
                        {"starts", starts}};
  if (paper) value["distance_rad"] = c.evidence.distance_rad;
  return value;
}

Result<RegisteredCandidate> candidateFrom(const json& value, const CandidateTable& table,
                                          const std::string& where) {
  RegisteredCandidate c;
  const bool paper = table.method == pairing::Method::Paper;
  registration::Registration& r = c.registration;
  r.fracture_rms_mm = numberAt(value, "fracture_rms_mm");
  r.fracture_overlap = numberAt(value, "fracture_overlap");
  r.uncertainty_mm = numberAt(value, "uncertainty_mm");
  r.runner_up_gap = numberAt(value, "runner_up_gap");
  r.runner_up_mm = numberAt(value, "runner_up_mm");
  r.crossing_share = numberAt(value, "crossing_share");
  r.thickness_mm = numberAt(value, "thickness_mm");
  r.scale = numberAt(value, "scale");
  r.check_failed = value.at("check_failed").get<bool>();
  r.failed_check = failedCheckOf(value.at("failed_check").get<std::string>());
  r.reason = value.at("reason").get<std::string>();
  r.start = wholeAt(value, "start");
  const Result<Eigen::Isometry3d> pose = isometryFromJson(value.at("T_front_from_back"), where);
  if (!pose) return pose.error();
  r.front_from_back = *pose;
  for (const json& entry : value.at("starts")) {
    pairing::StartPose start;
    start.shift = wholeAt(entry, "shift");
    start.contour_rms_mm = numberAt(entry, "contour_rms_mm");
    if (!paper) start.log_likelihood = numberAt(entry, "log_likelihood");
    const Result<Eigen::Isometry3d> begin = isometryFromJson(entry.at("T_front_from_back"), where);
    if (!begin) return begin.error();
    start.front_from_back = *begin;
    c.starts.push_back(start);
  }
  c.evidence.front = indexOf(table.fronts, value.at("front").get<std::string>());
  c.evidence.back = indexOf(table.backs, value.at("back").get<std::string>());
  if (c.evidence.front < 0 || c.evidence.back < 0 || c.starts.empty())
    return Error::unusable(message("A candidate refers to a scan that does not exist."), where);
  if (paper) c.evidence.distance_rad = numberAt(value, "distance_rad", 0);
  if (!paper) c.evidence.log_likelihood = numberAt(value, "log_likelihood");
  c.evidence.fracture_rms_mm = r.fracture_rms_mm;
  c.evidence.overlap = r.fracture_overlap;
  c.evidence.check_failed = r.check_failed;
  c.evidence.runner_up_start_log_likelihood = c.evidence.log_likelihood - r.runner_up_gap;
  return c;
}

// What cannot be read is shown as it was decided.
void readDecided(const std::filesystem::path& pairs_file, CandidateTable& table) {
  const Result<nlohmann::json> pairs = readJson(pairs_file);
  if (!pairs || !pairs->is_object()) return;
  try {
    for (const nlohmann::json& pair : pairs->value("pairs", nlohmann::json::array())) {
      if (!pair.contains("decided")) continue;
      RegisteredDecision done;
      done.front = indexOf(table.fronts, pair.at("front").get<std::string>());
      done.back = indexOf(table.backs, pair.at("back").get<std::string>());
      done.id = pair.at("decided").at("id").get<std::string>();
      const auto pose = isometryFromJson(pair.at("T_front_from_back"), pairs_file.string());
      if (done.front < 0 || done.back < 0 || !pose) continue;
      done.registration.front_from_back = *pose;
      done.registration.start = 0;
      if (pair.at("fracture_rms_mm").is_number())
        done.registration.fracture_rms_mm = numberAt(pair, "fracture_rms_mm");
      done.registration.fracture_overlap = numberAt(pair, "fracture_overlap");
      done.registration.uncertainty_mm = numberAt(pair, "uncertainty_mm");
      done.registration.check_failed = pair.at("check_failed").get<bool>();
      table.decided.push_back(std::move(done));
    }
  } catch (const nlohmann::json::exception&) {
    table.decided.clear();
  }
}

}  // namespace

int indexOf(const std::vector<ScanRef>& scans, const std::string& id) {
  for (std::size_t i = 0; i < scans.size(); ++i)
    if (scans[i].id == id) return static_cast<int>(i);
  return -1;
}

const pairing::StartPose& RegisteredCandidate::start() const {
  const std::size_t i = static_cast<std::size_t>(std::max(0, registration.start));
  return starts.at(std::min(i, starts.size() - 1));
}

const RegisteredCandidate* CandidateTable::find(int front, int back) const {
  for (const RegisteredCandidate& c : candidates)
    if (c.evidence.front == front && c.evidence.back == back) return &c;
  return nullptr;
}

ScanRef refOf(const scan::Scan& scan, batch::Side side) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3f& p : scan.cloud.points) sum += p.head<2>().cast<double>();
  return {side, scan.id, sum / std::max<double>(1.0, static_cast<double>(scan.cloud.size())), {}};
}

std::string sherdNumber(const std::string& front_id) {
  const std::size_t digits = front_id.find_first_of("123456789");
  const std::string number = digits == std::string::npos ? "0" : front_id.substr(digits);
  return number.size() < 2 ? "0" + number : number;
}

namespace {

// {"front": a bend or null, "back"}
ordered_json supportsJson(const std::array<rig::Support, 2>& supports) {
  ordered_json value;
  for (const Side side : {Side::Front, Side::Back}) {
    const rig::Support& own = supports[static_cast<std::size_t>(side)];
    value[batch::name(side)] = own ? rig::toJson(*own) : ordered_json();
  }
  return value;
}

std::optional<std::array<rig::Support, 2>> supportsFrom(const json& value) {
  std::array<rig::Support, 2> supports;
  for (const Side side : {Side::Front, Side::Back}) {
    const json& own = value.at(batch::name(side));
    rig::Support& support = supports[static_cast<std::size_t>(side)];
    if (!own.is_null() && !(support = rig::sheetBendFrom(own))) return std::nullopt;
  }
  return supports;
}

Error notATable(const std::filesystem::path& file) {
  return Error::unusable(
      message("Not a candidate table; reprocess the batch, which redoes only its pairs."), file);
}

}  // namespace

ordered_json toJson(const CandidateTable& table) {
  ordered_json candidates = ordered_json::array();
  for (const RegisteredCandidate& c : table.candidates) candidates.push_back(toJson(c, table));
  ordered_json value = {{"unit", "mm"},
                        {"fronts", scansJson(table.fronts, table.front_files)},
                        {"backs", scansJson(table.backs, table.back_files)},
                        {"back_scale", table.back_scale},
                        {"has_scale", table.has_scale},
                        {"supports", supportsJson(table.supports)},
                        {"candidates", candidates}};
  if (table.method == pairing::Method::Paper) value["pairing"] = kPaper;
  return value;
}

Result<CandidateTable> readCandidates(const std::filesystem::path& file) {
  const Result<json> text = readJson(file);
  if (!text) return text.error();
  CandidateTable table;
  try {
    readScans(text->at("fronts"), batch::Side::Front, table.fronts, table.front_files);
    readScans(text->at("backs"), batch::Side::Back, table.backs, table.back_files);
    if (text->value("pairing", "") == kPaper) table.method = pairing::Method::Paper;
    table.back_scale = numberAt(*text, "back_scale");
    table.has_scale = text->at("has_scale").get<bool>();
    const auto supports = supportsFrom(text->at("supports"));
    if (!supports) return notATable(file);
    table.supports = *supports;
    for (const json& value : text->at("candidates")) {
      Result<RegisteredCandidate> candidate = candidateFrom(value, table, file.string());
      if (!candidate) return candidate.error();
      table.candidates.push_back(std::move(*candidate));
    }
  } catch (const json::exception&) {
    return notATable(file);
  }
  return table;
}

const char* name(pairing::Doubt doubt) {
  return kDoubts.at(static_cast<std::size_t>(doubt));
}

const char* name(FailedCheck failed_check) {
  return kFailedChecks.at(static_cast<std::size_t>(failed_check));
}

Result<CandidateTable> readCandidatesOf(const std::filesystem::path& output) {
  const std::filesystem::path file = output / "work" / "pairs" / "candidates.json";
  std::error_code failed;
  if (!std::filesystem::exists(file, failed))
    return Error{
        ErrorCode::Missing,
        message("The pairs of this batch are not processed yet; process the batch: complete "
                "results are kept."),
        output.string()};
  Result<CandidateTable> table = readCandidates(file);
  if (table) readDecided(output / "pairs.json", *table);
  return table;
}

}  // namespace ostraka::decisions
