#pragma once
#include <string>
#include <vector>

#include "catalogue/catalogue.h"
#include "records/sherd.h"
#include "tables/import_table.h"

namespace ostraka::exchange {

/// Whether a sherd's record from elsewhere (`from`: a name of the export) says what the project
/// says.
bool sameAs(const records::SherdRecord& sherd, const tables::ImportRow& row,
            const std::string& from, const catalogue::Catalogue& catalogue);

/// What a record says otherwise than the project does, as custom fields beside those of
/// the project: two laptops wrote about one sherd, and a person decides.
std::vector<records::FieldChange> otherVersion(const records::SherdRecord& sherd,
                                               const tables::ImportRow& row,
                                               const std::string& from);
/// What a person is told of it.
Message keepsItsOwn(const std::string& from);

}  // namespace ostraka::exchange
