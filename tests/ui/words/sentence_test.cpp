// What core says is said in the person's language: the template translated, the values as the
// language writes them; and every template of core has its translations.
#include "ui/words/sentence.h"

#include <QCoreApplication>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QLocale>
#include <QRegularExpression>
#include <QSet>
#include <QTranslator>
#include <QXmlStreamReader>
#include <QtTest>

#include "tests/ui/program.h"

using namespace ostraka;
using namespace ostraka::ui;

namespace {

// Says what it was asked for in brackets, and the second place before the first.
class Brackets final : public QTranslator {
 public:
  QString translate(const char* context, const char* source, const char*, int) const override {
    const QString text = QString::fromUtf8(source);
    if (qstrcmp(context, "ostraka::Error") != 0 || text == QLatin1String("%1: %2")) return {};
    if (text == QLatin1String("The disk has only %1 MB left, this needs about %2 MB."))
      return QStringLiteral("[%2, %1]");
    return QLatin1Char('[') + text + QLatin1Char(']');
  }
  bool isEmpty() const override { return false; }
};

// As translations/messages.py reads them.
QSet<QString> templatesOfCore() {
  const QString literal = QStringLiteral("\"(?:[^\"\\\\\\n]|\\\\.)*\"");
  const QRegularExpression call(
      QStringLiteral("\\b(?:message|translatable<\\d>)\\(\\s*(%1(?:\\s*%1)*)").arg(literal));
  const QRegularExpression one(literal);
  QSet<QString> all;
  QDirIterator files(QStringLiteral(OSTRAKA_CORE), {QStringLiteral("*.cpp"), QStringLiteral("*.h")},
                     QDir::Files, QDirIterator::Subdirectories);
  while (files.hasNext()) {
    QFile file(files.next());
    if (!file.open(QIODevice::ReadOnly)) qFatal("%s", qPrintable(file.fileName()));
    const QString text = QString::fromUtf8(file.readAll());
    for (auto at = call.globalMatch(text); at.hasNext();) {
      QString words;
      const QString found = at.next().captured(1);
      for (auto piece = one.globalMatch(found); piece.hasNext();) {
        const QString quoted = piece.next().captured();
        words += quoted.mid(1, quoted.size() - 2);
      }
      all << words.replace(QLatin1String("\\\""), QLatin1String("\""))
                 .replace(QLatin1String("\\\\"), QLatin1String("\\"));
    }
  }
  return all;
}

QMap<QString, QString> translationsIn(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) qFatal("%s", qPrintable(path));
  QXmlStreamReader xml(&file);
  QString context, source;
  QMap<QString, QString> all;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QLatin1String("name")) context = xml.readElementText();
    if (xml.name() == QLatin1String("source")) source = xml.readElementText();
    if (xml.name() == QLatin1String("translation") && context == QLatin1String("ostraka::Error"))
      all[source] = xml.readElementText();
  }
  return all;
}

QStringList placesIn(const QString& text) {
  static const QRegularExpression kPlace(QStringLiteral("%[1-9]"));
  QSet<QString> places;
  for (auto at = kPlace.globalMatch(text); at.hasNext();) places << at.next().captured();
  QStringList sorted(places.begin(), places.end());
  sorted.sort();
  return sorted;
}

}  // namespace

class SentenceTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QVERIFY(QCoreApplication::installTranslator(&brackets_)); }
  void cleanup() {
    QCoreApplication::removeTranslator(&brackets_);
    QLocale::setDefault(QLocale::c());
  }

  void messagesAreSaidInTheLanguage() {
    QCOMPARE(wordsOf(Error::cancelled().what), QStringLiteral("[Cancelled.]"));
    QCOMPARE(wordsOf(Message("Nobody ever said this.")), QStringLiteral("Nobody ever said this."));
    QCOMPARE(wordsOf(message("The disk has only %1 MB left, this needs about %2 MB.", 3, 40)),
             QStringLiteral("[40, 3]"));
    QCOMPARE(sentenceOf(Error::unusable(message("It is set aside."), "camera B")),
             QStringLiteral("camera B: [It is set aside.]"));
    QCOMPARE(wordsOf(Message()), QString());
  }

  void messagesWithinMessagesAreSaidToo() {
    QCOMPARE(wordsOf(message("The file has an error (%1).", message("it is not open"))),
             QStringLiteral("[The file has an error ([it is not open]).]"));
    QCOMPARE(wordsOf(std::vector<Message>{message("It is set aside."), Message("own words")}),
             QStringLiteral("[It is set aside.]\nown words"));
  }

  void numbersAreWrittenAsTheLanguageDoes() {
    QLocale::setDefault(QLocale(QLocale::German));
    QCOMPARE(wordsOf(message("%1 mm of %2 in %3", decimal(0.25, 2), 12000, "0.25.png")),
             QStringLiteral("[0,25 mm of 12000 in 0.25.png]"));
  }

  void namesOfTheProjectAreSaidInTheLanguageThatHasThem() {
    MessageValue terms("rim, neck");
    terms.translations = {{"de", "Rand, Hals"}};
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Austria));
    QCOMPARE(wordsOf(message("one of %1", terms)), QStringLiteral("[one of Rand, Hals]"));
    QLocale::setDefault(QLocale(QLocale::French));
    QCOMPARE(wordsOf(message("one of %1", terms)), QStringLiteral("[one of rim, neck]"));
  }

  void valuesAreNotReadAsPlaces() {
    QCOMPARE(wordsOf(message("%2 and %1", "%2", "b")), QStringLiteral("[b and %2]"));
  }

  // Whoever adds a message to core adds its translations; see translations/update.sh.
  void everyTemplateOfCoreIsTranslated() {
    const QSet<QString> templates = templatesOfCore();
    QVERIFY(templates.size() > 500);
    int files = 0;
    QDirIterator ts(QStringLiteral(OSTRAKA_TRANSLATIONS), {QStringLiteral("*.ts")}, QDir::Files);
    while (ts.hasNext()) {
      const QString path = ts.next();
      if (path.endsWith(QLatin1String("_en.ts"))) continue;  // plurals alone
      ++files;
      const QMap<QString, QString> known = translationsIn(path);
      QStringList wrong;
      for (const QString& source : templates)
        if (known.value(source).isEmpty() || placesIn(known.value(source)) != placesIn(source))
          wrong << source;
      for (auto at = known.begin(); at != known.end(); ++at)
        if (!templates.contains(at.key())) wrong << QStringLiteral("not in core: ") + at.key();
      QVERIFY2(wrong.isEmpty(), qPrintable(path + "\n" + wrong.join(QLatin1Char('\n'))));
    }
    QCOMPARE(files, 6);
  }

 private:
  Brackets brackets_;
};

OSTRAKA_UI_TEST(SentenceTest)
#include "sentence_test.moc"
