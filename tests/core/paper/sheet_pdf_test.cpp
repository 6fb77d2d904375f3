// Sheets as PDF, read by Poppler's programs.
#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "paper/sheet.h"
#include "tests/core/paper/one_page.h"

namespace ostraka {
namespace {

// What one of Poppler's programs says of a PDF.
std::string answerOf(const std::string& program, const std::string& pdf,
                     const std::string& behind = "") {
  const std::string file = testing::TempDir() + "sheet_said.pdf", out = file + ".txt";
  std::ofstream(file, std::ios::binary) << pdf;
  EXPECT_EQ(std::system((program + " " + file + " " + behind + " > " + out).c_str()), 0);
  std::ifstream in(out, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string wordsOf(const std::string& pdf) {
  std::string text = answerOf("pdftotext -layout", pdf, "-"), lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    line.erase(0, line.find_first_not_of(" \f"));
    if (!line.empty()) lines += (lines.empty() ? "" : "\n") + line;
  }
  return lines;
}

TEST(SheetPdf, LetsItsLettersBeCopiedAndWritesAQuestionMarkWhereNoFontHasOne) {
  Sheet sheet;
  sheet.text({0, 0}, 3, "\xC3\x98 5 \xC2\xB1 1? \u0533\u0561\u057C\u0576\u056B");  // diameter sign
  sheet.text({0, 9}, 3, "seen \xF3\xB0\x80\x80 here");  // U+F0000, for private use
  EXPECT_EQ(wordsOf(formatPdf({pageWith(sheet)}, "")),
            "\xC3\x98 5 \xC2\xB1 1? \u0533\u0561\u057C\u0576\u056B\nseen ? here");
}

TEST(SheetPdf, KeepsSignsOfItsOwnInTexts) {
  Sheet sheet;
  sheet.text({1, 2}, 3, "a<b & (c)\\ <41>");
  EXPECT_EQ(wordsOf(formatPdf({pageWith(sheet)}, "")), "a<b & (c)\\ <41>");
}

// A printer or publisher that lacks a font puts another in its place.
TEST(SheetPdf, EmbedsTheFontsOfItsLetters) {
  Sheet sheet;
  sheet.text({0, 0}, 3, "plain");
  sheet.text({0, 9}, 3, "bold", Anchor::Left, Weight::Bold);
  for (int i = 0; i < 300; ++i) {  // more letters than one font of a PDF has
    const unsigned code = 0x4E00u + static_cast<unsigned>(i);
    sheet.text({0, 12}, 3,
               {static_cast<char>(0xE0 | (code >> 12)), static_cast<char>(0x80 | (code >> 6 & 63)),
                static_cast<char>(0x80 | (code & 63))});
  }
  const std::string fonts = answerOf("pdffonts", formatPdf({pageWith(sheet)}, ""));
  std::istringstream lines(fonts);
  std::string line;
  int rows = 0;
  while (std::getline(lines, line))
    if (line.find("Type 3") != std::string::npos) {
      ++rows;
      EXPECT_THAT(line, testing::ContainsRegex("yes +(yes|no) +yes")) << line;  // emb sub uni
    }
  EXPECT_GE(rows, 1) << fonts;
  EXPECT_THAT(fonts, testing::Not(testing::HasSubstr("Helvetica")));
}

// Rendered by Poppler: the letters differ from each other and stand where they were put.
TEST(SheetPdf, DrawsTheLettersOfOtherScripts) {
  const auto ink = [](const std::string& text, Anchor anchor) {
    Sheet sheet;
    sheet.text({40, 20}, 8, text, anchor);
    const std::string pdf = testing::TempDir() + "sheet_letters.pdf";
    std::ofstream(pdf, std::ios::binary) << formatPdf({pageWith(sheet)}, text);
    const std::string png = testing::TempDir() + "sheet_letters";
    EXPECT_EQ(std::system(("pdftoppm -r 127 -gray -singlefile " + pdf + " " + png).c_str()), 0);
    std::ifstream in(png + ".pgm", std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const auto box = [](const std::string& pgm) {  // 5 pixels a mm
    std::istringstream header(pgm);
    std::string magic;
    int width = 0, height = 0;
    header >> magic >> width >> height;
    const std::size_t begin = pgm.size() - static_cast<std::size_t>(width * height);
    int low = width, high = -1;
    for (std::size_t i = begin; i < pgm.size(); ++i)
      if (static_cast<unsigned char>(pgm[i]) < 128) {
        const int x = static_cast<int>(i - begin) % width;
        low = std::min(low, x);
        high = std::max(high, x);
      }
    return std::pair(low / 5.0 - 10, high / 5.0 - 10);  // the layer lies at 10 mm
  };
  const std::string garni = "\u0533\u0561\u057C\u0576\u056B",
                    athena = "\u0391\u03B8\u03AE\u03BD\u03B1";
  EXPECT_NE(ink(garni, Anchor::Left), ink(athena, Anchor::Left));
  for (const std::string& word : {garni, athena, std::string("I\u011Fd\u0131r")}) {
    const double width = textWidth({{0, 0}, 8, word, Anchor::Left, Weight::Plain});
    EXPECT_GT(width, 10);
    const auto [left, right] = box(ink(word, Anchor::Left));
    EXPECT_NEAR(left, 40, 1) << word;
    EXPECT_NEAR(right, 40 + width, 1) << word;
    EXPECT_NEAR(box(ink(word, Anchor::Right)).second, 40, 1) << word;
  }
}

TEST(SheetPdf, SaysWhetherAPictureHasColours) {
  for (const auto& [ink, name] :
       {std::pair(Ink::Black, "/DeviceGray"), {Ink::Colours, "/DeviceRGB"}}) {
    Sheet sheet;
    sheet.items.push_back(Picture{{0, 0}, {1, 1}, "M", 1, 1, ink});
    EXPECT_THAT(formatPdf({pageWith(sheet)}, ""),
                testing::HasSubstr(std::string("/ColorSpace ") + name + " "));
  }
}

TEST(SheetPdf, ItsTablePointsAtItsObjects) {
  Sheet sheet;
  sheet.circle({20, 20}, 5, 0.0, {});
  const std::string pdf = formatPdf({pageWith(sheet), pageWith(sheet)}, "two pages");
  const std::size_t table = std::strtoul(pdf.c_str() + pdf.rfind("startxref") + 10, nullptr, 10);
  ASSERT_EQ(pdf.substr(table, 5), "xref\n");
  const int count = std::atoi(pdf.c_str() + table + 7);
  EXPECT_EQ(count, 11);  // the free one, catalogue, pages, fonts, 2 x (content, page), 2, title
  for (int id = 1; id < count; ++id) {
    const std::size_t entry = pdf.find("\n", table + 5) + 1 + 20 * static_cast<std::size_t>(id);
    const std::size_t offset = std::strtoul(pdf.c_str() + entry, nullptr, 10);
    const std::string head = std::to_string(id) + " 0 obj\n";
    EXPECT_EQ(pdf.substr(offset, head.size()), head);
  }
}

}  // namespace
}  // namespace ostraka
