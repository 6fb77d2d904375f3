#pragma once
#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include "capture/label_code.h"
#include "ui/import/import_sides.h"
#include "ui/import/place_text.h"

namespace ostraka::ui {

/// What the labels of bags say that lie in the photographs of an import.
struct SideLabels {
  std::vector<PlaceText> front, back;  ///< each bag once

  /// The one bag that every label names; nothing where there is no label, or several bags.
  std::optional<PlaceText> bag() const;
  /// What a person should know of them who says that the sherds are from `place`, which may be
  /// empty; empty where nothing speaks against it.
  QString doubt(const PlaceText& place) const;
};

/// seen: of photographs of both sides. reader understands the text of a code.
SideLabels labelsOf(const std::vector<capture::PhotographCodes>& seen, const ImportSides& sides,
                    const std::function<std::optional<PlaceText>(const QString&)>& reader);

}  // namespace ostraka::ui
