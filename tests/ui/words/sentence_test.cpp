// What core says in English is read again by its pattern, and said in the person's language.
#include "ui/words/sentence.h"

#include <QCoreApplication>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QTranslator>
#include <QtTest>

#include "ui/words/core_sentences.h"
#include "ui/words/pattern.h"

using namespace ostraka;
using namespace ostraka::ui;

namespace {

// Says what it was asked for in brackets, and the second place before the first.
class Brackets final : public QTranslator {
 public:
  QString translate(const char* context, const char* source, const char*, int) const override {
    if (qstrcmp(context, "ostraka::Error") != 0) return {};
    const QString text = QString::fromUtf8(source);
    if (text == QLatin1String("The disk has only %1 MB left, this needs about %2 MB."))
      return QStringLiteral("[%2, %1]");
    return QLatin1Char('[') + text + QLatin1Char(']');
  }
  bool isEmpty() const override { return false; }
};

// The core's sources, but for folders that no window uses; each text in one piece.
QString coreSources(const QStringList& but_for = {}) {
  QString core;
  QDirIterator files(QStringLiteral(OSTRAKA_CORE), {QStringLiteral("*.cpp"), QStringLiteral("*.h")},
                     QDir::Files, QDirIterator::Subdirectories);
  while (files.hasNext()) {
    QFile file(files.next());
    if (but_for.contains(QFileInfo(file).dir().dirName())) continue;
    if (!file.open(QIODevice::ReadOnly)) qFatal("%s", qPrintable(file.fileName()));
    core += QString::fromUtf8(file.readAll());
  }
  static const QRegularExpression kBetween(QStringLiteral("\"\\s*\\n?\\s*\""));
  core.remove(kBetween);
  return core.replace(QStringLiteral("\\\""), QStringLiteral("\""));
}

std::vector<QString> known() {
  std::vector<QString> all;
  for (const Sentences& sentences : CoreSentences::all())
    for (const char* source : sentences) all.push_back(QString::fromUtf8(source));
  return all;
}

QString wordsAlone(QString text) {
  static const QRegularExpression kOthers(QStringLiteral("[^\\p{L}\\d]+"));
  return text.replace(kOthers, QStringLiteral(" ")).trimmed();
}

// Into how many parts a text must be cut so that each stands in the core; more than it has words
// if one of them does not stand there at all.
qsizetype runsInTheCore(const QString& text) {
  static const QString kCore = wordsAlone(coreSources());
  const QStringList words = wordsAlone(text).split(QLatin1Char(' '), Qt::SkipEmptyParts);
  qsizetype runs = 0;
  for (qsizetype from = 0; from < words.size(); ++runs) {
    qsizetype to = words.size();
    while (to > from && !kCore.contains(words.mid(from, to - from).join(QLatin1Char(' ')))) --to;
    if (to == from) return words.size() + 6;
    from = to;
  }
  return runs;
}

const QRegularExpression kPlace(QStringLiteral("%[1-9]"));

}  // namespace

class SentenceTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QVERIFY(QCoreApplication::installTranslator(&brackets_)); }
  void cleanup() { QCoreApplication::removeTranslator(&brackets_); }

  void aPatternReadsItsValues() {
    const Pattern pattern(QStringLiteral("%1 of the %2 photographs show no marker."));
    QCOMPARE(pattern.valuesIn(QStringLiteral("3 of the 24 photographs show no marker.")),
             std::optional(QStringList({QStringLiteral("3"), QStringLiteral("24")})));
    QVERIFY(!pattern.valuesIn(QStringLiteral(" of the 24 photographs show no marker.")));
    QVERIFY(!pattern.valuesIn(QStringLiteral("3 of the  photographs show no marker.")));
    QVERIFY(!pattern.valuesIn(QStringLiteral("3 of the 24 photographs show no markers.")));
    QVERIFY(!pattern.valuesIn(QString()));
  }

  // The end of the text belongs to the last words of the pattern, not to its places.
  void fixedWordsDoNotOverlap() {
    QVERIFY(!Pattern(QStringLiteral("ab%1ba")).valuesIn(QStringLiteral("aba")));
    QVERIFY(!Pattern(QStringLiteral("%1 mm to %2 mm")).valuesIn(QStringLiteral("3 mm to mm")));
    QCOMPARE(Pattern(QStringLiteral("%1 mm to %2")).valuesIn(QStringLiteral("3 mm to 4 mm to 5")),
             std::optional(QStringList({QStringLiteral("3"), QStringLiteral("4 mm to 5")})));
  }

  void valuesAreNotReadAsPlaces() {
    QCOMPARE(filled(QStringLiteral("%2 and %1"), {QStringLiteral("%2"), QStringLiteral("b")}),
             QStringLiteral("b and %2"));
  }

  void sentencesOfTheCoreAreSaidInTheLanguage() {
    QCOMPARE(wordsOf("Cancelled."), QStringLiteral("[Cancelled.]"));
    QCOMPARE(wordsOf("Nobody ever said this."), QStringLiteral("Nobody ever said this."));
    QCOMPARE(
        sentenceOf(Error::unusable("The camera stays busy; switch it off and on.", "camera B")),
        QStringLiteral("camera B: [The camera stays busy; switch it off and on.]"));
    QCOMPARE(wordsOf(""), QString());
  }

  void sentencesAreFoundBehindNamesAndBehindEachOther() {
    QCOMPARE(wordsOf("front/camA_003.png: The camera stays busy; switch it off and on."),
             QStringLiteral("front/camA_003.png: [The camera stays busy; switch it off and on.]"));
    QCOMPARE(wordsOf("Cancelled. Nobody ever said this. The camera is not plugged in."),
             QStringLiteral("[Cancelled.] Nobody ever said this. [The camera is not plugged in.]"));
    QCOMPARE(wordsOf("camera A: Cancelled.; camera B: Cancelled."),
             QStringLiteral("camera A: [Cancelled.]; camera B: [Cancelled.]"));
  }

  // Hours of log in one text cost no more than its length.
  void aLongUnknownTextStaysAsItIs() {
    std::string text;
    for (int i = 0; i < 200; ++i) text += "Nobody: said this. ";
    QCOMPARE(wordsOf(text), QString::fromStdString(text));
  }

  // Word for word, but for short words that the core puts between: a side, a count.
  void theyStandInTheCore() {
    QVERIFY(coreSources().size() > 1000000);
    for (const QString& source : known())
      for (const QString& piece : source.split(kPlace))
        QVERIFY2(runsInTheCore(piece) <= std::max<qsizetype>(5, piece.count(QLatin1Char(' ')) / 3),
                 qPrintable(source));
  }

  // Placed one behind the other, from 1.
  void theirPlacesAreInOrder() {
    for (const QString& source : known()) {
      QString wanted = source;
      for (int i = 1; wanted.contains(QStringLiteral("%%1").arg(i)); ++i)
        wanted.replace(QStringLiteral("%%1").arg(i), QStringLiteral("@"));
      QVERIFY2(!wanted.contains(kPlace), qPrintable(source));
      QCOMPARE(wanted.count(QLatin1Char('@')), source.count(kPlace));
    }
  }

  void noneIsTakenForAnother() {
    const QStringList values{"7", "12.5", "B0001", "camA_003.png", "9", "28", "A", "C", "42"};
    const std::vector<QString> all = known();
    QVERIFY(all.size() > 100);
    for (const QString& source : all) {
      const QString text = filled(source, values);
      QVERIFY2(wordsOf(text.toStdString()) ==
                   filled(QLatin1Char('[') + source + QLatin1Char(']'), values),
               qPrintable(source + " is read as " + wordsOf(text.toStdString())));
    }
  }

  // Whoever adds an error to core adds its words here; but for options, which no window sets.
  void everyFixedErrorOfTheCoreIsKnown() {
    static const QRegularExpression kError(
        QStringLiteral("(?:Error\\{\\s*ErrorCode::\\w+,|unusable\\()\\s*\"([^\"]+\\.)\"\\s*[,)]"));
    static const QRegularExpression kOfAnOption(QStringLiteral("^[a-z]|\\boptions:|--output"));
    int seen = 0;
    QStringList unknown;
    for (auto at = kError.globalMatch(coreSources(
             {QStringLiteral("evaluate"), QStringLiteral("api"), QStringLiteral("cluster")}));
         at.hasNext();) {
      const QString sentence = at.next().captured(1);
      if (sentence.contains(kOfAnOption)) continue;
      if (wordsOf(sentence.toStdString()) == sentence) unknown << sentence;
      ++seen;
    }
    QVERIFY(seen > 150);
    QVERIFY2(unknown.isEmpty(), qPrintable(unknown.join(QLatin1Char('\n'))));
  }

 private:
  Brackets brackets_;
};

QTEST_GUILESS_MAIN(SentenceTest)
#include "sentence_test.moc"
