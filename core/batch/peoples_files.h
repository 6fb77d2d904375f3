#pragma once

namespace ostraka::batch {

/// What people say of a batch, in its OUT beside what is computed: nothing that is computed,
/// fetched or merged takes their place.
inline constexpr const char* kDecisionsFile = "decisions.json";
inline constexpr const char* kMaskStrokesFile = "mask_strokes.json";
inline constexpr const char* kPeoplesFiles[] = {kDecisionsFile, kMaskStrokesFile};

}  // namespace ostraka::batch
