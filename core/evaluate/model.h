#pragma once
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "cloud/point_cloud.h"

namespace ostraka::evaluate {

enum class Align {
  None,  ///< poses as the program gave them: errors of scale and frame count
  Icp    ///< rigid refinement to the truth first, as in the paper: hides pose errors, never scale
};

struct ModelOptions {
  Align align = Align::None;
  int threads = 0;                       ///< <= 0: all available
  double sample_spacing_mm = 0.15;       ///< metrics.md
  double completeness_within_mm = 0.25;  ///< metrics.md
};

/// A reconstruction against a closed true mesh (Seitz et al., CVPR 2006). Lengths in mm.
struct ModelFigures {
  double accuracy_mm = 0;  ///< 90th percentile of the distances from model to truth
  double completeness_percent =
      0;               ///< share of the truth within completeness_within_mm of the model
  double mean_mm = 0;  ///< MAE
  double sd_mm = 0, rms_mm = 0, max_mm = 0;
  double truth_to_model_p90_mm = 0;
  std::size_t model_samples = 0, truth_samples = 0, faces = 0;
  double aligned_by_mm = 0, aligned_by_deg = 0;  ///< with Align::Icp
};

/// Both in one frame. A model without faces is taken as points. Errors: a truth without faces, an
/// empty model, Cancelled.
Result<ModelFigures> compareModel(const TriangleMesh& model, const TriangleMesh& truth,
                                  const ModelOptions& options, Progress& progress,
                                  std::stop_token stop);

struct NamedMesh {
  std::string name;
  TriangleMesh mesh;  ///< plate_front frame
};

struct SherdFigures {
  std::string sherd;
  std::optional<std::string> model;  ///< absent: no model overlaps this sherd
  double overlap = 0;
  ModelFigures figures;
};

struct BatchEvaluation {
  std::vector<SherdFigures> sherds;      ///< one per true sherd
  std::vector<std::string> superfluous;  ///< models that are no sherd's
  int missing = 0;
  /// Means over the sherds with a model.
  double accuracy_mm = 0, completeness_percent = 0, mean_mm = 0, sd_mm = 0;
  double completeness_missing_as_zero_percent = 0;
  bool goals_met = false;  ///< accuracy <= 0.20 mm, completeness >= 95 %, MAE <= 0.09 mm
};

/// Models are matched to sherds one to one by overlap: the mean of the two shares of samples, 1 mm
/// apart, that lie within 1.5 mm of the other's; optimal assignment, at least 0.25.
Result<BatchEvaluation> evaluateBatch(const std::vector<NamedMesh>& models,
                                      const std::vector<NamedMesh>& truth,
                                      const ModelOptions& options, Progress& progress,
                                      std::stop_token stop);

}  // namespace ostraka::evaluate
