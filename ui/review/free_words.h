#pragma once
#include <QString>
#include <vector>

#include "pipeline/decisions.h"
#include "ui/frame/free_tr.h"

namespace ostraka::ui {

/// The ID of scan i; empty for none.
inline QString idOf(const std::vector<pipeline::ScanRef>& scans, int i) {
  if (i < 0 || i >= static_cast<int>(scans.size())) return {};
  return QString::fromStdString(scans[static_cast<std::size_t>(i)].id);
}

}  // namespace ostraka::ui
