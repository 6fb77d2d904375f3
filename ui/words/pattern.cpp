#include "ui/words/pattern.h"

#include <QRegularExpression>

namespace ostraka::ui {
namespace {

const QRegularExpression& place() {
  static const QRegularExpression kPlace(QStringLiteral("%([1-9])"));
  return kPlace;
}

}  // namespace

Pattern::Pattern(const QString& source) : pieces_(source.split(place())) {
  for (const QString& piece : pieces_) letters_ += static_cast<int>(piece.size());
}

std::optional<QStringList> Pattern::valuesIn(const QString& text) const {
  if (pieces_.size() == 1)
    return text == pieces_.front() ? std::optional(QStringList()) : std::nullopt;
  const qsizetype end = text.size() - pieces_.back().size();
  if (!text.startsWith(pieces_.front()) || !text.endsWith(pieces_.back())) return std::nullopt;
  QStringList values;
  qsizetype at = pieces_.front().size();
  for (qsizetype i = 1; i < pieces_.size(); ++i) {
    const bool last = i + 1 == pieces_.size();
    const qsizetype next = last ? end : text.indexOf(pieces_[i], at + 1);
    if (next <= at || next > end) return std::nullopt;
    values << text.mid(at, next - at);
    at = next + pieces_[i].size();
  }
  return values;
}

QString filled(const QString& pattern, const QStringList& values) {
  QString text;
  qsizetype done = 0;
  for (auto at = place().globalMatch(pattern); at.hasNext();) {
    const auto found = at.next();
    text += pattern.mid(done, found.capturedStart() - done);
    text += values.value(found.captured(1).toInt() - 1);
    done = found.capturedEnd();
  }
  return text + pattern.mid(done);
}

}  // namespace ostraka::ui
