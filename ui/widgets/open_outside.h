#pragma once
#include <QString>

namespace ostraka::ui {

/// Opens a file or a folder with the desktop's program for it. Returns what to tell a person, with
/// the path: a desktop without such a program often does not say so.
QString openOutside(const QString& path);

}  // namespace ostraka::ui
