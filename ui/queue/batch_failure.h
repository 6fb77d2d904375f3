#pragma once
#include <QString>
#include <optional>

#include "base/result.h"
#include "records/records.h"

namespace ostraka::catalogue {
class Catalogue;
}

namespace ostraka::ui {

/// Why a batch is computed no further. Kept as what happened, and worded in the language of who
/// reads it.
struct BatchFailure {
  Error error = {};                             ///< where nobody asked for it
  bool cancelled = false;                       ///< a person stopped it
  bool removed = false;                         ///< cancelled: it only waited
  bool aside = false;                           ///< cancelled: nobody wants it
  std::optional<records::BatchState> was = {};  ///< aside: what it is when it is taken up again
};

BatchFailure keptFailure(const catalogue::Catalogue& rows, const QString& number);
Result<void> keepFailure(catalogue::Catalogue& rows, const QString& number,
                         const BatchFailure& failure);
Result<void> forgetFailure(catalogue::Catalogue& rows, const QString& number);
/// Whole sentences.
QString wordsOf(const BatchFailure& failure);

}  // namespace ostraka::ui
