#pragma once
#include <QString>
#include <QStringList>
#include <optional>

namespace ostraka::ui {

/// A sentence with places: "%1 of the %2 photographs show no marker.". Of the places each number
/// stands once, in order.
class Pattern {
 public:
  explicit Pattern(const QString& source);

  /// The values in the places if the text is such a sentence; none of them is empty. Of several
  /// ways to read it, the one whose first values are shortest.
  std::optional<QStringList> valuesIn(const QString& text) const;
  int letters() const { return letters_; }  ///< of its fixed words

 private:
  QStringList pieces_;  // before, between and behind the places
  int letters_ = 0;
};

/// A sentence with its values. In another language the places may stand in another order.
QString filled(const QString& pattern, const QStringList& values);

}  // namespace ostraka::ui
