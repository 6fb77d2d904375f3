#pragma once
#include <array>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "base/limits.h"

namespace ostraka {

class Message;

/// A number with this many digits after the decimal point; the unit belongs in the template.
struct Decimal {
  double value = 0;
  int digits = 0;  ///< 0 to 80
};
inline Decimal decimal(double value, int digits) {
  return {value, digits};
}
/// With at most this many digits, up to 9, and without zeros at the end.
Decimal shortDecimal(double value, int most_digits);

/// The value for a place of a template.
struct MessageValue {
  enum class Kind {
    Text,     ///< a name, a file, another program's output: as it is, but see translations
    Count,    ///< a whole number
    Decimal,  ///< written with the decimal sign of the reader's language
    Message   ///< a phrase or sentence that is translated itself
  };

  MessageValue(std::string words) : text(std::move(words)) {}
  MessageValue(std::string_view words) : text(words) {}
  MessageValue(const char* words) : text(words) {}
  MessageValue(char letter) : text(1, letter) {}
  MessageValue(const std::filesystem::path& path) : text(path.string()) {}
  MessageValue(Decimal value) : kind(Kind::Decimal), number(value) {}
  MessageValue(const Message& words);
  template <std::integral Whole>
  requires(!std::same_as<Whole, bool> && !std::same_as<Whole, char>) MessageValue(Whole whole)
      : kind(Kind::Count), count(static_cast<std::int64_t>(whole)) {}

  std::string english() const;

  Kind kind = Kind::Text;
  std::string text;
  std::int64_t count = 0;
  Decimal number;
  std::shared_ptr<const Message> message;  ///< of kind Message; else none
  /// Of a text that the project has in several languages ("de").
  std::map<std::string, std::string> translations = {};
};

/// The place that begins at `at` of a template, %1 to %9 as 1 to 9; else 0.
constexpr std::size_t placeAt(std::string_view words, std::size_t at) {
  const bool is_place =
      at + 1 < words.size() && words[at] == '%' && words[at + 1] >= '1' && words[at + 1] <= '9';
  return is_place ? static_cast<std::size_t>(words[at + 1] - '0') : 0;
}
/// How often a template uses %1 to %9, at 1 to 9.
constexpr std::array<std::uint64_t, 10> usesOfPlaces(std::string_view words) {
  std::array<std::uint64_t, 10> uses{};
  for (std::size_t at = 0; at < words.size(); ++at) ++uses[placeAt(words, at)];
  uses[0] = 0;
  return uses;
}

/// An English sentence or phrase with places %1 to %N, each used at least once, within the limits
/// of what is read back; checked at compile time. translations/messages.py finds these literals
/// for translators.
template <std::size_t N>
class Template {
 public:
  consteval Template(const char* words) : words_(words) {
    if (std::string_view(words).size() > limits::kTemplateBytes.most) throw "too long a template";
    const std::array<std::uint64_t, 10> uses = usesOfPlaces(words);
    for (std::size_t place = 1; place < uses.size(); ++place) {
      if (place > N && uses[place] > 0) throw "a place without a value";
      if (place <= N && uses[place] == 0) throw "a value without a place";
      if (uses[place] > limits::kPlaceUses.most) throw "a value that is used too often";
    }
  }
  constexpr const char* words() const { return words_; }

 private:
  const char* words_;
};

/// A text for a person: a template in English and its values. Terminals, logs and files for people
/// get english(); the window translates the template and formats the values for the language. A
/// text without a template, such as another program's output, is shown unchanged.
class Message {
 public:
  Message() = default;
  Message(std::string words) : english_(std::move(words)) {}
  Message(const char* words) : english_(words) {}
  /// template_words: as from Template; values: one for each of its places.
  Message(std::string template_words, std::vector<MessageValue> values);

  const std::string& english() const { return english_; }
  /// Explicit, since what a window may show must keep its template.
  explicit operator const std::string&() const { return english_; }
  /// Empty if the text has no template.
  const std::string& templateWords() const { return template_; }
  const std::vector<MessageValue>& values() const { return values_; }
  bool empty() const { return english_.empty(); }

  /// Compares the English texts.
  friend bool operator==(const Message& a, const Message& b) { return a.english_ == b.english_; }
  friend bool operator==(const Message& a, std::string_view b) { return a.english_ == b; }
  friend bool operator==(const Message& a, const std::string& b) { return a.english_ == b; }
  friend bool operator==(const Message& a, const char* b) { return a.english_ == b; }
  friend std::ostream& operator<<(std::ostream& out, const Message& message) {
    return out << message.english_;
  }

 private:
  std::string template_, english_;
  std::vector<MessageValue> values_;
};

/// A message from a literal template, which translators see, and its values.
template <class... Values>
Message message(Template<sizeof...(Values)> words, const Values&... values) {
  return Message(words.words(), std::vector<MessageValue>{MessageValue(values)...});
}

/// Marks a literal template in a table for translators; the message is made elsewhere.
template <std::size_t N>
consteval Template<N> translatable(Template<N> words) {
  return words;
}

/// Two sentences, separated by a space.
Message inOne(const Message& first, const Message& second);
/// In English, one line each, without a newline at the end.
std::string linesOf(const std::vector<Message>& messages);
/// "front/a.jpg: It is blurred."
Message about(const MessageValue& name, const Message& words);

}  // namespace ostraka
