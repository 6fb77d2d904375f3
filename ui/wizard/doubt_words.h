#pragma once
#include <QStringList>

#include "capture/sequence.h"

/// What the checks of a capture found, in the person's language.
namespace ostraka::ui {

QStringList doubtsOf(const std::vector<Message>& sentences);
/// counted: by a person, 0: not; empty: no doubt.
QString countDoubt(const capture::SideCheck& check, int counted);

}  // namespace ostraka::ui
