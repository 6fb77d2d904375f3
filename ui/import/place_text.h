#pragma once
#include <QString>
#include <QStringList>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "base/result.h"

namespace ostraka::catalogue {
class Catalogue;
}  // namespace ostraka::catalogue

namespace ostraka::records {
struct Provenance;
}  // namespace ostraka::records

namespace ostraka::ui {

/// Where the sherds on the plate come from, as typed or scanned from a bag's label.
struct PlaceText {
  QString site, trench, context, bag;
  bool operator==(const PlaceText&) const = default;
  bool isEmpty() const { return site.isEmpty() && context.isEmpty() && bag.isEmpty(); }
  /// "ARM1 / T3 / 0012 bag 4".
  QString words() const;
  /// As a person types it: "ARM1-T3-0012-4".
  QString typed() const;
  /// Both name a site, a trench, a context or a bag, and not the same one.
  bool differsFrom(const PlaceText& other) const;
};

/// Reads "ARM1-T3-0012-4", "ARM1 / T3 / 0012 bag 4" and the text of a bag's QR code,
/// "OST1:B:ARM1-T3-0012-4:7F3K9Q2M". Nothing when it is none of them.
std::optional<PlaceText> readPlaceText(const QString& text);

/// The same, by what the project knows: a label leads to the bag that carries it whatever its codes
/// are by now, and codes that have marks themselves (AR-TS) are recognised, in any capitals.
std::optional<PlaceText> findPlaceText(const catalogue::Catalogue& catalogue, const QString& text);

/// The bags whose labels are among these QR codes, each once, in order of their words. `reader`
/// understands the text of a code.
std::vector<PlaceText> bagsOn(
    const QStringList& codes,
    const std::function<std::optional<PlaceText>(const QString&)>& reader);

/// The same in words, one after the other.
QString wordsOf(const std::vector<PlaceText>& places);

/// The code of the project's site, the first of several; empty where there is none yet.
QString siteOf(const catalogue::Catalogue& catalogue);

/// What of a place the project does not know yet and would make: "site XX, trench 9, context 12,
/// bag 4". Empty when it knows all.
QString newOf(const catalogue::Catalogue& catalogue, const PlaceText& place);

/// The row of the bag, made with its context, trench and site where they are new; 0 and no error
/// when nothing was given.
Result<std::int64_t> bagRowOf(catalogue::Catalogue& catalogue, const PlaceText& place,
                              const records::Provenance& provenance);

}  // namespace ostraka::ui
