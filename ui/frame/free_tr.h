#pragma once
#include <QCoreApplication>
#include <QString>

namespace ostraka::ui {

/// Translates outside of a class.
inline QString tr(const char* text) {
  return QCoreApplication::translate("ostraka::ui", text);
}

}  // namespace ostraka::ui
