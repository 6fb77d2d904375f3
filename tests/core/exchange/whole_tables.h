#pragma once
#include <map>
#include <string>
#include <vector>

#include "catalogue/catalogue.h"
#include "store/database.h"

namespace ostraka::exchange {

// One text a row, in which ids stand for rows; when something entered a catalogue is its own.
inline const std::map<std::string, std::string> kWholeTables = {
    {"person", "SELECT json_array(id, name, initials, orcid) FROM person"},
    {"context",
     "SELECT json_array(c.id, s.id, t.id, c.number, c.kind, c.period, c.note, c.closed) FROM "
     "context c JOIN site s ON s.row = c.site LEFT JOIN trench t ON t.row = c.trench"},
    {"bag",
     "SELECT json_array(b.id, c.id, b.number, b.collected_on, b.count_written, b.weight_g, "
     "b.storage) FROM bag b JOIN context c ON c.row = b.context"},
    {"batch",
     "SELECT json_array(b.id, b.number, p.id, b.counted, b.state, b.started_ms, b.ended_ms, "
     "b.reprojection_px, b.scale_error_pct, b.scale, b.scale_doubts, b.rig_sha256, b.program, "
     "b.settings_sha256, b.note) FROM batch b LEFT JOIN person p ON p.row = b.operator"},
    {"batch_bag",
     "SELECT json_array(b.id, k.position, g.id) FROM batch_bag k JOIN batch b ON b.row = k.batch "
     "JOIN bag g ON g.row = k.bag"},
    {"photograph",
     "SELECT json_array(p.id, b.id, side, camera, stop, take, path, serial, exif, angle_deg, "
     "sharpness, used, reason) FROM photograph p JOIN batch b ON b.row = p.batch"},
    {"scan",
     "SELECT json_array(s.id, b.id, side, position, name, path, points, coverage_pct, plate_x_mm, "
     "plate_y_mm, s.state) FROM scan s JOIN batch b ON b.row = s.batch"},
    {"pair_decision",
     "SELECT json_array(d.id, d.decision, d.at, p.id, b.id, f.id, k.id, d.front_from_back, "
     "d.score, d.margin, "
     "d.ambiguous, d.fracture_rms_mm, d.fracture_overlap, d.verdict, r.id, d.note) FROM "
     "pair_decision d JOIN "
     "batch b ON b.row = d.batch LEFT JOIN person p ON p.row = d.person LEFT JOIN scan f ON f.row "
     "= d.front LEFT JOIN scan k ON k.row = d.back LEFT JOIN pair_decision r ON r.row = "
     "d.replaces"},
    {"piece_decision",
     "SELECT json_array(d.id, d.decision, d.at, p.id, b.id, d.side, d.verdict, json(d.pieces), "
     "json(d.cut_mm), "
     "r.id, d.note) FROM piece_decision d JOIN batch b ON b.row = d.batch LEFT JOIN person p ON "
     "p.row = d.person LEFT JOIN piece_decision r ON r.row = d.replaces"},
    {"sherd",
     "SELECT json_array(s.id, s.number, s.number_sort, s.state, s.void_reason, c.id, g.id, b.id, "
     "f.id, k.id, s.part, s.decoration, s.condition, s.ware, s.vessel, s.note, json(s.extra)) FROM "
     "sherd s LEFT JOIN context c ON c.row = s.context LEFT JOIN bag g ON g.row = s.bag LEFT JOIN "
     "batch b ON b.row = s.batch LEFT JOIN scan f ON f.row = s.front LEFT JOIN scan k ON k.row = "
     "s.back"},
    {"sherd_measure",
     "SELECT json_array(s.id, length, width, thickness_min, thickness_mean, thickness_max, area, "
     "volume, filled_pct, rim_diameter, rim_pct, weight) FROM sherd_measure m JOIN sherd s ON "
     "s.row = m.sherd"},
    {"sherd_join",
     "SELECT json_array(a.id, b.id) FROM sherd_join j JOIN sherd a ON a.row = j.sherd JOIN sherd b "
     "ON b.row = j.other"},
    {"file",
     "SELECT json_array(sha256, bytes, media_type, role, path) FROM file WHERE role = "
     "'photo'"}};

inline std::vector<std::string> rowsOf(const catalogue::Catalogue& catalogue,
                                       const std::string& query) {
  std::vector<std::string> all;
  store::Statement rows = catalogue.database().sql(query + " ORDER BY 1");
  while (rows.next()) {
    all.emplace_back();
    rows >> all.back();
  }
  return all;
}

}  // namespace ostraka::exchange
