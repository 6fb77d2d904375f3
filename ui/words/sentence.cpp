#include "ui/words/sentence.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace ostraka::ui {
namespace {

QString written(const MessageValue& value) {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);  // as files and folders have numbers
  switch (value.kind) {
    case MessageValue::Kind::Text: {
      const std::string language = QLocale().name().section('_', 0, 0).toStdString();
      const auto own = value.translations.find(language);
      return QString::fromStdString(own == value.translations.end() ? value.text : own->second);
    }
    case MessageValue::Kind::Count:
      return locale.toString(static_cast<qlonglong>(value.count));
    case MessageValue::Kind::Decimal:
      return locale.toString(value.number.value, 'f', value.number.digits);
    case MessageValue::Kind::Message:
      return wordsOf(*value.message);
  }
  return {};
}

}  // namespace

QString wordsOf(const Message& message) {
  if (message.templateWords().empty()) return QString::fromStdString(message.english());
  const QString pattern =
      QCoreApplication::translate("ostraka::Error", message.templateWords().c_str());
  QString words;
  for (qsizetype at = 0; at < pattern.size(); ++at) {
    const int place = pattern[at] == QLatin1Char('%') && at + 1 < pattern.size()
                          ? pattern[at + 1].digitValue()
                          : -1;
    if (place < 1 || static_cast<std::size_t>(place) > message.values().size()) {
      words += pattern[at];
    } else {
      words += written(message.values()[static_cast<std::size_t>(place) - 1]);
      ++at;
    }
  }
  return words;
}

QStringList listOf(const std::vector<Message>& messages) {
  QStringList list;
  for (const Message& message : messages) list << wordsOf(message);
  return list;
}

QString wordsOf(const std::vector<Message>& messages) {
  return listOf(messages).join(QLatin1Char('\n'));
}

QString firstOf(const QStringList& names, qsizetype most) {
  const QString shown = names.mid(0, most).join(QStringLiteral(", "));
  return names.size() > most ? shown + QStringLiteral(", …") : shown;
}

QString sentenceOf(const Error& error) {
  return wordsOf(error.sentence());
}

}  // namespace ostraka::ui
