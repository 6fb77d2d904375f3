#pragma once
#include <optional>
#include <stop_token>

#include "registration/pair_fit.h"

namespace ostraka::registration {

/// The pose of a back whose contour does not tell how far it is turned, as of a whole pot, a base
/// or a disc: it is turned all the way round about the viewer's axis and fitted coarsely, and the
/// turn at which the colours of both sides lie on each other, fitted finely, is returned. Absent
/// where they do so at no turn far better than at the others. About 3 s, one thread.
std::optional<FittedPose> turnByColours(const FittedPose& pose, const Strip& front,
                                        const Strip& back, const PairFit& pair, int threads,
                                        const std::stop_token& stop);

}  // namespace ostraka::registration
