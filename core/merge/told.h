#pragma once
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "merge/content.h"

namespace ostraka::merge {

/// What rows of the history told of the members of sets: by member, whether it was added or taken
/// away last.
using Told = std::map<std::pair<std::string, std::string>, bool>;

/// Of a field that is a set, as "rim; neck": what the event added (true) and what it took away.
void tellMembers(const Event& event, const std::function<void(const std::string&, bool)>& tell);

/// One history took it away since both were one, and the other did not add it again.
bool isGone(const Told& here, const Told& there, const std::pair<std::string, std::string>& member);

}  // namespace ostraka::merge
