#include "ui/capture/place_text.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>

#include "catalogue/catalogue.h"

namespace ostraka::ui {
namespace {

using namespace catalogue;

Result<TrenchRow> trenchOf(Catalogue& rows, SiteRow site, const std::string& code, const Act& act) {
  if (code.empty()) return TrenchRow{};
  const auto known = rows.trenches();
  if (!known) return known.error();
  const auto at = std::find_if(known->begin(), known->end(), [&](const TrenchRecord& trench) {
    return trench.site == site && trench.code == code;
  });
  if (at != known->end()) return at->row;
  TrenchRecord fresh;
  fresh.site = site;
  fresh.code = code;
  return rows.save(fresh, act);
}

Result<SiteRow> siteOf(Catalogue& rows, const std::string& code, const Act& act) {
  const auto known = rows.sites();
  if (!known) return known.error();
  const auto at = std::find_if(known->begin(), known->end(),
                               [&](const SiteRecord& site) { return site.code == code; });
  if (at != known->end()) return at->row;
  SiteRecord fresh;
  fresh.code = fresh.name = code;
  return rows.save(fresh, act);
}

Result<ContextRow> contextOf(Catalogue& rows, SiteRow site, TrenchRow trench,
                             const std::string& number, const Act& act) {
  const auto known = rows.contexts();
  if (!known) return known.error();
  const auto at = std::find_if(known->begin(), known->end(), [&](const ContextRecord& context) {
    return context.site == site && context.trench == trench && context.number == number;
  });
  if (at != known->end()) return at->row;
  ContextRecord fresh;
  fresh.site = site;
  fresh.trench = trench;
  fresh.number = number;
  return rows.save(fresh, act);
}

}  // namespace

QString PlaceText::words() const {
  QStringList parts;
  for (const QString& part : {site, trench, context})
    if (!part.isEmpty()) parts << part;
  const QString all = parts.join(QStringLiteral(" / "));
  if (bag.isEmpty()) return all;
  return QCoreApplication::translate("PlaceText", "%1 bag %2").arg(all, bag);
}

QString PlaceText::typed() const {
  QStringList parts{site, trench, context, bag};
  parts.removeAll(QString());
  return parts.join(QLatin1Char('-'));
}

std::optional<PlaceText> readPlaceText(const QString& text) {
  QString plain = text.trimmed();
  if (plain.startsWith(QLatin1String("OST1:"))) {
    const QStringList parts = plain.split(QLatin1Char(':'));
    if (parts.size() < 3 || parts[1] != QLatin1String("B")) return {};
    plain = parts[2];
  }
  static const QRegularExpression between(QStringLiteral("\\s*[-/]\\s*|\\s+bag\\s+|\\s+"),
                                          QRegularExpression::CaseInsensitiveOption);
  const QStringList parts = plain.split(between, Qt::SkipEmptyParts);
  if (parts.size() == 4) return PlaceText{parts[0], parts[1], parts[2], parts[3]};
  if (parts.size() == 3) return PlaceText{parts[0], {}, parts[1], parts[2]};
  return {};
}

Result<std::int64_t> bagRowOf(Catalogue& rows, const PlaceText& place, const Act& act) {
  if (place.isEmpty()) return std::int64_t{0};
  if (place.site.isEmpty() || place.context.isEmpty() || place.bag.isEmpty())
    return Error{ErrorCode::UnusableInput,
                 QCoreApplication::translate(
                     "PlaceText",
                     "A site, a context and a bag are needed so that the sherds can be numbered.")
                     .toStdString(),
                 {}};
  const auto site = siteOf(rows, place.site.toStdString(), act);
  if (!site) return site.error();
  const auto trench = trenchOf(rows, *site, place.trench.toStdString(), act);
  if (!trench) return trench.error();
  const auto context = contextOf(rows, *site, *trench, place.context.toStdString(), act);
  if (!context) return context.error();
  const auto known = rows.bags(*context);
  if (!known) return known.error();
  const std::string number = place.bag.toStdString();
  const auto at = std::find_if(known->begin(), known->end(),
                               [&](const BagRecord& bag) { return bag.number == number; });
  if (at != known->end()) return at->row.value;
  BagRecord fresh;
  fresh.context = *context;
  fresh.number = number;
  const auto saved = rows.save(fresh, act);
  if (!saved) return saved.error();
  return saved->value;
}

}  // namespace ostraka::ui
