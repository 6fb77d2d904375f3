#pragma once
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"

namespace ostraka::pairing {

/// What is known about one pair after its registration. All log-likelihoods are natural logarithms
/// of ratios: 'two sides of one sherd' against 'two sherds at random'.
struct Evidence {
  int front = 0, back = 0;
  double log_likelihood = 0;   ///< contour, fracture and position together, of the best start
  double fracture_rms_mm = 0;  ///< of the registered strips; for reasons and reports only
  double overlap = 0;          ///< share of the strip that met the other side, 0..1
  bool check_failed = false;   ///< the registration's self-check says that the pose may be wrong
  double runner_up_start_log_likelihood = -1e9;  ///< second distinct pose of this same pair
  double distance_rad = 0;  ///< PairCandidate::distance_rad: all that nearestPairs knows
};

struct Alternative {
  int front = 0, back = 0;
  double score = 0;  ///< probability, 0..1
};

/// Why a person must look; decisions::reasonOf says it to people.
enum class Doubt {
  None,
  SelfCheck,     ///< the registration's: see its FailedCheck
  OtherPartner,  ///< another partner fits nearly as well
  Unrelated,     ///< the two sides fit barely better than unrelated ones
  OtherPose,     ///< another pose of the same two sides fits nearly as well
  NotSure,       ///< none of these: the pair is the likeliest by far, but below flag_below
  Displaced,     ///< a person gave its partner to another; set by who knows that, never here
  SharedBack     ///< another front takes the same back: Method::Paper is not one-to-one
};

struct Decision {
  int front = 0, back = 0;
  std::optional<double> score = 0;     ///< probability that the pair and its pose are right; none
                                       ///< where the method states none
  std::optional<double> margin = 0;    ///< score minus the probability of the best alternative
  std::optional<double> distance_rad;  ///< of the outlines' turning angles, Method::Paper only
  std::vector<Alternative> alternatives;  ///< other partners of these two scans, likeliest first
  Doubt doubt = Doubt::None;

  bool ambiguous() const { return doubt != Doubt::None; }
};

struct AssignOptions {
  double lone_log_likelihood = 0.0;  ///< a pair must beat this to be proposed: 0 = even odds
  double flag_below = 0.99;          ///< pairs less certain than this are for a person to decide
  /// Two scans that would both stay alone are proposed to each other, for a person to decide, if
  /// their self-check passes and they are at least this probable.
  double ask_from = 0.1;
  int max_alternatives = 3;
};

struct Assignment {
  std::vector<Decision> pairs;      ///< by front
  std::vector<int> unpaired_front;  ///< rising
  std::vector<int> unpaired_back;
};

/// One-to-one, of greatest total log-likelihood over the whole batch; a scan may stay alone. What
/// is left over is asked about rather than lost (AssignOptions::ask_from).
/// Probabilities come from the best assignment with each other pair (or none) forced.
/// Errors: UnusableInput for indices out of range or figures that are not finite.
/// O(pairs * n^2) for n scans.
Result<Assignment> assignPairs(std::span<const Evidence> evidence, int n_front, int n_back,
                               const AssignOptions& options);

/// Wang et al., ICCV 2023: each front has the back that is nearest to it, however far it is,
/// whoever else has it too, and however the two were registered. evidence: one per front at most
/// (Method::Paper finds no more). Pairs of a shared back or of a failed check are ambiguous; no
/// probability is stated. Errors: UnusableInput for indices out of range.
Result<Assignment> nearestPairs(std::span<const Evidence> evidence, int n_front, int n_back);

/// For each piece of evidence: by how much the best total falls when its pair must be part of the
/// assignment; 0 for the pairs of the best one. What lies 20 below cannot come back by a fracture's
/// word. Errors as assignPairs.
Result<std::vector<double>> regrets(std::span<const Evidence> evidence, int n_front, int n_back,
                                    double lone_log_likelihood);

/// Log-likelihood ratio from outline, fracture and batch size, for Evidence::log_likelihood. A
/// false pair is a non-match (told by the outline from non-matches at random) or, one time in
/// fifty, a near-duplicate (told by the fracture from fractures of like outlines); whichever
/// explains more counts. A scan has n_scans possible partners, and one in ten has none.
double jointLogLikelihood(double outline, double fracture, int n_scans);

}  // namespace ostraka::pairing
