#pragma once
#include <Eigen/Geometry>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "batch/batch.h"
#include "store/row.h"

namespace ostraka::records {

/// Who does something, and through what; goes into the history with the time.
struct Provenance {
  store::PersonRow person;        ///< none: the program itself
  std::string source = "window";  ///< window, import, process, ...
  std::string why;                ///< a reason typed in; may be empty
};

// Texts are UTF-8; an empty text and an empty optional mean 'not recorded'. `id` is a UUID (version
// 7), given by the catalogue. Times are milliseconds UTC; days are ISO texts (2026-07-14).

struct ProjectRecord {
  std::string id, code, title, institution, rights_holder, licence;
  std::string numbering = "{site}-{trench}-{context}-{n:04}";
  std::string word_for_context = "context";
};

struct PersonRecord {
  store::PersonRow row;
  std::string id, name, initials, orcid;
};

struct SiteRecord {
  store::SiteRow row;
  std::string id, code, name, gazetteer;
  std::optional<double> latitude_deg, longitude_deg;  ///< WGS 84
  bool location_public = false;
};

struct TrenchRecord {
  store::TrenchRow row;
  store::SiteRow site;
  std::string id, code, name;
  store::TrenchRow parent;
};

struct ContextRecord {
  store::ContextRow row;
  store::SiteRow site;
  store::TrenchRow trench;  ///< none: directly in the site
  std::string id, number;   ///< a text: 0012 and 12 differ
  std::string kind, excavated_on, period, date_edtf, note;
  std::optional<bool> closed;                             ///< none: nobody said
  std::string site_code, trench_code, extra_json = "{}";  ///< codes read only; custom fields
  /// As in tables: yes, no, or empty.
  const char* closedWord() const { return !closed ? "" : *closed ? "yes" : "no"; }
};

struct BagRecord {
  store::BagRow row;
  store::ContextRow context;
  std::string id, number, collected_on, storage;
  std::optional<int> count_written;
  std::optional<double> weight_g;
  int sherds = 0;          ///< read only: of the catalogue that lie in it; void ones do not
  std::string entered_by;  ///< read only: initials of who entered it; empty: the program
};

enum class BatchState { Placed, Front, Flipped, Back, Queued, Computed, Review, Done, Failed };

struct BatchRecord {
  store::BatchRow row;
  std::string id, number;  ///< B0031; also the name of its folders
  std::vector<store::BagRow> bags;
  store::PersonRow operator_;
  int counted = 0;  ///< sherds counted by the person, 1..60; 0 = not counted
  BatchState state = BatchState::Placed;
  std::optional<std::int64_t> started_ms, ended_ms;
  std::optional<double> reprojection_px;
  std::optional<double> scale_error_pct;  ///< the worst of the known lengths that took no part
  Message scale;                          ///< what makes it, one sentence; empty: not computed
  std::vector<Message> scale_doubts;      ///< why its measures are in doubt; empty: they are not
  std::string rig_sha256, program, settings_sha256, note;
};

struct PhotographRecord {
  store::PhotographRow row;
  std::string id = {};
  store::BatchRow batch;
  batch::Side side = batch::Side::Front;
  char camera = 'A';       ///< place A, B, C, ...
  int stop = 0, take = 0;  ///< unique together with batch, side and camera
  std::string path;        ///< relative to the project, with '/'
  std::string serial, exif_json;
  std::optional<double> angle_deg, sharpness;
  bool used = true;
  std::string reason;  ///< why not used
};

enum class ScanState { Open, Paired, Aside };

struct ScanRecord {
  store::ScanRow row;
  std::string id = {};
  store::BatchRow batch;
  batch::Side side = batch::Side::Front;
  int index = 0;     ///< 3 for f003; below 0: of an earlier computation, gone since
  std::string name;  ///< as in pairs.json: f003
  std::string path;  ///< relative to the project
  std::optional<int> points;
  std::optional<double> coverage_pct, plate_x_mm, plate_y_mm;
  ScanState state = ScanState::Open;  ///< follows the decisions
  bool isThere() const { return index >= 0; }
};

/// Withdraw takes an earlier decision of a person back (undo); all rows stay.
enum class Verdict { Accept, Reject, Aside, Reshoot, Withdraw };

/// One row of the append-only list. front or back may be none for Aside and Reshoot.
struct PairDecision {
  store::DecisionRow row;
  std::string id = {};
  std::string decision = {};  ///< its id in the batch's decisions.json; empty: the program's own
  store::BatchRow batch;
  store::ScanRow front, back;
  std::optional<Eigen::Isometry3d> front_from_back;  ///< mm
  std::optional<double> score, margin, fracture_rms_mm, fracture_overlap;
  bool ambiguous = false;
  store::PersonRow by;  ///< none: the program
  Verdict verdict = Verdict::Accept;
  store::DecisionRow replaces;
  std::string note;
  std::int64_t at_ms = 0;
};

}  // namespace ostraka::records
