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

TEST(JsonMessage, RefusesWhatIsNone) {
  nlohmann::json deep = "end";
  for (int i = 0; i < 12; ++i)
    deep = {
        {"text", ""}, {"template", "%1"}, {"values", nlohmann::json::array({{{"message", deep}}})}};
  const nlohmann::json bad[] = {
      nlohmann::json(7),
      nlohmann::json::object(),
      nlohmann::json{{"text", ""}, {"template", 1}, {"values", nlohmann::json::array()}},
      nlohmann::json{{"text", ""}, {"template", "a"}, {"values", "b"}},
      nlohmann::json{{"text", ""}, {"template", "a"}, {"values", {true}}},
      nlohmann::json{
          {"text", ""}, {"template", "a"}, {"values", {{{"decimal", 1.0}, {"digits", 81}}}}},
      nlohmann::json{
          {"text", ""}, {"template", "a"}, {"values", {{{"decimal", 1.0}, {"digits", -1}}}}},
      nlohmann::json{{"text", ""}, {"template", "a"}, {"values", std::vector<int>(10, 1)}},
      deep};
  for (const nlohmann::json& one : bad) EXPECT_FALSE(messageFromJson(one, "x")) << one.dump();
  EXPECT_FALSE(messagesFromJson(nlohmann::json("a"), "x"));
  EXPECT_FALSE(messagesFromJson(nlohmann::json::array({7}), "x"));
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
