#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "cloud/ply.h"
#include "decisions/candidate_table.h"
#include "files/files.h"
#include "files/json.h"
#include "noted_results.h"

namespace ostraka::catalogue {

/// Writes OUT as `ostraka process` leaves it: n fronts, n backs, pairs i-i with models.
class ResultFolder : public NotedResults {
 public:
  ResultFolder(std::filesystem::path out, int n) : out_(std::move(out)) {
    for (int i = 1; i <= n; ++i) {
      pairs_.push_back({i, i, false});
      places_mm.push_back({40.0 * i, 0});
    }
    write();
  }
  struct Pair {
    int front, back;
    bool ambiguous;
    std::string decided_by = {};
  };
  std::vector<Pair>& pairs() { return pairs_; }
  /// Of each piece, both sides alike: piece 1 is the first.
  std::vector<Eigen::Vector2d> places_mm;
  /// Pieces that a person joined to others: they keep their index, and are not written.
  std::set<int> gone;
  /// A name for the photographs of both sides; without it there is no table of candidates.
  std::string photographs;
  double length_mm = 50;
  bool has_scale = true;
  std::string scale;
  std::vector<std::string> scale_doubts;
  bool draft = false;

  void write() const {
    using nlohmann::ordered_json;
    ordered_json pairs = ordered_json::array(), sherds = ordered_json::array();
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const Pair& p = pairs_[i];
      Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
      pose.translation().x() = p.back;
      pairs.push_back({{"front", name('f', p.front)},
                       {"back", name('b', p.back)},
                       {"score", 0.99},
                       {"margin", 0.9},
                       {"ambiguous", p.ambiguous},
                       {"reason", p.ambiguous ? "two look alike" : ""},
                       {"T_front_from_back", toJson(pose)},
                       {"fracture_rms_mm", 0.2},
                       {"fracture_overlap", 0.6}});
      if (!p.decided_by.empty())
        pairs.back()["decided"] = {{"by", p.decided_by}, {"at", "2026-07-14T18:30:00Z"}};
      const std::string number = "0" + std::to_string(i + 1);
      sherds.push_back({{"number", number},
                        {"front", name('f', p.front)},
                        {"back", name('b', p.back)},
                        {"figures",
                         {{"model", true},
                          {"filled_share", 0.007},
                          {"measures",
                           {{"length_mm", length_mm + p.front},
                            {"width_mm", 30},
                            {"thickness_min_mm", 4},
                            {"thickness_mean_mm", 5},
                            {"thickness_max_mm", 6},
                            {"area_mm2", 1000},
                            {"volume_mm3", 2000}}}}}});
      const std::string model = "model of " + name('f', p.front) + name('b', p.back);
      for (const char* file : {"model.ply", "model.glb", "preview.png"})
        put(out_ / "sherds" / number / file, model + file);
      noteModel(out_, number);
    }
    for (const char* side : {"front", "back"})
      std::filesystem::remove_all(out_ / "work" / ("scans_" + std::string(side)));
    decisions::CandidateTable table;
    for (std::size_t i = 0; i < places_mm.size(); ++i) {
      PointCloud cloud;
      for (const Eigen::Vector2d& corner : {Eigen::Vector2d(-1, -1), {1, -1}, {0, 2}})
        cloud.points.emplace_back((places_mm[i] + corner).x(), (places_mm[i] + corner).y(), 0);
      const int n = static_cast<int>(i) + 1;
      if (gone.contains(n)) continue;
      table.fronts.push_back({batch::Side::Front, name('f', n), places_mm[i], photographs});
      table.backs.push_back({batch::Side::Back, name('b', n), places_mm[i], photographs});
      table.front_files.push_back("scans_front/" + name('f', n) + ".ply");
      table.back_files.push_back("scans_back/" + name('b', n) + ".ply");
      put(out_ / "work/scans_front" / (name('f', n) + ".ply"), formatPly(cloud, "plate_front"));
      put(out_ / "work/scans_back" / (name('b', n) + ".ply"), formatPly(cloud, "plate_back"));
    }
    for (const char* stage : {"scans_front", "scans_back", "pairs"})
      put(out_ / "work" / stage / "stage.json", R"({"files": {}})");
    if (!photographs.empty())
      put(out_ / "work/pairs/candidates.json", decisions::toJson(table).dump());
    put(out_ / "pairs.json", ordered_json({{"unit", "mm"}, {"pairs", pairs}}).dump());
    put(out_ / "report.json",
        ordered_json(
            {{"format", "ostraka-report/1"},
             {"has_scale", has_scale},
             {"scale", scale},
             {"scale_doubts", scale_doubts},
             {"draft", draft},
             {"stages",
              {{{"stage", "cameras"},
                {"figures",
                 {{"reprojection_rms_px", 0.31},
                  {"held_out", {{{"error_pct", 0.02}}, {{"error_pct", -0.05}}}},
                  {"known_lengths", {{{"error_pct", scale_doubts.empty() ? 0.01 : -0.98}}}}}}}}},
             {"sherds", sherds}})
            .dump());
    put(out_ / "report.html", "<html></html>");
    noteReports(out_);
    noteInputs(out_, out_.parent_path().parent_path() / "batches" / out_.filename());
  }

 private:
  static std::string name(char side, int index) { return side + ("00" + std::to_string(index)); }
  std::filesystem::path out_;
  std::vector<Pair> pairs_;
};

}  // namespace ostraka::catalogue
