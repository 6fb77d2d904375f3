#pragma once
#include <string>
#include <vector>

#include "records/sherd.h"

namespace ostraka::records {

struct StartingVocabulary {
  std::string name;  ///< part, surface, ...
  std::vector<Term> terms;
};

/// What a new project describes its sherds with, with labels in the window's languages; its people
/// change it in the settings.
const std::vector<StartingVocabulary>& startingVocabularies();

}  // namespace ostraka::records
