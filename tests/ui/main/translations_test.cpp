// The files of Qt Linguist: what a person reads at the plate is there in every language, and the
// places for values are the same as in the source.
#include <QFile>
#include <QRegularExpression>
#include <QXmlStreamReader>
#include <QtTest>

namespace {

struct Message {
  QString context, source;
  QStringList forms;
  bool unfinished = false;
};

QList<Message> messagesOf(const QString& language) {
  QFile file(QStringLiteral(OSTRAKA_TRANSLATIONS "/ostraka_%1.ts").arg(language));
  if (!file.open(QIODevice::ReadOnly)) qFatal("%s", qPrintable(file.fileName()));
  QXmlStreamReader xml(&file);
  QList<Message> messages;
  QString context;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    const auto name = xml.name();
    if (name == QLatin1String("name")) context = xml.readElementText();
    if (name == QLatin1String("message")) messages.append(Message{context, {}, {}, false});
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

}  // namespace

class TranslationsTest : public QObject {
  Q_OBJECT

 private slots:
  void languages_data() {
    QTest::addColumn<QString>("language");
    for (const char* language : {"de", "fr", "es", "el", "tr", "hy"})
      QTest::newRow(language) << language;
  }

  void theWizardIsComplete_data() { languages_data(); }
  void theWizardIsComplete() {
    QFETCH(QString, language);
    int seen = 0;
    for (const Message& message : messagesOf(language)) {
      if (!message.context.startsWith(QLatin1String("ostraka::ui::Capture"))) continue;
      ++seen;
      const bool new_since = message.unfinished || message.forms.isEmpty();
      QVERIFY2(!new_since, qPrintable(message.source));
    }
    QVERIFY(seen > 50);
  }

  void theValuesHaveTheirPlaces_data() { languages_data(); }
  void theValuesHaveTheirPlaces() {
    QFETCH(QString, language);
    for (const Message& message : messagesOf(language))
      for (const QString& form : message.unfinished ? QStringList() : message.forms) {
        QStringList wanted = placesIn(message.source), found = placesIn(form);
        wanted.removeAll(QStringLiteral("%n"));  // 'one' may be a word
        found.removeAll(QStringLiteral("%n"));
        QVERIFY2(wanted == found, qPrintable(message.source + " / " + form));
      }
  }
};

QTEST_GUILESS_MAIN(TranslationsTest)
#include "translations_test.moc"
