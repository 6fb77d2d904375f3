#pragma once
#include <Qt>

namespace ostraka::ui {

/// What the rows of the review say about themselves, besides Qt's own roles.
struct CardRole {
  enum Of {
    Front = Qt::UserRole,
    Back,
    State,
    StateWord,
    FrontPicture,
    BackPicture,
    Words,
    SherdNumber,  ///< in the catalogue; may be empty
    Waits         ///< its pieces were joined or cut, and are others once the batch is computed
  };
};

}  // namespace ostraka::ui
