#include "ui/frame/term_words.h"

#include <QLocale>

#include "catalogue/catalogue.h"
#include "catalogue/settings.h"
#include "sherds/sherd_fields.h"

namespace ostraka::ui {

QString termLabel(const records::Term& term) {
  const QString language = QLocale().name().section(QLatin1Char('_'), 0, 0);
  const auto label = term.labels.find(language.toStdString());
  return QString::fromStdString(label == term.labels.end() ? term.term : label->second);
}

void TermWords::read(const catalogue::Catalogue& catalogue) {
  labels_.clear();
  in_order_.clear();
  for (const records::SherdField& field : sherds::sherdFields()) {
    const QString name = QString::fromLatin1(field.vocabulary);
    if (name.isEmpty() || labels_.contains(name)) continue;
    const auto terms = catalogue::Settings(catalogue).vocabulary(field.vocabulary);
    if (!terms) continue;
    for (const records::Term& term : *terms) {
      const QString label = termLabel(term);
      labels_[name].insert(QString::fromStdString(term.term), label);
      in_order_[name] << label;
    }
  }
}

QString TermWords::shown(const records::SherdField& field, const QString& text) const {
  const auto labels = labels_.constFind(QString::fromLatin1(field.vocabulary));
  if (labels == labels_.constEnd() || text.isEmpty()) return text;
  QStringList words;
  for (const QString& term : text.split(QStringLiteral("; "))) words << labels->value(term, term);
  return words.join(QStringLiteral("; "));
}

QString TermWords::shown(const std::string& field, const std::string& text) const {
  const records::SherdField* known = sherds::sherdField(field);
  const QString words = QString::fromStdString(text);
  return known == nullptr ? words : shown(*known, words);
}

QStringList TermWords::of(const records::SherdField& field) const {
  return in_order_.value(QString::fromLatin1(field.vocabulary));
}

}  // namespace ostraka::ui
