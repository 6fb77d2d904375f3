// Messages in the program's own files: what is read back is what was written, and nothing else.
#include "files/json_message.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace ostraka {
namespace {

TEST(JsonMessage, ComesBackWithTemplateAndValues) {
  const Message words =
      message("%1: %2 of %3 mm (%4).", "a.png", 3, decimal(1.25, 1), message("it is not open"));
  const Result<Message> read = messageFromJson(nlohmann::json(toJson(words)), "stage.json");
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, words);
  EXPECT_EQ(read->templateWords(), words.templateWords());
  ASSERT_EQ(read->values().size(), 4u);
  EXPECT_EQ(read->values()[1].kind, MessageValue::Kind::Count);
  EXPECT_EQ(read->values()[2].kind, MessageValue::Kind::Decimal);
  EXPECT_EQ(read->values()[3].message->templateWords(), "it is not open");
  EXPECT_EQ(toJson(words)["text"], words.english());
}

TEST(JsonMessage, ANumberThatJsonDoesNotKnowIsWrittenOut) {
  const Message words = message("It is %1 mm off.", decimal(std::nan(""), 2));
  const auto text = toJson(words).dump();
  EXPECT_EQ(*messageFromJson(nlohmann::json::parse(text), "x"), words);
}

TEST(JsonMessage, WordsWithoutATemplateAreAString) {
  EXPECT_EQ(toJson(Message("Out of paper")), nlohmann::json("Out of paper"));
  EXPECT_EQ(*messageFromJson(nlohmann::json("Out of paper"), "x"), "Out of paper");
}

nlohmann::json filled(const std::string& words, const nlohmann::json::array_t& values) {
  return {{"text", "t"}, {"template", words}, {"values", values}};
}

nlohmann::json nested(int levels, const std::string& words, nlohmann::json within) {
  for (int i = 0; i < levels; ++i) within = filled(words, {{{"message", within}}});
  return within;
}

nlohmann::json decimalWith(const nlohmann::json& digits) {
  return {{"decimal", 1.0}, {"digits", digits}};
}

std::string refusal(const nlohmann::json::array_t& messages) {
  const Result<std::vector<Message>> read = messagesFromJson(messages, "report.json");
  return read ? "read" : read.error().sentence().english();
}

TEST(JsonMessage, RefusesWhatIsNone) {
  nlohmann::json without_text = filled("a", {});
  without_text.erase("text");
  nlohmann::json with_more = filled("a", {});
  with_more["more"] = 1;
  const nlohmann::json bad[] = {
      nlohmann::json(7),
      nlohmann::json::object(),
      without_text,
      with_more,
      {{"text", 1}, {"template", "a"}, {"values", nlohmann::json::array()}},
      {{"text", ""}, {"template", 1}, {"values", nlohmann::json::array()}},
      {{"text", ""}, {"template", "%1"}, {"values", "b"}},
      filled("", {}),
      filled("%1", {true}),
      filled("%1", {1.5}),
      filled("%1", {decimalWith(81)}),
      filled("%1", {decimalWith(-1)}),
      filled("%1", {decimalWith(4294967297)}),
      filled("%1 %2", {"without a second value"}),
      filled("%1%2%3%4%5%6%7%8%9", nlohmann::json::array_t(10, 1)),
  };
  for (const nlohmann::json& one : bad) EXPECT_FALSE(messageFromJson(one, "x")) << one.dump();
  EXPECT_FALSE(messagesFromJson(nlohmann::json("a"), "x"));
  EXPECT_FALSE(messagesFromJson(nlohmann::json::array({7}), "x"));
}

// What a person wrote into the file must not vanish behind a template that does not show it.
TEST(JsonMessage, RefusesATextOrAValueThatItsTemplateDoesNotShow) {
  for (const char* words : {"", "All is well"})
    EXPECT_NE(refusal({filled(words, {"a value"})}).find("report.json: A remark in this file"),
              std::string::npos)
        << words;
}

TEST(JsonMessage, RefusesAWholeNumberThatWouldBecomeNegative) {
  EXPECT_NE(refusal({filled("%1", {UINT64_MAX})}).find("'values' must be a whole number"),
            std::string::npos);
  EXPECT_EQ(messageFromJson(filled("%1", {INT64_MAX}), "x")->english(), "9223372036854775807");
}

// Three levels of such templates are 8 kB of JSON and 8 GB of text.
TEST(JsonMessage, RefusesByNameWhatExpandsBeyondTheLimits) {
  std::string often;
  for (int i = 0; i < 1000; ++i) often += "%1";
  EXPECT_NE(refusal({nested(3, often, "xxxxxxxx")}).find("longer than 1024 bytes"),
            std::string::npos);
  EXPECT_NE(refusal({filled("%1%1%1%1", {"x"})}).find("a value more than 3 times"),
            std::string::npos);
  EXPECT_NE(refusal({nested(10, "%1", "end")}).find("more than 8 levels deep"), std::string::npos);
  const std::string leaf(1000, 'x');
  EXPECT_NE(refusal({nested(8, "%1%1%1", leaf)}).find("longer than 4194304 bytes"),
            std::string::npos);
}

TEST(JsonMessage, CountsTheTextOfAllMessagesOfAList) {
  const nlohmann::json one = nested(6, "%1%1%1", std::string(1000, 'x'));
  EXPECT_EQ(refusal({one}), "read");
  EXPECT_NE(refusal(nlohmann::json::array_t(4, one)).find("longer than 4194304 bytes"),
            std::string::npos);
}

TEST(JsonMessage, OneFieldOfATableHoldsAList) {
  EXPECT_EQ(textOf({}), "");
  EXPECT_TRUE(messagesFromText("", "B0001").empty());
  const std::vector<Message> two = {message("It is set aside."), Message("own words")};
  const std::vector<Message> read = messagesFromText(textOf(two), "B0001");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].templateWords(), "It is set aside.");
  EXPECT_EQ(read[1], "own words");
  ASSERT_EQ(messagesFromText("typed by hand", "B0001").size(), 1u);
  EXPECT_EQ(messagesFromText("typed by hand", "B0001")[0], "typed by hand");
}

}  // namespace
}  // namespace ostraka
