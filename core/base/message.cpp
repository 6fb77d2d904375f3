#include "base/message.h"

#include "base/text.h"

namespace ostraka {

MessageValue::MessageValue(const Message& words)
    : kind(Kind::Message), message(std::make_shared<const Message>(words)) {}

std::string MessageValue::english() const {
  switch (kind) {
    case Kind::Text:
      return text;
    case Kind::Count:
      return std::to_string(count);
    case Kind::Decimal:
      return fixed(number.value, number.digits);
    case Kind::Message:
      return message->english();
  }
  return text;
}

Message::Message(std::string template_words, std::vector<MessageValue> values)
    : template_(std::move(template_words)), values_(std::move(values)) {
  for (std::size_t at = 0; at < template_.size(); ++at) {
    const std::size_t place = placeAt(template_, at);
    if (place == 0 || place > values_.size()) {
      english_ += template_[at];
    } else {
      english_ += values_[place - 1].english();
      ++at;
    }
  }
}

Message inOne(const Message& first, const Message& second) {
  return Message("%1 %2", {first, second});
}

std::string linesOf(const std::vector<Message>& messages) {
  std::string lines;
  for (const Message& message : messages) lines += (lines.empty() ? "" : "\n") + message.english();
  return lines;
}

Message about(const MessageValue& name, const Message& words) {
  return Message("%1: %2", {name, words});
}

}  // namespace ostraka
