#pragma once
#include <vector>

#include "records/sherd.h"
#include "store/database.h"

namespace ostraka::sherds {

/// For filter_sql.cpp: rows that come by number put into another order. What is not recorded comes
/// last, whichever way the order goes; ties go by number. The order's values come from an index in
/// one sweep over all sherds, so this pays for many rows. Throws Refused for a field that orders
/// nothing.
std::vector<store::SherdRow> inOrder(store::Database& database,
                                     const std::vector<store::SherdRow>& by_number,
                                     const records::SherdOrder& order);

}  // namespace ostraka::sherds
