#pragma once
#include <QImage>
#include <QStringList>

#include "capture/clearance.h"
#include "capture/shot_checks.h"

namespace ostraka::ui {

enum class CapturePhase {
  NoRig,    ///< no rig was chosen, or it does not answer
  Opening,  ///< the devices are being opened
  Place,    ///< sherds are laid on the plate
  ShootFront,
  Flip,  ///< a person turns the sherds over
  ShootBack,
  Done  ///< the plate may be cleared, unless there are doubts
};

/// A picture of the plate and what is seen on it.
struct PlatePicture {
  QImage image;
  capture::PlateInspection inspection;
  capture::Clearance room;  ///< for more, while sherds are being placed
  QStringList codes;        ///< QR codes in sight while sherds are placed or turned over
};

/// One photograph of the side that is being shot.
struct TakenShot {
  int stop = 0, camera = 0, take = 0;
  QString file;
  QStringList problems;  ///< in words; none: good
  bool refused = false;  ///< not kept: it is being taken again
};

/// A line of the facts beside the live picture.
struct CaptureFact {
  bool good = true;
  QString words;
};

}  // namespace ostraka::ui
