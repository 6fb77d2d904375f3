#pragma once

namespace ostraka {

/// Peak resident memory of this process so far, MB.
double peakMemoryMb();

/// What this computer can give to a program now, MB; 0 when the system does not say.
double freeMemoryMb();

}  // namespace ostraka
