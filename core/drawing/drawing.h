#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/sheet.h"
#include "cloud/point_cloud.h"
#include "drawing/rim.h"
#include "drawing/view.h"
#include "model/model.h"

/// The archaeological drawing of a sherd from its model.
namespace ostraka::drawing {

enum class RimChoice {
  Propose,  ///< drawn as a rim where that is likelier than 0.9, and what is said of it says so
  Yes,      ///< a person says that it is one
  No
};

struct DrawingOptions {
  double scale = 1;  ///< mm on paper per mm: 1 or 0.5 by custom
  RimChoice rim = RimChoice::Propose;
  Surface surface = Surface::Relief;
  std::vector<std::string> remarks;  ///< to stand below the measures, before the drawing's own
  Result<void> check() const;
};

/// One sherd as drawn: section at the left, outer view, inner view; of a rim sherd with the
/// vessel's axis and the mouth's diameter where that is known. Paper mm, y down.
struct SherdDrawing {
  std::string id;
  Sheet sheet;
  Eigen::AlignedBox2d box;         ///< of everything on the sheet
  std::optional<RimEstimate> rim;  ///< where a stretch of the edge could be a lip
  bool drawn_as_rim = false;
  model::Measures measures;
  std::vector<std::string> remarks;  ///< on the sheet, too; whole sentences
  std::vector<std::string> hints;    ///< what could be drawn otherwise; not on the sheet
};

/// mesh: closed, outward, mm. Errors: UnusableInput (options, a mesh without faces; RimChoice::Yes
/// where no stretch of the edge can be a lip).
Result<SherdDrawing> drawSherd(const TriangleMesh& mesh, const std::string& id,
                               const DrawingOptions& options);

struct SheetOptions {
  enum class Layout { OneEach, Plates };
  Layout layout = Layout::OneEach;  ///< a sheet for each sherd, or plates of many
  Paper paper = Paper::A4;
  std::string title;  ///< below the plates; may be empty
};

/// Pages with scale bar. A drawing that is larger than the paper gets A3, then a page of its own
/// size.
std::vector<Page> layOut(const std::vector<SherdDrawing>& drawings, double scale,
                         const SheetOptions& options);

}  // namespace ostraka::drawing
