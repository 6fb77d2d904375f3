#pragma once
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/message.h"
#include "records/plausibility.h"
#include "records/records.h"

namespace ostraka::records {

enum class SherdState { Draft, Numbered, Void };

/// A sherd with everything that a row of the table and the details show.
struct SherdRecord {
  store::SherdRow row;
  std::string id, number;  ///< number is empty for a draft
  SherdState state = SherdState::Draft;
  std::string void_reason;
  store::ContextRow context;
  store::BagRow bag;
  store::BatchRow batch;       ///< that it was photographed in
  store::ScanRow front, back;  ///< back is none while the front has no partner
  std::vector<std::string> part, decoration, condition;  ///< terms of the vocabularies
  std::string ware, fabric, inclusions, manufacture, firing, surface_out, surface_in;
  std::string munsell_out, munsell_in, munsell_core, period, date_edtf, vessel, note;
  std::vector<store::SherdRow> joins;  ///< sherds that it joins; goes both ways
  std::string extra_json = "{}";       ///< custom fields
  int revision = 0;
  // read only, from the tables beside it
  std::vector<std::string> join_numbers;  ///< of joins; the id of a sherd without a number
  std::string site, trench, context_number, bag_number, batch_number;
  int piece = 0;                           ///< its front's number on its batch's map; 0: none
  bool scale_doubtful = false;             ///< of the batch; so are the measures in doubtful
  std::string preview_path, model_path;    ///< relative to the project; empty when there is none
  std::map<std::string, double> measures;  ///< kind -> the value that counts now
  std::set<std::string> doubtful;  ///< kinds taken by the program from a model of doubtful scale
  /// kind -> what the program computed, where a person's other value counts
  std::map<std::string, double> replaced;
};

/// kinds: length width thickness_min thickness_mean thickness_max (mm), area (mm2), volume (mm3),
/// filled_pct rim_pct (pct), rim_diameter (mm), weight (g).
struct Measurement {
  store::SherdRow sherd;
  std::string kind, unit;
  double value = 0;
  std::optional<double> uncertainty;  ///< half of the 95 % interval, in the unit
  std::string method = "program";     ///< program, scale, calliper, estimate, imported
  store::PersonRow by;
  std::string model_sha256;
};
/// mm, mm2, mm3, g or pct; empty for an unknown kind.
std::string unitOf(const std::string& measurement_kind);

enum class FileState { Present, Missing, Changed };

struct FileRecord {
  store::FileRow row;
  std::string id, path;                  ///< relative to the project, with '/'
  std::string sha256, media_type, role;  ///< photo mask scan model preview drawing report scale
  std::int64_t bytes = 0;
  FileState state = FileState::Present;
  store::SherdRow sherd;  ///< none: of the batch as a whole
  store::BatchRow batch;
};

struct HistoryEntry {
  std::int64_t at_ms = 0;
  store::PersonRow by;  ///< none: the program
  std::string table, field, old_value, new_value, why, source;
  std::int64_t row = 0;
};

/// What kind of value a field holds; edits and imports are checked against it.
enum class FieldKind { Text, Term, Terms, Munsell, Edtf, Day, Number, Place, Joins };

/// One field of a sherd as people see it in the table, in edits, in CSV.
struct SherdField {
  const char* name;  ///< as in CSV: surface_out, length_mm
  FieldKind kind;
  const char* vocabulary;  ///< part, surface, ... or ""
  bool editable;
};

/// A person's answer to ChangePreview::question.
enum class Confirmation { None, Given };

/// One value to be changed; `value` is text as in CSV, empty deletes.
struct FieldChange {
  store::SherdRow sherd;
  std::string field;
  std::string value;
  Confirmation confirmation = Confirmation::None;
  /// What the field has to hold still, else the change is refused; none: anything.
  std::optional<std::string> expected = std::nullopt;
  std::string method = {};  ///< Measurement::method; empty: as the kind is usually measured by hand
};
/// What a change would do.
struct ChangePreview {
  FieldChange change;
  std::string old_value, new_value;  ///< in canonical form
  Message refusal;                   ///< a sentence; empty when it can be done
  store::SherdRow in_the_way;        ///< who has this number already
  /// Of a measurement that a person has to confirm, and the sentences that ask; else empty.
  std::vector<MeasureFinding> findings = {};
  Message question = {};
  bool asks() const { return !findings.empty() && change.confirmation == Confirmation::None; }
};

/// What the table is ordered by; ties go by number.
struct SherdOrder {
  std::string field = "number";  ///< any field of sherdFields(), or updated
  bool descending = false;
};

struct Term {
  std::string term;                           ///< as stored: rim
  std::map<std::string, std::string> labels;  ///< language -> word
  std::string uri;
  bool operator==(const Term&) const = default;
};
/// That `typed` is none of these, with the first of them in each language that has labels.
Message notATerm(const std::string& typed, const std::vector<Term>& vocabulary);

}  // namespace ostraka::records
