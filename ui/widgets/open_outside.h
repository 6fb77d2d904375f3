#pragma once
#include <QString>

namespace ostraka::ui {

/// Opens a file or a folder with the desktop's program for it. Returns what to tell a person where
/// there is none; empty: it opens.
QString openOutside(const QString& path);

}  // namespace ostraka::ui
