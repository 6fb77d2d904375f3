#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "base/result.h"

namespace ostraka {

/// {"text", "template", "values"}, text in English, or a string if the message has no template.
/// For files that are read back; files for people only contain Message::english().
nlohmann::ordered_json toJson(const Message& message);
nlohmann::ordered_json toJson(const std::vector<Message>& messages);

/// `where` names the file in errors. What toJson never writes is rejected, as is what exceeds the
/// limits (base/limits.h) of a template, of messages within each other, and of a list's text.
Result<Message> messageFromJson(const nlohmann::json& value, const std::string& where);
Result<std::vector<Message>> messagesFromJson(const nlohmann::json& value,
                                              const std::string& where);

/// A list as one field of a table: empty for none. Any other text is one message without a
/// template.
std::string textOf(const std::vector<Message>& messages);
std::vector<Message> messagesFromText(std::string_view text, const std::string& where);

}  // namespace ostraka
