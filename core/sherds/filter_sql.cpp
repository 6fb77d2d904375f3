#include "base/message.h"
#include "files/json_text.h"
#include "sherds/filter.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "catalogue/search.h"
#include "records/sherd.h"
#include "sherds/sherd_columns.h"
#include "sherds/sherd_order.h"
#include "store/database.h"
#include "store/names.h"
#include "store/values.h"

namespace ostraka::sherds {
namespace {

struct Query {
  store::Database& database;
  std::string where;
  std::vector<std::string> texts;
  std::string mark(std::string value) {
    texts.push_back(std::move(value));
    return "?" + std::to_string(texts.size());
  }
};

// Site, trench and context are found through the context, which few rows share.
std::string inContext(const std::string& condition) {
  return "s.context IN (SELECT context.row FROM context JOIN site ON site.row = context.site LEFT "
         "JOIN trench ON trench.row = context.trench WHERE " +
         condition + ")";
}

// The terms that are meant, as they are spelled in the vocabularies and so at the sherds: capitals
// make no difference, and a label in another language will do.
std::vector<std::string> termsCalled(Query& query, const std::string& word) {
  const std::string key = catalogue::searchKey(word);
  std::vector<std::string> terms;
  store::Statement rows = query.database.sql("SELECT term, labels FROM vocabulary");
  for (std::string term, labels; rows.read(term, labels);) {
    bool meant = catalogue::searchKey(term) == key;
    const nlohmann::json names = jsonOrDiscarded(labels);
    for (const nlohmann::json& name : names)
      meant |= name.is_string() && catalogue::searchKey(name.get<std::string>()) == key;
    if (meant) terms.push_back(term);
  }
  return terms;
}

std::string isTerm(Query& query, const std::string& word) {
  std::string in = "term IN (" + query.mark(word);
  for (const std::string& term : termsCalled(query, word)) in += ", " + query.mark(term);
  return in + ")";
}

// Places and bags are compared as they are told apart: K 12 and k12 are the same.
bool isPlace(Query& query, const std::string& name) {
  return query.database
      .sql(
          "SELECT 1 FROM site WHERE code_key = ?1 UNION SELECT 1 FROM trench WHERE code_key = ?1 "
          "AND one_with IS NULL UNION SELECT 1 FROM context WHERE number_key = ?1 AND one_with IS "
          "NULL UNION SELECT 1 FROM bag WHERE number_key = ?1 AND one_with IS NULL",
          store::codeKey(name))
      .next();
}

std::string placeSql(Query& query, const std::string& name) {
  const std::string key = query.mark(store::codeKey(name));
  return inContext("site.code_key = " + key + " OR trench.code_key = " + key +
                   " OR context.number_key = " + key) +
         " OR s.bag IN (SELECT row FROM bag WHERE number_key = " + key + ")";
}

std::string wordSql(Query& query, const std::string& word) {
  if (!catalogue::isShort(word)) {
    std::string quoted = "\"";
    for (const char c : catalogue::searched(word)) {
      quoted += c;
      if (c == '"') quoted += '"';
    }
    std::string found =
        "SELECT rowid FROM sherd_text WHERE sherd_text MATCH " + query.mark(quoted + "\"");
    // The text holds terms as they are stored, and the window shows their labels.
    const std::vector<std::string> terms = termsCalled(query, word);
    if (std::any_of(terms.begin(), terms.end(), [&](const std::string& term) {
          return store::uniqueKey(term) != store::uniqueKey(word);
        }))
      found += " UNION SELECT sherd FROM sherd_term WHERE " + isTerm(query, word);
    found = "s.row IN (" + found + ")";
    return isPlace(query, word) ? "(" + found + " OR " + placeSql(query, word) + ")" : found;
  }
  // Below three letters the search has no index: whole terms and whole places then.
  return "(s.row IN (SELECT sherd FROM sherd_term WHERE " + isTerm(query, word) + ") OR " +
         placeSql(query, word) + ")";
}

// Of a text field and of custom ones; SQLite itself folds ASCII letters alone.
std::string textSql(Query& query, const SherdColumn* column, const Condition& condition) {
  using Is = Condition::Is;
  std::vector<store::SherdRow> rows;
  store::Statement texts = query.database.sql(
      column ? std::string("SELECT s.row, '', ") + column->sql + " FROM sherd s"
             : "SELECT s.row, 'extra.' || e.key, ifnull(e.value, '') FROM sherd s, "
               "json_each(s.extra) e WHERE json_type(s.extra) = 'object'");
  store::SherdRow row;
  for (std::string field, text; texts.read(row, field, text);)
    if (!text.empty() && (column || store::uniqueKey(field) == condition.field) &&
        (condition.is != Is::Contains || catalogue::hasWord(text, condition.value)) &&
        (condition.is != Is::Equal ||
         catalogue::searchKey(text) == catalogue::searchKey(condition.value)))
      rows.push_back(row);
  return (condition.is == Is::Empty ? "s.row NOT IN (" : "s.row IN (") +
         ("SELECT value FROM json_each(" + query.mark(rowsJson(rows)) + "))");
}

constexpr const char* kDoubtfulSql =
    "(s.batch IS NOT NULL AND s.batch IN (SELECT row FROM batch WHERE scale_doubts <> ''))";

std::string emptySql(const SherdColumn& column) {
  const std::string name = column.field.name;
  if (column.measure) return "m." + std::string(column.measure) + " IS NULL";
  if (column.terms) return std::string(column.sql) + " = '[]'";
  if (name == "site" || name == "context") return "s.context IS NULL";
  if (name == "trench")
    return "(s.context IS NULL OR s.context IN (SELECT row FROM context WHERE trench IS NULL))";
  if (name == "bag") return "s.bag IS NULL";
  if (name == "batch") return "s.batch IS NULL";
  if (name == "number") return "s.number = ''";
  if (name == "scale") return "NOT " + std::string(kDoubtfulSql);
  if (name == "joins") return "s.row NOT IN (SELECT sherd FROM sherd_join)";
  return std::string(column.sql) + " = ''";
}

std::string equalSql(Query& query, const SherdColumn& column, const std::string& value) {
  const std::string name = column.field.name;
  const std::string key = store::uniqueKey(value), code = store::codeKey(value);
  if (name == "site" || name == "trench" || name == "context")
    return inContext(std::string(column.sql) + " = " + query.mark(code));
  if (name == "bag")
    return "s.bag IN (SELECT row FROM bag WHERE number_key = " + query.mark(code) + ")";
  if (name == "batch")
    return "s.batch IN (SELECT row FROM batch WHERE number = " + query.mark(value) +
           " COLLATE NOCASE)";
  if (name == "scale") return key == kDoubtfulScale ? kDoubtfulSql : "0";
  if (name == "number") return "s.number_sort = " + query.mark(store::sortKey(value));
  if (name == "joins")
    return "s.row IN (SELECT sherd FROM sherd_join WHERE other IN (SELECT sherd FROM given_number "
           "WHERE number_key = " +
           query.mark(key) + "))";
  if (column.field.kind == records::FieldKind::Terms ||
      column.field.kind == records::FieldKind::Term) {
    return "s.row IN (SELECT sherd FROM sherd_term WHERE " + isTerm(query, value) +
           " AND field = " + query.mark(name) + ")";
  }
  return std::string(column.sql) + " = " + query.mark(value) + " COLLATE NOCASE";
}

// Whole parts of a number that follow each other, as its sort key separates them: t3-12 of
// ARM1-T3-0012-0007.
std::string partOfNumberSql(Query& query, const std::string& part) {
  const std::string key = store::sortKey(part);
  return "instr('-' || s.number_sort || '-', " + query.mark("-" + key + "-") + ") > 0";
}

const char* signOf(Condition::Is is) {
  switch (is) {
    case Condition::Is::Less:
      return " < ";
    case Condition::Is::LessEqual:
      return " <= ";
    case Condition::Is::Greater:
      return " > ";
    case Condition::Is::GreaterEqual:
      return " >= ";
    default:
      return " = ";
  }
}

std::string conditionSql(Query& query, const Condition& condition) {
  using Is = Condition::Is;
  if (condition.is == Is::Word) return wordSql(query, condition.value);
  if (condition.field.starts_with("extra.")) return textSql(query, nullptr, condition);
  const SherdColumn* column = sherdColumn(condition.field);
  if (!column) store::refuse(message("There is no field '%1'.", condition.field), condition.text);
  if (condition.is == Is::Contains && column->field.name == std::string_view("number"))
    return partOfNumberSql(query, condition.value);
  if (condition.is == Is::Contains) return textSql(query, column, condition);
  if (condition.is == Is::Empty) return emptySql(*column);
  if (condition.is == Is::NotEmpty) return "NOT (" + emptySql(*column) + ")";
  if (column->measure) {
    const std::string value =
        query.mark(store::numberText(store::valueOrThrow(store::parsedNumber(condition.value))));
    const std::string measure = "m." + std::string(column->measure);
    if (condition.is != Is::Equal)
      return measure + signOf(condition.is) + "CAST(" + value + " AS REAL)";
    // Tables and windows show a computed one rounded.
    const std::string half = query.mark(store::numberText(store::halfStep(condition.value)));
    return "abs(" + measure + " - CAST(" + value + " AS REAL)) <= CAST(" + half + " AS REAL)";
  }
  if (column->field.kind == records::FieldKind::Day) {
    // A month is compared with months, a year with years.
    const std::string day = column->sql;
    const std::string part =
        "substr(" + day + ", 1, " + std::to_string(condition.value.size()) + ")";
    return "(" + day + " <> '' AND " + part + signOf(condition.is) + query.mark(condition.value) +
           ")";
  }
  return equalSql(query, *column, condition.value);
}

// The longest run of words from here on that is the name of one place: K 12, context:K 12.
std::span<const Condition> nextOf(Query& query, std::span<const Condition> rest) {
  using Is = Condition::Is;
  constexpr std::size_t kMostWords = 4;
  const Condition& first = rest.front();
  const SherdColumn* column = sherdColumn(first.field);
  const bool of_places = column && column->field.kind == records::FieldKind::Place;
  std::size_t longest = 1;
  if (first.negated || !(first.is == Is::Word || (of_places && first.is == Is::Equal)))
    return rest.first(longest);
  std::string name = first.value;
  for (std::size_t i = 1; i < std::min(rest.size(), kMostWords); ++i) {
    if (rest[i].is != Is::Word || rest[i].negated) break;
    name += rest[i].value;
    if (isPlace(query, name)) longest = i + 1;
  }
  return rest.first(longest);
}

// Each by itself, or all together as the name of a place.
std::string conditionsSql(Query& query, std::span<const Condition> run) {
  std::string each, name;
  for (const Condition& condition : run) {
    each += (each.empty() ? "" : " AND ") + conditionSql(query, condition);
    name += condition.value;
  }
  if (run.size() == 1) return each;
  const Condition& first = run.front();
  return "((" + each + ") OR " +
         (first.field.empty() ? placeSql(query, name)
                              : equalSql(query, *sherdColumn(first.field), name)) +
         ")";
}

}  // namespace

std::vector<store::SherdRow> matching(store::Database& database, const Filter& filter,
                                      const records::SherdOrder& order) {
  Query query{database, {}, {}};
  query.where = "NOT (s.state = 'void' AND s.number = '')";
  for (std::span<const Condition> rest = filter.conditions; !rest.empty();) {
    const std::span<const Condition> run = nextOf(query, rest);
    const std::string sql = conditionsSql(query, run);
    query.where += run.front().negated ? " AND NOT ifnull(" + sql + ", 0)" : " AND " + sql;
    rest = rest.subspan(run.size());
  }
  // Drafts share one sort key, so their rows run up whichever way the numbers go.
  const char* way = order.field == "number" && order.descending ? " DESC" : "";
  store::Statement statement =
      database.sql("SELECT s.row FROM sherd s LEFT JOIN sherd_measure m ON m.sherd = s.row WHERE " +
                   query.where + " ORDER BY s.number_sort" + way + ", s.row");
  for (const std::string& text : query.texts) statement.with(text);
  std::vector<store::SherdRow> rows;
  for (store::SherdRow row; statement.read(row);) rows.push_back(row);
  return order.field == "number" ? rows : inOrder(database, rows, order);
}

}  // namespace ostraka::sherds
