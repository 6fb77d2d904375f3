// The files of Qt Linguist: every text is there in every language, with the places for values of
// the source.
#include <QDirIterator>
#include <QFile>
#include <QHash>
#include <QKeySequence>
#include <QRegularExpression>
#include <QSet>
#include <QXmlStreamReader>
#include <QtTest>

#include "tests/ui/program.h"

namespace {

struct TranslatedText {
  QString context, source;
  QStringList forms;
  bool unfinished = false;
};

QList<TranslatedText> messagesOf(const QString& language) {
  QFile file(QStringLiteral(OSTRAKA_TRANSLATIONS "/ostraka_%1.ts").arg(language));
  if (!file.open(QIODevice::ReadOnly)) qFatal("%s", qPrintable(file.fileName()));
  QXmlStreamReader xml(&file);
  QList<TranslatedText> messages;
  QString context;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    const auto name = xml.name();
    if (name == QLatin1String("name")) context = xml.readElementText();
    if (name == QLatin1String("message")) messages.append(TranslatedText{context, {}, {}, false});
    if (name == QLatin1String("source")) messages.last().source = xml.readElementText();
    if (name == QLatin1String("numerusform")) messages.last().forms << xml.readElementText();
    if (name == QLatin1String("translation")) {
      messages.last().unfinished =
          xml.attributes().value(QLatin1String("type")) == QLatin1String("unfinished");
      xml.readNext();
      if (xml.isCharacters() && !xml.isWhitespace()) messages.last().forms << xml.text().toString();
    }
  }
  return messages;
}

QStringList placesIn(const QString& text) {
  static const QRegularExpression place(QStringLiteral("%(\\d|n)"));
  QStringList places;
  for (auto at = place.globalMatch(text); at.hasNext();) places << at.next().captured();
  places.sort();
  return places;
}

bool isKey(const QString& name) {
  const QKeySequence key(name);
  return !key.isEmpty() && key[0].key() != Qt::Key_unknown;
}

}  // namespace

class TranslationsTest : public QObject {
  Q_OBJECT

 private slots:
  void languages_data() {
    QTest::addColumn<QString>("language");
    for (const char* language : {"de", "fr", "es", "el", "tr", "hy"})
      QTest::newRow(language) << language;
  }

  // Bold in the manual: a key, what is typed, or a text of the window as it stands there.
  void theManualCallsButtonsByTheirNames() {
    static const QRegularExpression bold(QStringLiteral("<b>([^<]*)</b>"));
    static const QRegularExpression words(QStringLiteral("^[A-Z][a-z][^+]*$"));
    static const QRegularExpression end(QStringLiteral("[…:.]+$"));
    QSet<QString> texts;
    for (const TranslatedText& message : messagesOf(QStringLiteral("de")))
      texts << QString(message.source).remove(QLatin1Char('&')).remove(end);
    int names = 0;
    QDirIterator pages(QStringLiteral(OSTRAKA_SOURCES "/../resources/manual"),
                       {QStringLiteral("*.html")});
    while (pages.hasNext()) {
      QFile page(pages.next());
      QVERIFY(page.open(QIODevice::ReadOnly));
      const QString html = QString::fromUtf8(page.readAll());
      for (auto at = bold.globalMatch(html); at.hasNext();) {
        const QString name = at.next().captured(1).remove(end);
        if (!words.match(name).hasMatch() || isKey(name)) continue;
        ++names;
        QVERIFY2(texts.contains(name), qPrintable(pages.fileName() + ": " + name));
      }
    }
    QVERIFY(names > 15);
  }

  void everyTextIsTranslatedInAllItsForms_data() { languages_data(); }
  void everyTextIsTranslatedInAllItsForms() {
    QFETCH(QString, language);
    const QList<TranslatedText> messages = messagesOf(language);
    QVERIFY(messages.size() > 500);
    for (const TranslatedText& message : messages) {
      const int wanted = message.source.contains(QLatin1String("%n")) && language != "tr" ? 2 : 1;
      QVERIFY2(!message.unfinished && message.forms.size() == wanted,
               qPrintable(message.context + ": " + message.source));
      for (const QString& form : message.forms)
        QVERIFY2(!form.trimmed().isEmpty(), qPrintable(message.source));
    }
  }

