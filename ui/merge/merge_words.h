#pragma once
#include <QString>
#include <string>
#include <vector>

#include "merge/merge.h"

namespace ostraka::ui {

class TermWords;

/// What a conflict is about: "sherd ARM1-T3-0012-0007", and its field, "ware".
QString recordWords(const merge::Conflict& conflict);
QString fieldWords(const merge::Conflict& conflict);
/// What a project has, in the language's form, and below it who entered it when.
QString versionWords(const merge::Conflict& conflict, const merge::Version& version,
                     const TermWords& terms);
/// What came, or would come: counts of sherds, batches, records and files.
QString countWords(const merge::MergeReport& report);
/// Of files and folders that a completed merge left as they were changed here; empty: none.
QString keptWords(const std::vector<std::string>& kept);

}  // namespace ostraka::ui
