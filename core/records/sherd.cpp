#include "records/sherd.h"

namespace ostraka::records {

std::string unitOf(const std::string& kind) {
  if (kind == "area") return "mm2";
  if (kind == "volume") return "mm3";
  if (kind == "weight") return "g";
  if (kind == "filled_pct" || kind == "rim_pct") return "pct";
  for (const char* length :
       {"length", "width", "thickness_min", "thickness_mean", "thickness_max", "rim_diameter"})
    if (kind == length) return "mm";
  return {};
}

}  // namespace ostraka::records
