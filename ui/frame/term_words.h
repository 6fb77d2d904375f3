#pragma once
#include <QHash>
#include <QString>
#include <QStringList>

#include "records/sherd.h"

namespace ostraka::catalogue {
class Catalogue;
}

namespace ostraka::ui {

/// What a term is called in the window's language; the term itself where it has no label in it.
QString termLabel(const records::Term& term);

/// The terms of a project's vocabularies as the window calls them. What is stored stays the term;
/// the catalogue takes labels for it, so that what is shown may be typed.
class TermWords {
 public:
  void read(const catalogue::Catalogue& catalogue);
  /// text: of a field, "rim; neck" for several terms. Fields without a vocabulary stay as they are.
  QString shown(const records::SherdField& field, const QString& text) const;
  QString shown(const std::string& field, const std::string& text) const;
  QStringList of(const records::SherdField& field) const;

 private:
  QHash<QString, QHash<QString, QString>> labels_;  ///< vocabulary -> term -> label
  QHash<QString, QStringList> in_order_;            ///< vocabulary -> labels
};

}  // namespace ostraka::ui
