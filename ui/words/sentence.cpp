#include "ui/words/sentence.h"

#include <QRegularExpression>
#include <algorithm>
#include <vector>

#include "ui/words/core_sentences.h"
#include "ui/words/pattern.h"

namespace ostraka::ui {
namespace {

constexpr int kDeepest = 3;            // sentences within sentences
constexpr std::size_t kMostInOne = 8;  // parts of a text that are one sentence of the core

struct Known {
  const char* source;
  Pattern pattern;
};

// Those with most words of their own first: they say most exactly what is meant.
const std::vector<Known>& known() {
  static const std::vector<Known> kAll = [] {
    std::vector<Known> all;
    for (const Sentences& sentences : CoreSentences::all())
      for (const char* source : sentences)
        all.push_back({source, Pattern(QString::fromUtf8(source))});
    std::stable_sort(all.begin(), all.end(), [](const Known& a, const Known& b) {
      return a.pattern.letters() > b.pattern.letters();
    });
    return all;
  }();
  return kAll;
}

// Where one sentence ends and another begins; where it is said what a sentence is about.
const QRegularExpression& ends() {
  static const QRegularExpression kEnds(QStringLiteral("(?<=[.?!]) (?=[A-Z0-9'])"));
  return kEnds;
}
const QRegularExpression& endsOrNames() {
  static const QRegularExpression kEnds(ends().pattern() + QStringLiteral("|: |; "));
  return kEnds;
}

std::optional<QString> read(const QString& text, int depth);

enum class Values { OfOneSentence, Any };

std::optional<QString> readWhole(const QString& text, Values allowed, int depth) {
  for (const Known& one : known()) {
    std::optional<QStringList> values = one.pattern.valuesIn(text);
    if (!values) continue;
    if (allowed == Values::OfOneSentence && !values->filter(ends()).isEmpty()) continue;
    for (QString& value : *values) value = read(value, depth + 1).value_or(value);
    return filled(CoreSentences::tr(one.source), *values);
  }
  return std::nullopt;
}

// A name and what is said of it, or one sentence after another; of those some may be unknown.
std::optional<QString> readInParts(const QString& text, int depth) {
  std::vector<QRegularExpressionMatch> cuts;
  for (auto at = endsOrNames().globalMatch(text); at.hasNext();) cuts.push_back(at.next());
  QString all;
  bool any = false;
  qsizetype from = 0;
  for (std::size_t i = 0; i <= cuts.size();) {
    // As much as is known as one sentence, or else the one part as it is.
    std::size_t next = i + 1;
    QString words = text.mid(from, i < cuts.size() ? cuts[i].capturedStart() - from : -1);
    for (std::size_t j = std::min(cuts.size() + 1, i + kMostInOne); j-- > i;) {
      const QString part = text.mid(from, j < cuts.size() ? cuts[j].capturedStart() - from : -1);
      const auto read_part = readWhole(part, Values::OfOneSentence, depth);
      if (!read_part) continue;
      words = *read_part;
      next = j + 1;
      any = true;
      break;
    }
    all += words;
    if (next <= cuts.size()) {
      all += cuts[next - 1].captured();
      from = cuts[next - 1].capturedEnd();
    }
    i = next;
  }
  return any ? std::optional(all) : std::nullopt;
}

std::optional<QString> read(const QString& text, int depth) {
  if (depth > kDeepest) return std::nullopt;
  if (auto whole = readWhole(text, Values::OfOneSentence, depth)) return whole;
  if (auto parts = readInParts(text, depth)) return parts;
  return readWhole(text, Values::Any, depth);
}

}  // namespace

QString wordsOf(const std::string& what) {
  const QString text = QString::fromStdString(what);
  return read(text, 0).value_or(text);
}

QString sentenceOf(const Error& error) {
  return error.where.empty() ? wordsOf(error.what)
                             : QStringLiteral("%1: %2").arg(QString::fromStdString(error.where),
                                                            wordsOf(error.what));
}

}  // namespace ostraka::ui
