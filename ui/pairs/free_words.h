#pragma once
#include <QString>
#include <vector>

#include "decisions/decisions.h"
#include "ui/frame/free_tr.h"

namespace ostraka::ui {

/// Without the letter and the zeros that files need: 3 of f003. Scans that were brought along have
/// names of their own.
inline QString plainNumber(const decisions::ScanRef& scan) {
  const QString id = QString::fromStdString(scan.id);
  bool counted = false;
  const int number = id.mid(1).toInt(&counted);
  return counted ? QString::number(number) : id;
}
inline QString nameOf(const decisions::ScanRef& scan) {
  return (scan.side == batch::Side::Front ? tr("front %1") : tr("back %1")).arg(plainNumber(scan));
}
/// What people call scan i; empty for none.
inline QString nameOf(const std::vector<decisions::ScanRef>& scans, int i) {
  return i < 0 || i >= static_cast<int>(scans.size()) ? QString()
                                                      : nameOf(scans[static_cast<std::size_t>(i)]);
}
inline QString plainNumber(const std::vector<decisions::ScanRef>& scans, int i) {
  return i < 0 || i >= static_cast<int>(scans.size())
             ? QString()
             : plainNumber(scans[static_cast<std::size_t>(i)]);
}

}  // namespace ostraka::ui
