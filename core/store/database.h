#pragma once
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <unordered_map>

#include "base/progress.h"
#include "base/result.h"
#include "files/scratch_folder.h"
#include "store/statement.h"

struct sqlite3;

namespace ostraka::store {

/// While others are waited for: whoever asks for a stop ends the wait (Cancelled), and after half a
/// second one note says for whom. What it names must live as long as the connection.
struct Waiting {
  std::stop_token stop;
  Progress* progress = nullptr;
};

/// One connection. Foreign keys are on, others are waited for 10 s. Pages are checked as they are
/// read (page_checksums.h).
class Database {
 public:
  /// ReadOnly: also where nothing can be written, not even what SQLite needs beside the file.
  enum class Mode { Create, ReadWrite, ReadOnly };
  static Result<std::unique_ptr<Database>> open(const std::filesystem::path& file, Mode mode,
                                                Waiting waiting = {});
  /// From now on: what must not be left half done waits without regard to a stop.
  void setWaiting(Waiting waiting) { waiting_ = std::move(waiting); }
  /// Makes the journal a WAL, which writes into the file: not before it is known as ours. Errors:
  /// Damaged while a repair is to be ended.
  Result<void> writeAhead();
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  /// Prepared once, kept for the next call; the values go to ?1, ?2, ...
  template <class... Values>
  Statement sql(std::string_view text, const Values&... values) {
    Statement statement = prepared(text);
    statement.with(values...);
    return statement;
  }
  template <class... Values>
  void run(std::string_view text, const Values&... values) {
    sql(text, values...).run();
  }
  void script(const std::string& text);  ///< several statements
  std::int64_t lastRow() const;
  int changes() const;

  /// One transaction, or a part of the one around it; an exception or an Error undoes it.
  template <class Work>
  auto inTransaction(Work work) -> Result<std::invoke_result_t<Work>> {
    // Taking the right to write at once: a transaction that reads first and writes later can fail
    // between the two.
    return within("BEGIN IMMEDIATE", std::move(work));
  }
  /// What is read is of one moment, whatever others write meanwhile; nothing is to be written.
  template <class Work>
  auto inSnapshot(Work work) -> Result<std::invoke_result_t<Work>> {
    return within("BEGIN DEFERRED", std::move(work));
  }
  /// Where failures become Errors.
  template <class Work>
  auto asResult(Work work) const -> Result<std::invoke_result_t<Work>> {
    try {
      if constexpr (std::same_as<std::invoke_result_t<Work>, void>) {
        work();
        return {};
      } else {
        return work();
      }
    } catch (const Refused& refused) {
      return refused.error;
    } catch (const SqlFailure& failure) {
      return errorOf(failure);
    }
  }
  /// This whole database into another file (SQLite's backup), page by page.
  void copyTo(const std::filesystem::path& file) const;
  const std::filesystem::path& file() const { return file_; }
  bool readOnly() const { return read_only_; }

 private:
  class Scope {
   public:
    Scope(Database& database, const char* begin);
    ~Scope();
    void commit();

   private:
    Database& database_;
    bool open_ = true;
  };
  template <class Work>
  auto within(const char* begin, Work work) -> Result<std::invoke_result_t<Work>> {
    return asResult([&] {
      Scope scope(*this, begin);
      if constexpr (std::same_as<std::invoke_result_t<Work>, void>) {
        work();
        scope.commit();
      } else {
        auto value = work();
        scope.commit();
        return value;
      }
    });
  }
  Database(std::filesystem::path file, Mode mode, Waiting waiting);
  Result<void> notUnderRepair() const;
  Result<void> connect(const std::string& name, int flags);
  Result<void> connectWhereNothingCanBeWritten();
  Result<void> connectToCopy();
  Error errorOf(const SqlFailure& failure) const;
  void exec(const char* text) const;
  Statement prepared(std::string_view text);

  struct Prepared;
  sqlite3* handle_ = nullptr;
  std::filesystem::path file_;
  bool read_only_;
  Waiting waiting_;
  std::optional<ScratchFolder> scratch_;  ///< of a copy that this connection alone reads
  std::unordered_map<std::string, std::unique_ptr<Prepared>> prepared_;
  std::string stored_in_;  ///< by the statement that was prepared last
  int depth_ = 0;
};

/// A value, or Refused with its error.
template <class T>
T valueOrThrow(Result<T> result) {
  if (!result) throw Refused(result.error());
  return std::move(*result);
}
inline void valueOrThrow(const Result<void>& result) {
  if (!result) throw Refused(result.error());
}

}  // namespace ostraka::store
