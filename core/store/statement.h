#pragma once
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "store/row.h"

struct sqlite3_stmt;

namespace ostraka::store {

/// The way to SQLite: inside the catalogue a failure travels as one of these, and
/// Database::asResult turns it into an Error.
struct SqlFailure : std::runtime_error {
  SqlFailure(int code_, const std::string& text) : std::runtime_error(text), code(code_) {}
  int code;  ///< SQLite's extended result code
};
/// An expected refusal met in the middle of a transaction, which it rolls back.
struct Refused : std::runtime_error {
  explicit Refused(Error error_)
      : std::runtime_error(error_.what.english()), error(std::move(error_)) {}
  Error error;
};
[[noreturn]] void refuse(Message what, std::string where = {});

/// A prepared statement in use. Values go in by call, columns come out with >>, left to right. What
/// is to be stored in a table must be as checkText and checkFinite want it, so that whatever the
/// program writes it can also export, archive and restore; else it is Refused, with the table.
class Statement {
 public:
  /// stores_in: the table whose values are checked; empty for none, as of what only reads.
  Statement(sqlite3_stmt* handle, bool* busy, std::string_view stores_in)
      : handle_(handle), busy_(busy), stores_in_(stores_in) {
    *busy_ = true;
  }
  Statement(Statement&& other) noexcept;
  ~Statement();

  /// Binds the values in order to ?1, ?2, ...
  template <class... Values>
  Statement& with(const Values&... values) {
    (bind(++bound_, values), ...);
    return *this;
  }
  /// Binds what the other's row holds, column by column, unchecked: a repair copies all it finds.
  Statement& withRow(const Statement& row);
  bool next();  ///< to the next row; false when there is none
  /// The next row's columns into these; false, and they stay as they are, when there is none.
  template <class... Values>
  bool read(Values&... values) {
    if (!next()) return false;
    (*this >> ... >> values);
    return true;
  }
  /// The first column of the next row, Value() when there is none; and of all rows that follow.
  template <class Value>
  Value one() {
    Value value{};
    read(value);
    return value;
  }
  template <class Value>
  std::vector<Value> all() {
    std::vector<Value> values;
    for (Value value{}; read(value);) values.push_back(value);
    return values;
  }
  /// Of all rows that follow, the columns into these members.
  template <class Record, class... Members>
  std::vector<Record> all(Members Record::*... members) {
    std::vector<Record> records;
    while (next()) {
      Record& record = records.emplace_back();
      (*this >> ... >> (record.*members));
    }
    return records;
  }
  void run() {
    while (next()) {
    }
  }

  Statement& operator>>(std::string& value);  ///< NULL reads as empty
  Statement& operator>>(char& value);         ///< the first letter; stays as it is if there is none
  Statement& operator>>(std::int64_t& value);
  Statement& operator>>(int& value);
  Statement& operator>>(bool& value);
  Statement& operator>>(double& value);
  /// The column as text whatever its type; numbers as values.h's numberText writes them.
  void readText(std::string& value);
  template <class T>
  Statement& operator>>(std::optional<T>& value) {
    value.reset();
    if (columnIsNull()) {
      ++column_;
      return *this;
    }
    T inner{};
    *this >> inner;
    value = std::move(inner);
    return *this;
  }
  template <class Tag>
  Statement& operator>>(RowOf<Tag>& row) {
    return *this >> row.value;  // NULL reads as 0, which is none
  }

 private:
  void bind(int index, std::string_view value);
  void bind(int index, const std::string& value) { bind(index, std::string_view(value)); }
  void bind(int index, const char* value) { bind(index, std::string_view(value)); }
  void bind(int index, std::int64_t value);
  void bind(int index, int value) { bind(index, std::int64_t{value}); }
  void bind(int index, bool value) { bind(index, std::int64_t{value}); }
  void bind(int index, double value);
  void bind(int index, std::nullptr_t);
  template <class T>
  void bind(int index, const std::optional<T>& value) {
    if (value)
      bind(index, *value);
    else
      bind(index, nullptr);
  }
  template <class Tag>
  void bind(int index, const RowOf<Tag>& row) {
    if (row)
      bind(index, row.value);
    else
      bind(index, nullptr);
  }
  bool columnIsNull() const;
  void check(int code) const;

  sqlite3_stmt* handle_;
  bool* busy_;
  std::string_view stores_in_;
  int bound_ = 0, column_ = 0;
};

}  // namespace ostraka::store
