#pragma once
#include <QCoreApplication>
#include <QString>
#include <vector>

#include "pipeline/decisions.h"

namespace ostraka::ui {

/// Translates outside of a class.
inline QString tr(const char* text) {
  return QCoreApplication::translate("ostraka::ui", text);
}

/// The ID of scan i; empty for none.
inline QString idOf(const std::vector<pipeline::ScanRef>& scans, int i) {
  if (i < 0 || i >= static_cast<int>(scans.size())) return {};
  return QString::fromStdString(scans[static_cast<std::size_t>(i)].id);
}

}  // namespace ostraka::ui
