#include "files/json_message.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "files/json_text.h"

namespace ostraka {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr int kDeepest = 8;
constexpr std::size_t kMostValues = 9;
constexpr int kMostDigits = 80;

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

std::optional<Message> messageOf(const json& value, int depth);

std::optional<MessageValue> valueOf(const json& value, int depth) {
  if (value.is_string()) return MessageValue(value.get<std::string>());
  if (value.is_number_integer()) return MessageValue(value.get<std::int64_t>());
  if (!value.is_object()) return {};
  if (value.size() == 1 && value.contains("message")) {
    const std::optional<Message> inner = messageOf(value["message"], depth + 1);
    return inner ? std::optional<MessageValue>(*inner) : std::nullopt;
  }
  if (value.size() != 2 || !value.contains("decimal") || !value.contains("digits")) return {};
  const json& number = value["decimal"];
  const json& digits = value["digits"];
  if (!number.is_number() || !digits.is_number_integer() || digits < 0 || digits > kMostDigits)
    return {};
  return MessageValue(decimal(number.get<double>(), digits.get<int>()));
}

std::optional<Message> messageOf(const json& value, int depth) {
  if (value.is_string()) return Message(value.get<std::string>());
  if (depth > kDeepest || !value.is_object() || value.size() != 3 || !value.contains("template") ||
      !value.contains("values"))
    return {};
  const json& words = value["template"];
  const json& values = value["values"];
  if (!words.is_string() || !values.is_array() || values.size() > kMostValues) return {};
  std::vector<MessageValue> read;
  for (const json& one : values) {
    std::optional<MessageValue> known = valueOf(one, depth);
    if (!known) return {};
    read.push_back(std::move(*known));
  }
  return Message(words.get<std::string>(), std::move(read));
}

Error unreadable(const std::string& where) {
  return Error::unusable(
      message("A remark in this file cannot be read; restore an earlier copy of the file, or "
              "reprocess the batch."),
      where);
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
  if (std::optional<Message> read = messageOf(value, 0)) return std::move(*read);
  return unreadable(where);
}

Result<std::vector<Message>> messagesFromJson(const json& value, const std::string& where) {
  if (!value.is_array()) return unreadable(where);
  std::vector<Message> all;
  for (const json& one : value) {
    Result<Message> read = messageFromJson(one, where);
    if (!read) return read.error();
    all.push_back(std::move(*read));
  }
  return all;
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