  void englishHasOneAndManyOfEachCount() {
    const QList<TranslatedText> messages = messagesOf(QStringLiteral("en"));
    QSet<QString> known;
    for (const TranslatedText& message : messages) {
      known << message.context + message.source;
      QVERIFY2(!message.unfinished && message.forms.size() == 2, qPrintable(message.source));
      for (const QString& form : message.forms)
        QVERIFY2(!form.contains(QLatin1String("(s)")) && !form.contains(QLatin1String("(es)")),
                 qPrintable(form));
    }
    int counts = 0;
    for (const TranslatedText& message : messagesOf(QStringLiteral("de"))) {
      if (!message.source.contains(QLatin1String("%n"))) continue;
      ++counts;
      QVERIFY2(known.contains(message.context + message.source), qPrintable(message.source));
    }
    QVERIFY(counts > 20);
  }

  // Within one page a letter calls one control; whoever has a letter in English has one here.
  void theLettersOfAPageAreItsOwn_data() { languages_data(); }
  void theLettersOfAPageAreItsOwn() {
    QFETCH(QString, language);
    static const QRegularExpression letter(QStringLiteral("&([^& ])"));
    QHash<QString, QString> owners;
    for (const TranslatedText& message : messagesOf(language)) {
      const bool wanted = letter.match(message.source).hasMatch();
      const auto found = letter.match(message.forms.value(0));
      QVERIFY2(wanted == found.hasMatch(), qPrintable(message.source));
      if (!wanted) continue;
      const QString key = message.context + found.captured(1).toLower();
      QVERIFY2(!owners.contains(key),
               qPrintable(message.source + " and " + owners.value(key) + ": " + key));
      owners.insert(key, message.source);
    }
  }

  // A text that is looked up under a name that no file has would stay English in all languages.
  void theNamesThatTextsAreLookedUpUnderAreThere() {
    QSet<QString> known;
    for (const TranslatedText& message : messagesOf(QStringLiteral("de")))
      known << message.context << message.context + message.source;
    static const QRegularExpression asked(
        QStringLiteral("translate\\(\\s*\"([^\"]+)\"|TRANSLATE_NOOP\\(\"([^\"]+)\""));
    // With its text, in one literal or in several.
    static const QRegularExpression whole(
        QStringLiteral("translate\\(\\s*\"([^\"]+)\",\\s*((?:\"[^\"\\\\]*\"\\s*)+)[,)]"));
    static const QRegularExpression seam(QStringLiteral("\"\\s*\""));
    int seen = 0;
    QDirIterator files(QStringLiteral(OSTRAKA_SOURCES), {QStringLiteral("*.cpp")}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
      QFile file(files.next());
      QVERIFY(file.open(QIODevice::ReadOnly));
      const QString source = QString::fromUtf8(file.readAll());
      for (auto at = asked.globalMatch(source); at.hasNext(); ++seen) {
        const auto found = at.next();
        const QString name = found.captured(1) + found.captured(2);
        QVERIFY2(known.contains(name), qPrintable(file.fileName() + ": " + name));
      }
      for (auto at = whole.globalMatch(source); at.hasNext();) {
        const auto found = at.next();
        const QString text = found.captured(2).trimmed().remove(seam);
        const QString words = text.mid(1, text.size() - 2);
        QVERIFY2(known.contains(found.captured(1) + words),
                 qPrintable(file.fileName() + ": " + words));
      }
    }
    QVERIFY(seen > 20);
  }

  // Platte is the marker plate, Drehtisch what turns it, Durchgang a batch, Datenträger a disk.
  void germanHasOneWordForPlateTurntableBatchAndDisk() {
    static const QRegularExpression other(
        QStringLiteral("\\b(teller|drehteller|markenteller|drehscheibe|festplatte|durchsicht|"
                       "ladung)(s|n|en)?\\b"),
        QRegularExpression::CaseInsensitiveOption);
    for (const TranslatedText& message : messagesOf(QStringLiteral("de")))
      for (const QString& form : message.forms) QVERIFY2(!form.contains(other), qPrintable(form));
  }

  void theValuesHaveTheirPlaces_data() { languages_data(); }
  void theValuesHaveTheirPlaces() {
    QFETCH(QString, language);
    for (const TranslatedText& message : messagesOf(language))
      for (const QString& form : message.unfinished ? QStringList() : message.forms) {
        QStringList wanted = placesIn(message.source), found = placesIn(form);
        wanted.removeAll(QStringLiteral("%n"));  // 'one' may be a word
        found.removeAll(QStringLiteral("%n"));
        QVERIFY2(wanted == found, qPrintable(message.source + " / " + form));
      }
  }
};

OSTRAKA_UI_TEST(TranslationsTest)
#include "translations_test.moc"
