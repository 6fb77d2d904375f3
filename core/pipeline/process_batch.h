#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "colour/munsell_proposals.h"
#include "pairing/candidates.h"
#include "registration/register_sides.h"

namespace ostraka::pipeline {

enum class DenseMethod { Builtin, Colmap, OpenMvs };

/// What a texture shows: the light of the photographs too, or the sherd's own colours alone.
enum class TextureColours { Photo, Albedo };

/// For a quick look at both sides while they still lie on the plate: coarser, in a fraction of the
/// time.
constexpr double kDraftMegapixels = 0.8;
constexpr double kUsualMegapixels = 5;

struct ProcessOptions {
  /// A batch folder, or one with the photographs of the front; nothing in it is ever written.
  std::filesystem::path batch;
  std::optional<std::filesystem::path> back;   ///< photographs of the back; batch holds the front's
  std::optional<std::filesystem::path> sheet;  ///< in place of plate.json beside the photographs
  /// Side of a marker's black square: without any plate.json the sheet is found in the photographs.
  std::optional<double> marker_mm;
  std::filesystem::path output;              ///< OUT; created, or continued when of the same batch
  std::optional<std::filesystem::path> rig;  ///< RIG.json of an earlier calibration
  DenseMethod dense = DenseMethod::Builtin;
  std::string masks = "auto";  ///< "auto", "given", or the path of an ONNX network
  /// Photographs of more are averaged down to this for stereo, whose time grows with the pixels;
  /// the cameras are found in the originals. Millions of pixels.
  double megapixels = kUsualMegapixels;
  /// What masks and stereo may take: masks are made on fewer pixels, and stereo part by part, where
  /// whole photographs would take more. The result depends on it a little.
  double memory_gb = 4;
  TextureColours texture = TextureColours::Photo;
  pairing::Method pairing = pairing::Method::Default;
  registration::Method registration = registration::Method::Default;
  registration::Boundary boundary = registration::Boundary::Strip;
  int threads = 0;  ///< 0: all that this process may use; the result does not depend on it
  std::vector<Message> warnings;  ///< what is known of the batch already; in the results, too
  std::function<void(double core_s)> estimated = {};  ///< hears what it will take (Needs), if set

  Result<void> check() const;
};

/// One line of the pair table.
struct SherdSummary {
  std::string number;  ///< "01": folder under OUT/sherds
  std::string front, back;
  std::optional<double> score;  ///< none where the pairing states none
  double fracture_rms_mm = 0, uncertainty_mm = 0;
  bool ambiguous = false;
  bool has_model = false;
  std::string decided_by;  ///< the person who settled this pair; empty: the program
  /// What the photographs propose for its Munsell fields; none without a texture.
  std::optional<colour::MunsellProposals> munsell{};
  std::string remark;  ///< why a person must look, or what the model lacks; else empty
  bool fracturesCompared() const {
    return fracture_rms_mm > 0;
  }  ///< false: the figure says nothing
};

struct ProcessSummary {
  std::vector<SherdSummary> sherds;
  std::vector<std::string> unpaired_front, unpaired_back;
  std::vector<std::string> set_aside;  ///< scans that a person took out
  std::vector<std::string> reshoot;    ///< scans that a person wants shot again: not whole
  std::vector<std::string> moved;      ///< scans pushed while photographed: not whole
  /// Without a scale: sentences about pieces that were left out and may be sherds. Not whole.
  std::vector<Message> left_out;
  std::vector<Message> warnings;
  double reprojection_rms_px = 0;
  /// A length of scale.json, or a distance between markers that took no part in the fit, is not
  /// what plate.json makes of it: the batch is held until a person has found out why. Sentences,
  /// which stand among the warnings too.
  std::vector<Message> scale_doubts;
  bool draft = false;  ///< from photographs averaged down to kDraftMegapixels or less
  double seconds = 0;  ///< of this run, not of stages done earlier
  std::filesystem::path report;
  int ambiguous() const;
  bool whole() const;  ///< every sherd has a model and nothing failed
};

/// Photographs to complete sherds, stage by stage (OUT/work), going on from the last whole stage.
/// What people decided (OUT/decisions.json, decisions.h) is an input like any other.
/// Errors: UnusableInput (the batch, or an OUT of another batch), CannotWrite, NotEnough,
/// Cancelled.
Result<ProcessSummary> processBatch(const ProcessOptions& options, Progress& progress,
                                    std::stop_token stop);

/// The same from scans that were split already: ProcessOptions::batch holds them as PLY files in
/// front/ and back/, one a sherd, oriented points, mm. Without photographs nothing is looked at but
/// fractures and outlines. Scans that stand on no plate are turned so that their face is up, and
/// laid beside each other.
Result<ProcessSummary> processScans(const ProcessOptions& options, Progress& progress,
                                    std::stop_token stop);

}  // namespace ostraka::pipeline
