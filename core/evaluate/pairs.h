#pragma once
#include <Eigen/Geometry>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "cloud/point_cloud.h"

namespace ostraka::evaluate {

/// A pair as pairs.json proposes it. Scans are named by the stem of their file.
struct ProposedPair {
  std::string front, back;
  std::optional<double> score, margin, fracture_rms_mm;
  bool ambiguous = false;
  std::vector<std::string> alternative_backs;
  bool has_transform = false;  ///< false also when T is not rigid
  bool transform_not_rigid = false;
  Eigen::Isometry3d front_from_back = Eigen::Isometry3d::Identity();
};

struct Proposal {
  std::vector<ProposedPair> pairs;
  std::vector<std::string> unpaired_front, unpaired_back;
};

struct TruePair {
  std::string front, back;            ///< stems
  std::string front_file, back_file;  ///< as in the truth, relative to the scans' folder
  Eigen::Isometry3d front_from_back = Eigen::Isometry3d::Identity();
};

struct PairsTruth {
  std::string set;  ///< name of the folder
  std::vector<TruePair> pairs;
  std::vector<std::string> unpaired_front, unpaired_back;
  int unseen_pairs = 0;  ///< true pairs of which a scan is not there at all
};

/// pairs.json of `register` and `process`. Errors: unreadable, a pair without front or back.
Result<Proposal> readProposal(const std::filesystem::path& pairs_json);
/// truth.json of a set of scans. Errors: unreadable, a transform that is not rigid.
Result<PairsTruth> readPairsTruth(const std::filesystem::path& truth_json);

/// How far a registration is from the true one, over all points of the back scan.
struct RegistrationError {
  double rms_mm = 0;        ///< sqrt(mean |T p - T* p|^2)
  double rotation_deg = 0;  ///< angle of inv(T*) T
  double shift_mm = 0;      ///< |mean(T p - T* p)|
  /// Share of the error along the front's normals on the strip that both sides saw; absent when
  /// the front has no normals or at most 50 points of the back lie there.
  std::optional<double> across_share;
  bool slipped =
      false;  ///< rms > 0.10 mm with across_share < 0.5: the fractures fit at a wrong place
};

RegistrationError registrationError(const Eigen::Isometry3d& found, const Eigen::Isometry3d& truth,
                                    const PointCloud& back, const PointCloud& front);

enum class TransformState { None, NotRigid, Measured };  ///< None also for wrong pairs

struct PairVerdict {
  ProposedPair pair;
  bool right = false;
  bool silent_error = false;  ///< wrong and not flagged
  bool truth_among_alternatives = false;
  TransformState transform = TransformState::None;
  RegistrationError error;  ///< of a right pair whose transform was measured
};

struct PairsEvaluation {
  std::string set;
  int true_pairs = 0;
  std::vector<PairVerdict> verdicts;   ///< in the proposal's order
  std::vector<std::string> missed;     ///< fronts of true pairs of which neither scan was paired
  std::vector<std::string> forgotten;  ///< scans in no pair and in no unpaired list
  int unseen = 0;                      ///< true pairs without both scans; counted in true_pairs
  int lone = 0, lone_right = 0;        ///< scans without a partner; those left alone
};

using ScanReader = std::function<Result<PointCloud>(const std::string& file)>;

/// Judges a proposal. read_scan is called for both scans of each right pair with a transform.
/// Errors: a scan that the truth does not know or that stands in two pairs, and read_scan's.
Result<PairsEvaluation> evaluatePairs(const Proposal& proposal, const PairsTruth& truth,
                                      const ScanReader& read_scan);

struct PairsSummary {
  int true_pairs = 0, right = 0, wrong = 0, silent_errors = 0, flagged = 0, flagged_wrong = 0;
  int missed = 0, forgotten = 0, lone = 0, lone_right = 0, slipped = 0, not_registered = 0;
  double right_percent = 0;  ///< of the true pairs, not of those proposed
  /// Over right pairs, a missing transform counting as infinite; the smallest value that reaches
  /// the share, without interpolation.
  double rms_median_mm = 0, rms_p95_mm = 0, rms_max_mm = 0;
  double share_within_0_10_percent = 0, share_within_0_05_percent = 0;
  double share_of_true_within_0_10_percent = 0;
  double rotation_median_deg = 0, shift_median_mm = 0;
  bool goals_met = false;  ///< right >= 98 %, no silent error, 95 % within 0.10, median <= 0.05 mm
};

/// All sets together, each pair with the same weight.
PairsSummary summarise(const std::vector<PairsEvaluation>& sets);

}  // namespace ostraka::evaluate
