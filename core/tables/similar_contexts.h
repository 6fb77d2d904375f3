#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "base/result.h"
#include "catalogue/catalogue.h"
#include "catalogue/typed_place.h"

namespace ostraka::tables {

/// New contexts of a table that people read as existing ones: 12 beside 0012, since spreadsheets
/// leave out zeros.
class SimilarContexts {
 public:
  /// made: the place of a context that is new. Errors: of the catalogue.
  Result<void> note(const catalogue::Catalogue& catalogue, const catalogue::BagPlace& made);
  /// Nothing where none was noted.
  std::optional<Message> warning() const;

 private:
  std::vector<std::string> noted_;  ///< "12 (0012)", each once
};

}  // namespace ostraka::tables
