#pragma once
#include <span>
#include <vector>

#include "base/result.h"
#include "catalogue/subject.h"
#include "records/records.h"
#include "records/sherd.h"

namespace ostraka::sherds {

/// Changes to the fields of sherds, one or many at once.
class SherdChanges : public catalogue::Subject {
 public:
  using catalogue::Subject::Subject;

  Result<std::vector<records::ChangePreview>> preview(std::span<const records::FieldChange>) const;
  /// All or nothing. Returns the changes that undo it, in the order to apply them; they expect the
  /// values that this call leaves. Errors: what the preview refuses, what it asks and nobody
  /// confirmed.
  Result<std::vector<records::FieldChange>> apply(std::span<const records::FieldChange>,
                                                  const records::Provenance&);
};

}  // namespace ostraka::sherds
