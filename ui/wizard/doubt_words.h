#pragma once
#include <QStringList>

#include "capture/sequence.h"

/// What the checks of a capture found, in the person's language.
namespace ostraka::ui {

QStringList doubtsOf(const capture::ShotCheck& check);
/// Photographs that are kept with a problem are named one by one.
QStringList doubtsOf(const capture::SideCheck& check);
/// counted: by a person, 0: not; empty: no doubt.
QString countDoubt(const capture::SideCheck& check, int counted);
QStringList doubtsBetween(const capture::SideCheck& front, const capture::SideCheck& back);

}  // namespace ostraka::ui
