#include "tables/csv.h"

#include <algorithm>
#include <regex>

#include "base/limits.h"
#include "base/message.h"
#include "base/text.h"
#include "store/names.h"

namespace ostraka::tables {
namespace {

constexpr std::size_t kMostRows = limits::kTableRows.most,
                      kMostColumns = limits::kTableColumns.most,
                      kMostField = limits::kTableFieldBytes.most;
constexpr std::string_view kBom = kUtf8Mark;
// The wide ones of East Asian keyboards (U+FF1D, FF0B, FF0D, FF20) begin formulas, too.
constexpr std::string_view kFormulaStarts[] = {"=",  "+",  "-",  "@",  "\t", "\r",
                                               "\n", "＝", "＋", "－", "＠"};

bool isFormula(std::string_view text) {
  return std::any_of(std::begin(kFormulaStarts), std::end(kFormulaStarts),
                     [&](std::string_view start) { return text.starts_with(start); });
}

std::string fromUtf16(std::string_view bytes, bool big_endian) {
  std::u16string units;
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
    const auto a = static_cast<unsigned char>(bytes[i]),
               b = static_cast<unsigned char>(bytes[i + 1]);
    units += static_cast<char16_t>(big_endian ? a << 8 | b : b << 8 | a);
  }
  return store::fromUtf16(units);
}

// Programs that put their mark before a text that has one leave several.
std::size_t marksBefore(std::string_view text) {
  std::size_t marks = 0;
  while (text.substr(marks).starts_with(kBom)) marks += kBom.size();
  return marks;
}

// OpenDocument and Excel files are ZIP files; those of before 2007 begin with a mark of their own.
bool isSpreadsheet(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04") || bytes.starts_with("\xD0\xCF\x11\xE0");
}

Result<std::string> decoded(std::string_view bytes, const std::string& where) {
  if (isSpreadsheet(bytes))
    return Error::unusable(
        message("This is a spreadsheet (ODS, XLSX), not a CSV table; save the sheet as 'CSV UTF-8' "
                "and import that file."),
        where);
  std::string text;
  if (bytes.starts_with("\xFF\xFE"))
    text = fromUtf16(bytes, false);
  else if (bytes.starts_with("\xFE\xFF"))
    text = fromUtf16(bytes, true);
  else
    text = bytes;
  text.erase(0, marksBefore(text));
  if (text.find('\0') != std::string::npos)
    return Error::unusable(
        message("Not a text file: it contains binary data, which a table never does."), where);
  if (!isUtf8(text)) {
    std::size_t good = 0;
    int line = 1;
    for (; good < text.size(); ++line) {
      const std::size_t end = std::min(text.find('\n', good), text.size());
      if (!isUtf8(std::string_view(text).substr(good, end - good))) break;
      good = end + 1;
    }
    return Error::unusable(
        message("Line %1 is not in UTF-8; save the table as 'CSV UTF-8' and try again.", line),
        where);
  }
  return text;
}

// Some programs quote the first name together with the mark of the file.
std::string columnNamed(std::string_view written) {
  const std::string name = store::trimmed(written);
  return unguarded(store::trimmed(std::string_view(name).substr(marksBefore(name))));
}

// Of a row that is too short there is nothing to leave out.
void leaveOut(CsvTable& table, std::size_t column) {
  const auto at = static_cast<std::ptrdiff_t>(column);
  table.columns.erase(table.columns.begin() + at);
  for (CsvRow& row : table.rows)
    if (column < row.values.size()) row.values.erase(row.values.begin() + at);
}

// Of the three, the one that the header has most of, outside quotation marks.
char separatorOf(std::string_view text) {
  int counts[3] = {0, 0, 0};
  bool quoted = false;
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == '\n' || c == '\r') break;
    const std::size_t which = std::string_view(",;\t").find(c);
    if (which != std::string_view::npos) ++counts[which];
  }
  const auto most = std::max_element(std::begin(counts), std::end(counts));
  return ",;\t"[most - std::begin(counts)];
}

// Excel's own first line, sep=; and nothing else.
std::cmatch separatorLine(std::string_view text) {
  static const std::regex kForm("\"?sep=([,;\t])\"?(\r\n?|\n|$)", std::regex::icase);
  std::cmatch line;
  std::regex_search(text.data(), text.data() + text.size(), line, kForm,
                    std::regex_constants::match_continuous);
  return line;
}

class Parser {
 public:
  Parser(std::string_view text, char separator, int line, const std::string& where)
      : text_(text), separator_(separator), where_(where), line_(line) {}

