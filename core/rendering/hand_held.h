#pragma once
#include "base/result.h"
#include "rig/printed_sheet.h"

/// Photographs by hand over a printed sheet on a table.
namespace ostraka::rendering {

enum class TableKind { Wood, Cloth, Granite, CuttingMat };
enum class LightKind {
  Window,    ///< large and from one side
  Lamp,      ///< a desk lamp: small, warm, with hard shadows
  Flash,     ///< at the camera, in a dim room
  Overcast,  ///< outdoors without sun: from everywhere
  Sun        ///< hard shadows, blue sky
};
enum class CameraKind { Phone, Dslr, Compact };

struct HandHeldOptions {
  int photographs = 30;  ///< a side
  rig::SheetSize sheet = rig::SheetSize::A4;
  TableKind table = TableKind::Wood;
  LightKind light = LightKind::Window;
  CameraKind camera = CameraKind::Phone;
  double bend_mm = 0;  ///< how far the sheet rises from the table at most
  int clutter = 0;     ///< things beside the sherds that are none: scale bar, label, card, pencil
  /// Names the field that cannot be.
  Result<void> check() const;
};

}  // namespace ostraka::rendering
