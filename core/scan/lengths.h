#pragma once

namespace ostraka::scan {

/// What the lengths of a batch are. Limits of two kinds are written in mm all the same: those that
/// follow from a pixel's size on the object hold as they are, for without a known length a side is
/// brought to a usual pixel (checks/no_scale.h). Those that follow from the size of sherds (a
/// crumb, a part of a sherd, what is flat) hold in millimetres where these are true; else the usual
/// sherd of the batch stands for one of 45 mm, and they hold beside it.
enum class Lengths {
  Millimetres,  ///< a length is known
  Relative      ///< only how long things are beside each other
};

constexpr double kUsualSherd_mm = 45;

}  // namespace ostraka::scan
