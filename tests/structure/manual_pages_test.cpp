// The manual's files: every page is in the program and in the contents, every link leads somewhere,
// and what a page about a task prints in bold is a key or a text of the window.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path kManual = fs::path(OSTRAKA_SOURCE_DIR) / "resources/manual";

std::string manualText(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> foundIn(const std::string& text, const std::regex& expression) {
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at)
    found.push_back((*at)[1]);
  return found;
}

// As a person reads it: entities as characters, one space, no mark of a key. Its dots
// stay: they say that a window opens.
std::string asRead(std::string words) {
  static const std::regex key_mark("&(amp;)+"), apostrophe("&apos;"), spaces("\\s+");
  words = std::regex_replace(words, key_mark, "");
  words = std::regex_replace(words, apostrophe, "'");
  return std::regex_replace(words, spaces, " ");
}

}  // namespace

TEST(ManualPages, EachIsInTheProgramAndInTheContents) {
  static const std::regex link_form("href=\"([^\"]+)\"");
  const std::string program = manualText(kManual / "manual.qrc");
  const std::string contents = manualText(kManual / "index.html");
  int pages = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(kManual)) {
    const std::string name = entry.path().filename().string();
    if (name == "manual.qrc") continue;
    EXPECT_NE(program.find("<file>" + name + "</file>"), std::string::npos) << name;
    if (entry.path().extension() != ".html") continue;
    ++pages;
    EXPECT_NE(contents.find("href=\"" + name + "\""), std::string::npos) << name;
    const std::string page = manualText(entry.path());
    for (const std::string& link : foundIn(page, link_form))
      EXPECT_TRUE(fs::exists(kManual / link)) << name << ": " << link;
  }
  EXPECT_GE(pages, 19);
}

TEST(ManualPages, ATaskNamesOnlyKeysAndTextsOfTheWindow) {
  static const std::regex source_form("<source>([^<]*)</source>"), bold_form("<b>([^<]*)</b>");
  const std::string translations =
      manualText(fs::path(OSTRAKA_SOURCE_DIR) / "translations/ostraka_de.ts");
  std::set<std::string> texts;
  for (const std::string& source : foundIn(translations, source_form))
    texts.insert(asRead(source));
  static const std::regex key("((Ctrl|Shift)\\+)*([A-Z0-9]|Enter|Left|Right|Space|Esc)");
  int names = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(kManual)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind("task-", 0) != 0) continue;
    for (const std::string& bold : foundIn(manualText(entry.path()), bold_form)) {
      ++names;
      EXPECT_TRUE(std::regex_match(bold, key) || texts.count(asRead(bold)) > 0)
          << name << ": " << bold;
    }
  }
  EXPECT_GT(names, 40);
}
