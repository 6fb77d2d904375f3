#pragma once
#include <array>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/memory.h"
#include "batch/batch.h"
#include "colour/correction.h"
#include "decisions/decisions.h"
#include "decisions/pair_sides.h"
#include "decisions/scan_folder.h"
#include "files/folder_lock.h"
#include "model/model.h"
#include "pipeline/process_batch.h"
#include "rig/camera.h"
#include "rig/rig.h"
#include "rig/sheet_bend.h"
#include "stages/batch_inputs.h"
#include "stages/stage.h"

namespace ostraka::pipeline {

/// A stage's outcome: what it left, as read back from its files, and its record.
template <class T>
struct Staged {
  T value;
  stages::StageRecord record;
};

/// What all stages of one run share.
struct Run {
  const ProcessOptions& options;
  const batch::Batch& batch;
  const FolderLock& held;      ///< of OUT/work
  std::filesystem::path work;  ///< OUT/work
  const stages::BatchInputs& inputs;
  std::string batch_hash;  ///< names and contents of everything that is read from the batch
  std::array<std::string, 2> photographs;  ///< of fronts and backs: ScanRef::photographs
  const decisions::Decisions& decisions;   ///< of people, those that hold
  Progress& progress;
  std::stop_token stop;
  Staged<std::optional<colour::Correction>> colours = {};  ///< by a chart, where there is one

  /// Those that may each have a whole photograph.
  int threadsForOriginals() const {
    return batch::threadsForOriginals(batch, options.threads, freeMemoryMb());
  }
  /// The same run, which reports here.
  Run with(Progress& part) const {
    return {options,     batch,     held, work, inputs, batch_hash,
            photographs, decisions, part, stop, colours};
  }
  const std::string& photographsOf(batch::Side side) const {
    return photographs[side == batch::Side::Front ? 0 : 1];
  }
};

struct Poses {
  /// Both sides, plate frame; photographs of more than ProcessOptions::megapixels with the camera
  /// of the reduced picture, unlike in OUT/work/rig/cameras.json.
  std::vector<rig::PosedImage> images;
  rig::Rig rig;           ///< empty without a turntable
  bool has_scale = true;  ///< false: no length is known; without a sheet each side has its own size
  std::array<rig::SheetBend, 2> bends = {};  ///< of the printed sheet, by side
  /// Without a plate, by side: the part that was seen of what the sherds stand on, z = 0.
  std::array<std::optional<Eigen::AlignedBox2d>, 2> grounds = {};
  std::vector<rig::PosedImage> of(batch::Side side) const;
};

/// The masks of one side, in the order of poses.of(side).
using Masks = std::vector<cv::Mat1b>;

/// One pair as decided, with scans by index; what pairs.json says, read back.
struct DecidedPair {
  int front = 0, back = 0;
  std::optional<double> score, margin;  ///< none where the pairing states none
  bool ambiguous = false, check_failed = false;
  std::string reason;
  Eigen::Isometry3d front_from_back = Eigen::Isometry3d::Identity();
  double fracture_rms_mm = 0, fracture_overlap = 0, uncertainty_mm = 0;
  std::string decided_by, decided_at;  ///< a person's word; empty: the program's own
  bool fracturesCompared() const { return fracture_rms_mm > 0; }
};

struct Pairs {
  nlohmann::ordered_json json;  ///< as pairs.json
  std::vector<DecidedPair> pairs;
  std::vector<std::string> unpaired_front, unpaired_back;
  std::vector<std::string> set_aside, reshoot;  ///< by a person; fronts, then backs
};

/// runStage of OUT/work (stage.h) for all steps of the chain: what was made while a file of the
/// batch changed is not recorded (BatchInputs::checkUnchanged).
Result<stages::StageRecord> runStage(const Run& run, const std::string& name,
                                     const nlohmann::ordered_json& key,
                                     const stages::StageWork& work);

/// 0 is the front, 1 the back.
constexpr std::size_t sideIndex(batch::Side side) {
  return side == batch::Side::Front ? 0 : 1;
}

/// The photograph of an image; nullptr: it is not of this batch.
const batch::Shot* findShot(const batch::Batch& batch, const rig::PosedImage& image);

/// The chain, one call per step. Each runs its stage or finds it whole.
Result<Staged<Poses>> poseStage(const Run& run);
Result<Staged<std::optional<colour::Correction>>> colourStage(const Run& run);
Result<Staged<Masks>> maskStage(const Run& run, batch::Side side, const Staged<Poses>& poses);
/// The masks as people edited them (mask_strokes.h); without strokes on this side as they were
/// found. The program's own stay where they are.
Result<Staged<Masks>> editedMasksStage(const Run& run, batch::Side side, const Staged<Poses>& poses,
                                       Staged<Masks> found);
Result<Staged<PointCloud>> denseStage(const Run& run, batch::Side side, const Staged<Poses>& poses,
                                      const Staged<Masks>& masks);
/// Pieces as people joined and split them; without such decisions as the program found them.
/// The record's "doubtful": scan::SplitResult.
Result<Staged<std::vector<scan::Scan>>> scanStage(const Run& run, batch::Side side,
                                                  const Staged<Poses>& poses,
                                                  const Staged<Masks>& masks,
                                                  const Staged<PointCloud>& cloud);
/// The same from scans that were split already; they are named f001 or b001 on in their order, and
/// the record says which file each came from.
Result<Staged<std::vector<scan::Scan>>> importStage(const Run& run, batch::Side side,
                                                    const decisions::ScanFolder& folder);
/// The folder under OUT/work that holds the scans of a side: scans_front, or pieces_front.
std::string scanFolder(const Run& run, batch::Side side);
/// Front size / back size where the poses have no scale, else 1 without a stage.
Result<Staged<double>> scaleStage(const Run& run, const Staged<Poses>& poses,
                                  const Staged<std::vector<scan::Scan>>& fronts,
                                  const Staged<std::vector<scan::Scan>>& backs);
/// Fractures compared, and what people decided put into effect. back_scale: of scaleStage.
Result<Staged<Pairs>> pairStage(const Run& run, const Staged<Poses>& poses, double back_scale,
                                const Staged<Masks>& front_masks, const Staged<Masks>& back_masks,
                                const Staged<std::vector<scan::Scan>>& fronts,
                                const Staged<std::vector<scan::Scan>>& backs);

}  // namespace ostraka::pipeline