  Result<std::vector<CsvRow>> rows() {
    std::vector<CsvRow> all;
    while (at_ < text_.size()) {
      CsvRow row;
      row.line = line_;
      bool more = true;
      while (more) {
        Result<std::string> value = field();
        if (!value) return value.error();
        // FileMaker writes the line ends inside a value so.
        std::replace(value->begin(), value->end(), '\v', '\n');
        row.values.push_back(std::move(*value));
        more = at_ < text_.size() && text_[at_] == separator_;
        if (more) ++at_;
      }
      endOfLine();
      if (row.values.size() == 1 && row.values[0].empty()) continue;
      if (all.empty() && row.values.size() > kMostColumns)
        return Error::unusable(message("The table has more than 1,000 columns; split it."), where_);
      if (all.size() > kMostRows)
        return Error::unusable(message("The table has more than 1,000,000 rows; split it."),
                               where_);
      all.push_back(std::move(row));
    }
    return all;
  }

 private:
  Result<std::string> field() {
    std::string value;
    const int begin = line_;
    if (at_ < text_.size() && text_[at_] == '"') {
      ++at_;
      while (true) {
        if (at_ >= text_.size())
          return Error::unusable(message("Line %1 has an unclosed quotation mark.", begin), where_);
        if (text_[at_] == '"') {
          if (at_ + 1 >= text_.size() || text_[at_ + 1] != '"') break;
          ++at_;
        }
        if (text_[at_] == '\n') ++line_;
        value += text_[at_++];
        if (value.size() > kMostField) return tooLong(begin);
      }
      ++at_;
      if (at_ < text_.size() && text_[at_] != separator_ && text_[at_] != '\n' &&
          text_[at_] != '\r')
        return Error::unusable(
            message("Line %1 has characters after a closing quotation mark.", line_), where_);
      return value;
    }
    const std::size_t end =
        std::min(text_.find_first_of(std::string{separator_, '\r', '\n'}, at_), text_.size());
    if (end - at_ > kMostField) return tooLong(begin);
    value = text_.substr(at_, end - at_);
    at_ = end;
    return value;
  }

  void endOfLine() {
    if (at_ < text_.size() && text_[at_] == '\r') ++at_;
    if (at_ < text_.size() && text_[at_] == '\n') ++at_;
    ++line_;
  }

  Error tooLong(int line) const {
    return Error::unusable(message("Line %1 has a value longer than 1 MB.", line), where_);
  }

  std::string_view text_;
  char separator_;
  const std::string& where_;
  std::size_t at_ = 0;
  int line_;
};

}  // namespace

std::string cellOf(const CsvRow& row, std::size_t column) {
  return column < row.values.size() ? store::trimmed(unguarded(row.values[column])) : std::string();
}

Result<CsvTable> parseCsv(std::string_view bytes, const std::string& where) {
  const Result<std::string> text = decoded(bytes, where);
  if (!text) return text.error();
  CsvTable table;
  const std::cmatch named = separatorLine(*text);
  const int line = named.empty() ? 1 : 2;
  table.separator = named.empty() ? separatorOf(*text) : *named[1].first;
  const auto length = named.empty() ? 0 : static_cast<std::size_t>(named.length());
  Result<std::vector<CsvRow>> rows =
      Parser(std::string_view(*text).substr(length), table.separator, line, where).rows();
  if (!rows) return rows.error();
  if (rows->empty())
    return Error::unusable(message("The table is empty; its first line must name the columns."),
                           where);
  for (const std::string& column : rows->front().values)
    table.columns.push_back(columnNamed(column));
  rows->erase(rows->begin());
  table.rows = std::move(*rows);
  for (std::size_t i = table.columns.size(); i > 0; --i)
    if (table.columns[i - 1].starts_with(kRemarkColumn)) leaveOut(table, i - 1);
  return table;
}

std::string csvLine(const std::vector<std::string>& values, char separator) {
  std::string line;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) line += separator;
    // A row of one empty value would be an empty line, and a column's name full of semicolons would
    // be taken for many columns.
    const bool quote = values[i].find_first_of(",;\t\"\r\n") != std::string::npos ||
                       (values.size() == 1 && values[i].empty());
    if (!quote) {
      line += values[i];
      continue;
    }
    line += '"';
    for (const char c : values[i]) {
      if (c == '"') line += '"';
      line += c;
    }
    line += '"';
  }
  return line + "\r\n";
}

std::string guarded(std::string_view text) {
  const std::size_t first = text.find_first_not_of('\'');
  if (first != std::string_view::npos && isFormula(text.substr(first)))
    return "'" + std::string(text);
  return std::string(text);
}

std::string unguarded(std::string_view text) {
  const std::size_t first = text.find_first_not_of('\'');
  if (first != std::string_view::npos && first > 0 && isFormula(text.substr(first)))
    text.remove_prefix(1);
  return std::string(text);
}

}  // namespace ostraka::tables
