#include "files/json_message.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/limits.h"
#include "files/json_numbers.h"
#include "files/json_text.h"

namespace ostraka {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr int kMostDigits = 80;
constexpr Template<0> kUnreadableRemark = translatable<0>(
    "A remark in this file cannot be read; restore an earlier copy of the file, or reprocess the "
    "batch.");

ordered_json valueJson(const MessageValue& value) {
  switch (value.kind) {
    case MessageValue::Kind::Text:
      return value.text;
    case MessageValue::Kind::Count:
      return value.count;
    case MessageValue::Kind::Decimal:
      if (!std::isfinite(value.number.value)) return value.english();
      return {{"decimal", value.number.value}, {"digits", value.number.digits}};
    case MessageValue::Kind::Message:
      break;
  }
  return ordered_json::object({{"message", toJson(*value.message)}});
}

// Few bytes can hold gigabytes: each level multiplies what is within it. So the text is counted as
// it is made, all messages of a list together. What is no message throws.
class MessageReader {
 public:
  Message read(const json& value, std::uint64_t depth = 0) {
    Message made =
        value.is_string() ? Message(value.get<std::string>()) : filledTemplate(value, depth);
    bytes_ += made.english().size();
    if (bytes_ > limits::kRemarkBytes.most)
      throw JsonValueError(
          message("The remarks in this file are longer than %1 bytes; restore an earlier copy of "
                  "the file, or reprocess the batch.",
                  limits::kRemarkBytes.most));
    return made;
  }

 private:
  Message filledTemplate(const json& value, std::uint64_t depth) {
    if (depth > limits::kRemarkDepth.most)
      throw JsonValueError(
          message("A remark in this file is nested more than %1 levels deep; restore an earlier "
                  "copy of the file, or reprocess the batch.",
                  limits::kRemarkDepth.most));
    const auto& words = value.at("template").get_ref<const std::string&>();
    const auto& values = value.at("values").get_ref<const json::array_t&>();
    if (value.size() != 3 || !value.at("text").is_string() || words.empty()) refuse();
    checkTemplate(words, values.size());
    std::vector<MessageValue> read;
    for (const json& one : values) read.push_back(valueOf(one, depth));
    return {words, std::move(read)};
  }

  static void checkTemplate(const std::string& words, std::size_t values) {
    if (words.size() > limits::kTemplateBytes.most)
      throw JsonValueError(
          message("The template of a remark in this file is longer than %1 bytes; restore an "
                  "earlier copy of the file, or reprocess the batch.",
                  limits::kTemplateBytes.most));
    const auto uses = usesOfPlaces(words);
    if (values >= uses.size()) refuse();
    for (std::size_t place = 1; place < uses.size(); ++place) {
      if ((place <= values) != (uses[place] > 0)) refuse();
      if (uses[place] > limits::kPlaceUses.most)
        throw JsonValueError(
            message("A remark in this file uses a value more than %1 times; restore an earlier "
                    "copy of the file, or reprocess the batch.",
                    limits::kPlaceUses.most));
    }
  }

  MessageValue valueOf(const json& value, std::uint64_t depth) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number()) return wholeIn(value, "values", INT64_MIN, INT64_MAX);
    if (value.size() == 1) return read(value.at("message"), depth + 1);
    if (value.size() != 2) refuse();
    return decimal(numberAt(value, "decimal"), wholeAt(value, "digits", 0, kMostDigits));
  }

  [[noreturn]] static void refuse() { throw JsonValueError(message(kUnreadableRemark)); }

  std::uint64_t bytes_ = 0;
};

Error unreadable(const json::exception& refused, const std::string& where) {
  return unusableJson(refused, message(kUnreadableRemark), where);
}

}  // namespace

ordered_json toJson(const Message& message) {
  if (message.templateWords().empty()) return message.english();
  ordered_json values = ordered_json::array();
  for (const MessageValue& value : message.values()) values.push_back(valueJson(value));
  return {{"text", message.english()},
          {"template", message.templateWords()},
          {"values", std::move(values)}};
}

ordered_json toJson(const std::vector<Message>& messages) {
  ordered_json all = ordered_json::array();
  for (const Message& message : messages) all.push_back(toJson(message));
  return all;
}

Result<Message> messageFromJson(const json& value, const std::string& where) {
  try {
    return MessageReader().read(value);
  } catch (const json::exception& refused) {
    return unreadable(refused, where);
  }
}

Result<std::vector<Message>> messagesFromJson(const json& value, const std::string& where) {
  try {
    MessageReader reader;
    std::vector<Message> all;
    for (const json& one : value.get_ref<const json::array_t&>()) all.push_back(reader.read(one));
    return all;
  } catch (const json::exception& refused) {
    return unreadable(refused, where);
  }
}

std::string textOf(const std::vector<Message>& messages) {
  return messages.empty() ? std::string() : toJson(messages).dump();
}

std::vector<Message> messagesFromText(std::string_view text, const std::string& where) {
  if (text.empty()) return {};
  Result<std::vector<Message>> read = messagesFromJson(jsonOrDiscarded(text), where);
  return read ? std::move(*read) : std::vector<Message>{Message(std::string(text))};
}

}  // namespace ostraka
