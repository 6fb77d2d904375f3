#include "ui/import/place_text.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <map>
#include <utility>

#include "catalogue/label_codes.h"
#include "catalogue/places.h"
#include "catalogue/typed_place.h"
#include "store/names.h"

namespace ostraka::ui {
namespace {

using catalogue::Catalogue;

// Of what is typed, and of a code or number that has such marks itself.
QStringList partsOf(const QString& text) {
  static const QRegularExpression between(QStringLiteral("\\s*[-/]\\s*|\\s+bag\\s+|\\s+"),
                                          QRegularExpression::CaseInsensitiveOption);
  return text.trimmed().split(between, Qt::SkipEmptyParts);
}

// Two marks with nothing between them: "VIRT-T1--3".
bool lacksAPart(const QString& text) {
  static const QRegularExpression gap(QStringLiteral("[-/]\\s*[-/]|^\\s*[-/]|[-/]\\s*$"));
  return gap.match(text).hasMatch();
}

QStringList partsOf(const std::string& text) {
  return partsOf(QString::fromStdString(text));
}

bool isSame(const QString& a, const QString& b) {
  return store::codeKey(a.toStdString()) == store::codeKey(b.toStdString());
}

bool beginWith(const QStringList& typed, const QStringList& start) {
  return !start.isEmpty() && typed.size() > start.size() &&
         std::equal(start.begin(), start.end(), typed.begin(), isSame);
}

PlaceText placeText(const catalogue::BagPlace& place) {
  return {QString::fromStdString(place.site), QString::fromStdString(place.trench),
          QString::fromStdString(place.context), QString::fromStdString(place.bag)};
}

std::optional<PlaceText> inKnownSite(const Catalogue& rows, const QStringList& typed) {
  const auto sites = catalogue::Places(rows).sites();
  if (!sites) return {};
  std::optional<PlaceText> found;
  qsizetype longest = 1;  // a site's code of one part is read without knowing it
  for (const records::SiteRecord& site : *sites) {
    const QStringList start = partsOf(site.code), rest = typed.mid(start.size());
    if (start.size() <= longest || !beginWith(typed, start) || rest.size() < 2 || rest.size() > 3)
      continue;
    longest = start.size();
    found = PlaceText{QString::fromStdString(site.code), rest.size() == 3 ? rest[0] : QString(),
                      rest[rest.size() - 2], rest.back()};
  }
  return found;
}

bool isSiteCode(const QString& text) {
  static const QRegularExpression form(QStringLiteral("^(?=.*[\\p{Lu}0-9])[\\p{L}0-9]{2,8}$"));
  return form.match(text).hasMatch();
}

bool isKnownSite(const Catalogue& rows, const QString& code) {
  const auto sites = catalogue::Places(rows).sites();
  return sites && std::any_of(sites->begin(), sites->end(), [&](const auto& site) {
           return isSame(QString::fromStdString(site.code), code);
         });
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

bool PlaceText::differsFrom(const PlaceText& other) const {
  const auto differ = [](const QString& one, const QString& another) {
    return !one.isEmpty() && !another.isEmpty() && !isSame(one, another);
  };
  return differ(site, other.site) || differ(trench, other.trench) ||
         differ(context, other.context) || differ(bag, other.bag);
}

std::vector<PlaceText> bagsOn(
    const QStringList& codes,
    const std::function<std::optional<PlaceText>(const QString&)>& reader) {
  std::map<QString, PlaceText> bags;
  for (const QString& code : codes)
    if (code.startsWith(QLatin1String("OST1:")))
      if (const auto place = reader(code)) bags.emplace(place->words(), *place);
  std::vector<PlaceText> each;
  for (auto& [words, place] : bags) each.push_back(std::move(place));
  return each;
}

QString wordsOf(const std::vector<PlaceText>& places) {
  QStringList words;
  for (const PlaceText& place : places) words << place.words();
  return words.join(QStringLiteral(", "));
}

std::optional<PlaceText> readPlaceText(const QString& text) {
  QString plain = text;
  if (plain.trimmed().startsWith(QLatin1String("OST1:"), Qt::CaseInsensitive)) {
    const auto label = catalogue::readLabelCode(text.toStdString());
    if (!label || label->of != catalogue::LabelCode::Of::Bag) return {};
    plain = QString::fromStdString(label->number);
  }
  if (lacksAPart(plain)) return {};
  const QStringList parts = partsOf(plain);
  if (parts.size() == 4) return PlaceText{parts[0], parts[1], parts[2], parts[3]};
  if (parts.size() == 3) return PlaceText{parts[0], {}, parts[1], parts[2]};
  return {};
}

std::optional<PlaceText> findPlaceText(const Catalogue& rows, const QString& text) {
  QString plain = text;
  if (const auto label = catalogue::readLabelCode(text.toStdString())) {
    if (label->of != catalogue::LabelCode::Of::Bag) return {};
    if (const auto known = catalogue::placeOfLabel(rows, *label); known && *known)
      return placeText(**known);
    plain = QString::fromStdString(label->number);
  }
  if (lacksAPart(plain)) return {};
  const QStringList typed = partsOf(plain);
  if (const auto known = catalogue::typedPlace(rows, plain.toStdString(), catalogue::Named::Bag);
      known && *known)
    return placeText(**known);
  if (auto known = inKnownSite(rows, typed)) return known;
  auto read = readPlaceText(plain);
  // Words of a sentence are no place: a site that is new has a code as new projects have.
  if (read && !isSiteCode(read->site) && !isKnownSite(rows, read->site)) return {};
  return read;
}

QString siteOf(const Catalogue& rows) {
  const auto sites = catalogue::Places(rows).sites();
  return sites && !sites->empty() ? QString::fromStdString(sites->front().code) : QString();
}

QString newOf(const Catalogue& rows, const PlaceText& place) {
  if (place.isEmpty()) return {};
  const auto words = [](const char* form, const QString& value) {
    return QCoreApplication::translate("PlaceText", form).arg(value);
  };
  const auto is = [](const std::string& known, const QString& typed) {
    return isSame(QString::fromStdString(known), typed);
  };
  bool site = false, trench = place.trench.isEmpty(), context = false, bag = false;
  if (const auto sites = catalogue::Places(rows).sites())
    for (const records::SiteRecord& known : *sites) {
      if (!is(known.code, place.site)) continue;
      site = true;
      if (const auto trenches = catalogue::Places(rows).trenches())
        for (const records::TrenchRecord& one : *trenches)
          trench = trench || (one.site == known.row && is(one.code, place.trench));
    }
  if (const auto contexts = catalogue::Places(rows).contexts())
    for (const records::ContextRecord& known : *contexts) {
      if (!is(known.site_code, place.site) || !is(known.trench_code, place.trench) ||
          !is(known.number, place.context))
        continue;
      context = true;
      if (const auto bags = catalogue::Places(rows).bags(known.row))
        for (const records::BagRecord& one : *bags) bag = bag || is(one.number, place.bag);
    }
  QStringList fresh;
  if (!site) fresh << words(QT_TRANSLATE_NOOP("PlaceText", "site %1"), place.site);
  if (!trench) fresh << words(QT_TRANSLATE_NOOP("PlaceText", "trench %1"), place.trench);
  if (!context) {
    const auto alike = catalogue::contextReadAlike(
        rows,
        {place.site.toStdString(), place.trench.toStdString(), place.context.toStdString(), {}});
    fresh << (alike && !alike->empty()
                  ? QCoreApplication::translate("PlaceText", "context %1, although %2 exists")
                        .arg(place.context, QString::fromStdString(*alike))
                  : words(QT_TRANSLATE_NOOP("PlaceText", "context %1"), place.context));
  }
  if (!bag) fresh << words(QT_TRANSLATE_NOOP("PlaceText", "bag %1"), place.bag);
  return fresh.join(QStringLiteral(", "));
}

Result<std::int64_t> bagRowOf(Catalogue& rows, const PlaceText& place,
                              const records::Provenance& provenance) {
  if (place.isEmpty()) return std::int64_t{0};
  if (place.site.isEmpty() || place.context.isEmpty() || place.bag.isEmpty())
    return Error{ErrorCode::UnusableInput,
                 QCoreApplication::translate(
                     "PlaceText",
                     "A site, a context and a bag are needed so that the sherds can be numbered.")
                     .toStdString(),
                 {}};
  const auto row = catalogue::bagAt(rows,
                                    {place.site.toStdString(), place.trench.toStdString(),
                                     place.context.toStdString(), place.bag.toStdString()},
                                    provenance);
  if (!row) return row.error();
  return row->value;
}

}  // namespace ostraka::ui
