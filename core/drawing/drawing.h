#pragma once
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "drawing/rim.h"
#include "drawing/view.h"
#include "drawing/wording.h"
#include "model/model.h"
#include "paper/sheet.h"

/// The archaeological drawing of a sherd from its model.
namespace ostraka::drawing {

enum class RimChoice {
  Propose,  ///< drawn as a rim where that is likelier than 0.9, and what is said of it says so
  Yes,      ///< a person says that it is one
  No
};

struct Estimate {
  double value = 0;
  std::optional<std::pair<double, double>> interval;  ///< 95 %
};
/// What a person measured, by the catalogue's kinds: length, width, thickness_min, thickness_mean,
/// thickness_max, rim_diameter (mm), rim_pct (%); others are not printed.
using HandMeasures = std::map<std::string, Estimate>;

struct DrawingOptions {
  double scale = 1;  ///< mm on paper per mm: 1 or 0.5 by custom
  RimChoice rim = RimChoice::Propose;
  Surface surface = Surface::Relief;
  Dpi dpi = Dpi::Usual;                                ///< of the views
  const texture::TexturedMesh* photographs = nullptr;  ///< see ViewOptions
  HandMeasures by_hand;  ///< printed instead of what the model says; a mouth is drawn as wide
  std::vector<Message> remarks;  ///< to be said before the drawing's own
  Wording wording;
  Result<void> check() const;
};

/// The mouth's diameter and the share of its circle that is kept, as printed.
struct Mouth {
  Estimate diameter_mm;
  std::optional<Estimate> kept_pct;
  bool by_hand = false;  ///< the catalogue has the diameter by a person
};

/// One sherd as drawn: section at the left, outer view, inner view; of a rim sherd with the
/// vessel's axis and the mouth's diameter where that is known. Paper mm, y down. Remarks and hints
/// are for the person who draws it: a publication's sheet has none.
struct SherdDrawing {
  Message id;
  Sheet sheet;
  Eigen::AlignedBox2d box;         ///< of everything on the sheet
  std::optional<RimEstimate> rim;  ///< where a stretch of the edge could be a lip
  bool drawn_as_rim = false;
  std::optional<Mouth> mouth;    ///< where its diameter is known
  model::Measures measures;      ///< as printed; 0: not
  std::vector<Message> remarks;  ///< what to check before it is printed; English sentences
  std::vector<Message> hints;    ///< what could be drawn otherwise
  Eigen::Isometry3d outer_from_model = Eigen::Isometry3d::Identity();  ///< see drawView
};

/// mesh: closed, outward, mm. Errors: UnusableInput (options, a mesh without faces, one
/// larger than any vessel; RimChoice::Yes where no stretch of the edge can be a lip; an orthophoto
/// of a model without photographs and colours).
Result<SherdDrawing> drawSherd(const TriangleMesh& mesh, const Message& id,
                               const DrawingOptions& options);

/// The outer and the inner view of a drawing beside each other, at its scale.
ViewPicture pictureOf(const TriangleMesh& mesh, const SherdDrawing& drawing,
                      const DrawingOptions& options);

struct SheetOptions {
  enum class Layout { OneEach, Plates };
  Layout layout = Layout::OneEach;  ///< a sheet for each sherd, or plates of many
  Paper paper = Paper::A4;
  std::string title;  ///< below the plates; may be empty
  Wording wording;
};

/// Pages with scale bar. A drawing that is larger than the paper gets A3, then a page of its own
/// size.
std::vector<Page> layOut(const std::vector<SherdDrawing>& drawings, double scale,
                         const SheetOptions& options);

}  // namespace ostraka::drawing
