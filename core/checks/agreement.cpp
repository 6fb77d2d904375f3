#include "checks/agreement.h"

namespace ostraka::checks {

std::optional<Message> disagreement(batch::Side side, const stereo::Agreement& agreement) {
  if (agreement.plausible()) return std::nullopt;
  const Decimal percent = decimal(100 * agreement.coveredShare(), 0);
  return side == batch::Side::Front
             ? message(
                   "The photographs of the front side agree on only %1 % of what its masks show, "
                   "so its scans may be wrong. Check the masks, and that nothing moved while they "
                   "were taken.",
                   percent)
             : message(
                   "The photographs of the back side agree on only %1 % of what its masks show, "
                   "so its scans may be wrong. Check the masks, and that nothing moved while they "
                   "were taken.",
                   percent);
}

}  // namespace ostraka::checks
