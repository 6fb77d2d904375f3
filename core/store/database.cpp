#include "store/database.h"

#include <fcntl.h>
#include <sqlite3.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <list>
#include <thread>

#include "base/message.h"
#include "base/text.h"
#include "files/files.h"
#include "store/file_header.h"
#include "store/page_checksums.h"
#include "store/values.h"

namespace ostraka::store {

namespace fs = std::filesystem;

void refuse(Message what, std::string where) {
  throw Refused(Error::unusable(std::move(what), std::move(where)));
}

// A text may be asked for again while it is still being read; then it is prepared once more.
struct Database::Prepared {
  struct One {
    sqlite3_stmt* handle = nullptr;
    bool busy = false;
    std::string stores_in = {};
  };
  std::list<One> all;
  ~Prepared() {
    for (One& one : all) sqlite3_finalize(one.handle);
  }
};

Statement::Statement(Statement&& other) noexcept
    : handle_(std::exchange(other.handle_, nullptr)),
      busy_(other.busy_),
      stores_in_(other.stores_in_),
      bound_(other.bound_),
      column_(other.column_) {}

Statement::~Statement() {
  if (!handle_) return;
  sqlite3_reset(handle_);
  sqlite3_clear_bindings(handle_);
  *busy_ = false;
}

void Statement::check(int code) const {
  if (code == SQLITE_OK) return;
  sqlite3* database = sqlite3_db_handle(handle_);
  throw SqlFailure(sqlite3_extended_errcode(database), sqlite3_errmsg(database));
}

bool Statement::next() {
  column_ = 0;
  const int code = sqlite3_step(handle_);
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  check(code);
  return false;
}

Statement& Statement::withRow(const Statement& row) {
  for (int i = 0; i < sqlite3_column_count(row.handle_); ++i)
    check(sqlite3_bind_value(handle_, ++bound_, sqlite3_column_value(row.handle_, i)));
  return *this;
}

bool Statement::columnIsNull() const {
  return sqlite3_column_type(handle_, column_) == SQLITE_NULL;
}

Statement& Statement::operator>>(std::string& value) {
  const unsigned char* text = sqlite3_column_text(handle_, column_);
  value.assign(text ? reinterpret_cast<const char*>(text) : "",
               text ? static_cast<std::size_t>(sqlite3_column_bytes(handle_, column_)) : 0);
  ++column_;
  return *this;
}
Statement& Statement::operator>>(char& value) {
  std::string text;
  *this >> text;
  if (!text.empty()) value = text[0];
  return *this;
}
Statement& Statement::operator>>(std::int64_t& value) {
  value = sqlite3_column_int64(handle_, column_++);
  return *this;
}
Statement& Statement::operator>>(int& value) {
  value = static_cast<int>(sqlite3_column_int64(handle_, column_++));
  return *this;
}
Statement& Statement::operator>>(bool& value) {
  value = sqlite3_column_int64(handle_, column_++) != 0;
  return *this;
}
Statement& Statement::operator>>(double& value) {
  value = sqlite3_column_double(handle_, column_++);
  return *this;
}

void Statement::readText(std::string& value) {
  if (sqlite3_column_type(handle_, column_) == SQLITE_FLOAT) {
    double number = 0;
    *this >> number;
    value = numberText(number);
  } else {
    *this >> value;
  }
}

void Statement::bind(int index, std::string_view value) {
  if (!stores_in_.empty())
    if (const Result<void> good = checkText(value); !good)
      refuse(good.error().what, std::string(stores_in_));
  check(sqlite3_bind_text64(handle_, index, value.data() ? value.data() : "", value.size(),
                            SQLITE_TRANSIENT, SQLITE_UTF8));
}
void Statement::bind(int index, std::int64_t value) {
  check(sqlite3_bind_int64(handle_, index, value));
}
void Statement::bind(int index, double value) {
  if (!stores_in_.empty() && !std::isnan(value))  // which SQLite stores as NULL
    if (const Result<void> good = checkFinite(value); !good)
      refuse(good.error().what, std::string(stores_in_));
  check(sqlite3_bind_double(handle_, index, value));
}
void Statement::bind(int index, std::nullptr_t) {
  check(sqlite3_bind_null(handle_, index));
}

// SQLite wakes nobody who waits for the right to write, and its own pauses grow to 100 ms: longer
// than a person should wait for a decision to be saved, and than many short writers leave room.
static int lookAgain(void* of, int times) {
  constexpr auto kPause = std::chrono::milliseconds(2);
  constexpr int kTimes = 5000, kTimesUnsaid = 250;
  const Waiting& waiting = *static_cast<const Waiting*>(of);
  if (times >= kTimes || waiting.stop.stop_requested()) return 0;
  if (times == kTimesUnsaid && waiting.progress != nullptr)
    waiting.progress->note(
        NoteLevel::Warning,
        message("Another program is repairing or using the catalogue; this one waits "
                "up to 10 seconds."));
  std::this_thread::sleep_for(kPause);
  return 1;
}

Database::Database(fs::path file, Mode mode, Waiting waiting)
    : file_(std::move(file)), read_only_(mode == Mode::ReadOnly), waiting_(std::move(waiting)) {}

Database::~Database() {
  prepared_.clear();
  sqlite3_close(handle_);
}

// As a URI names it, for what only URIs can say.
static std::string immutableUriOf(const fs::path& file) {
  std::string uri = "file:";
  for (const char c : fs::absolute(file).string()) {
    if (c == '?' || c == '#' || c == '%') {
      uri += c == '?' ? "%3f" : c == '#' ? "%23" : "%25";
    } else {
      uri += c;
    }
  }
  return uri + "?immutable=1";
}

// SQLite asks, while it prepares a statement, whether it may insert into a table or change it; it
// may, and here it is learnt which one, its triggers and temporary tables apart.
static int noteTable(void* stored_in, int action, const char* table, const char* /*column*/,
                     const char* schema, const char* trigger) {
  const bool stores = action == SQLITE_INSERT || action == SQLITE_UPDATE;
  if (stores && trigger == nullptr && schema != nullptr && std::string_view(schema) == "main")
    *static_cast<std::string*>(stored_in) = table;
  return SQLITE_OK;
}

Result<void> Database::connect(const std::string& name, int flags) {
  sqlite3_close(std::exchange(handle_, nullptr));
  if (sqlite3_open_v2(name.c_str(), &handle_, flags | SQLITE_OPEN_EXRESCODE, checkedPagesVfs()) ==
      SQLITE_OK) {
    sqlite3_busy_handler(handle_, lookAgain, &waiting_);
    sqlite3_set_authorizer(handle_, noteTable, &stored_in_);
    return {};
  }
  return Error::unusable(
      message("The catalogue cannot be opened; check that the folder exists and is writable."),
      file_.string());
}

// SQLite writes beside a catalogue that others may change (the WAL's index). Where it cannot:
// nobody changes what has no WAL; what others have open is read together with them; and what was
// left with a WAL is read from a copy.
Result<void> Database::connectWhereNothingCanBeWritten() {
  std::error_code ignored;
  const fs::path wal = file_.string() + "-wal", index = file_.string() + "-shm";
  const bool has_wal = fs::exists(wal, ignored) && fs::file_size(wal, ignored) > 0;
  if (!has_wal && !fs::exists(index, ignored))
    return connect(immutableUriOf(file_), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
  if (Result<void> opened = connect(file_.string(), SQLITE_OPEN_READONLY); !opened) return opened;
  if (asResult([&] { exec("SELECT count(*) FROM sqlite_schema"); })) return {};
  return connectToCopy();
}

Result<void> Database::connectToCopy() {
  Result<ScratchFolder> made = ScratchFolder::make("ostraka-catalogue");
  std::error_code failed;
  if (made) {
    scratch_.emplace(std::move(*made));
    for (const char* part : {"", "-wal"})
      if (!failed && fs::exists(file_.string() + part))
        fs::copy_file(file_.string() + part,
                      (scratch_->path() / "catalogue.sqlite").string() + part, failed);
  }
  if (!made || failed)
    return Error{
        ErrorCode::CannotWrite,
        message("This project is read-only, and there is no space for the copy that Ostraka "
                "reads; free some space in the folder for temporary files."),
        file_.string()};
  if (Result<void> opened = connect(scratch_->path() / "catalogue.sqlite", SQLITE_OPEN_READWRITE);
      !opened)
    return opened;
  return asResult([&] { exec("PRAGMA query_only = ON"); });
}

Result<std::unique_ptr<Database>> Database::open(const fs::path& file, Mode mode, Waiting waiting) {
  if (mode != Mode::Create)
    if (const Result<void> good = checkHeader(file); !good) return good.error();
  std::unique_ptr<Database> database(new Database(file, mode, std::move(waiting)));
  Result<void> opened;
  if (mode != Mode::ReadOnly)
    opened = database->connect(
        file.string(), SQLITE_OPEN_READWRITE | (mode == Mode::Create ? SQLITE_OPEN_CREATE : 0));
  else if (mayBeWritten(fs::absolute(file).parent_path()))
    opened = database->connect(file.string(), SQLITE_OPEN_READONLY);
  else
    opened = database->connectWhereNothingCanBeWritten();
  if (!opened) return opened.error();
  const Result<void> prepared = database->asResult([&] {
    int reserved = static_cast<int>(kReservedBytes);
    if (mode == Mode::Create)
      sqlite3_file_control(database->handle_, "main", SQLITE_FCNTL_RESERVE_BYTES, &reserved);
    database->exec("PRAGMA foreign_keys = ON");
    database->exec("PRAGMA recursive_triggers = ON");
    database->exec("PRAGMA cache_size = -64000");
    database->exec("PRAGMA temp_store = MEMORY");
    // After a power cut the newest decision must still be there.
    if (mode != Mode::ReadOnly) database->exec("PRAGMA synchronous = FULL");
  });
  if (!prepared) return prepared.error();
  if (Result<void> good =
          mode == Mode::Create ? database->writeAhead() : database->notUnderRepair();
      !good)
    return good.error();
  return database;
}

Result<void> Database::writeAhead() {
  const Result<void> set = asResult([&] { exec("PRAGMA journal_mode = WAL"); });
  return set ? notUnderRepair() : set;
}

// Asked for once this connection keeps a repair from beginning: with a WAL, as long as it lives.
Result<void> Database::notUnderRepair() const {
  if (std::error_code none; fs::exists(fs::symlink_status(repairedBeside(file_), none)))
    return damagedCatalogue(message("its repair was interrupted"), file_);
  return {};
}

void Database::exec(const char* text) const {
  if (sqlite3_exec(handle_, text, nullptr, nullptr, nullptr) != SQLITE_OK)
    throw SqlFailure(sqlite3_extended_errcode(handle_), sqlite3_errmsg(handle_));
}

void Database::script(const std::string& text) {
  exec(text.c_str());
}

Statement Database::prepared(std::string_view text) {
  std::unique_ptr<Prepared>& kept = prepared_[std::string(text)];
  if (!kept) kept = std::make_unique<Prepared>();
  for (Prepared::One& one : kept->all)
    if (!one.busy) return {one.handle, &one.busy, one.stores_in};
  Prepared::One one;
  stored_in_.clear();
  if (sqlite3_prepare_v3(handle_, text.data(), static_cast<int>(text.size()),
                         SQLITE_PREPARE_PERSISTENT, &one.handle, nullptr) != SQLITE_OK)
    throw SqlFailure(sqlite3_extended_errcode(handle_), sqlite3_errmsg(handle_));
  if (!sqlite3_stmt_readonly(one.handle) && !holdsSystemNames(stored_in_))
    one.stores_in = stored_in_;
  Prepared::One& added = kept->all.emplace_back(std::move(one));
  return {added.handle, &added.busy, added.stores_in};
}

std::int64_t Database::lastRow() const {
  return sqlite3_last_insert_rowid(handle_);
}
int Database::changes() const {
  return sqlite3_changes(handle_);
}

Database::Scope::Scope(Database& database, const char* begin) : database_(database) {
  database_.exec(database_.depth_ == 0 ? begin : "SAVEPOINT part");
  ++database_.depth_;
}

void Database::Scope::commit() {
  database_.exec(database_.depth_ == 1 ? "COMMIT" : "RELEASE part");
  --database_.depth_;
  open_ = false;
}

Database::Scope::~Scope() {
  if (!open_) return;
  --database_.depth_;
  try {
    if (database_.depth_ > 0)
      database_.exec("ROLLBACK TO part; RELEASE part");
    else if (sqlite3_get_autocommit(database_.handle_) == 0)
      database_.exec("ROLLBACK");
  } catch (const SqlFailure&) {
    // SQLite has rolled it back by itself (a full disk does that).
  }
}

// SQLite calls a disk full that takes no more bytes, but not one that takes no more files: it tries
// to open what could not be made for reading, and says that it is not there.
// A limit of file sizes shows only behind what the catalogue or its WAL has by now.
static bool isFullBeside(const fs::path& catalogue) {
  constexpr std::uintmax_t kLargestPage = 65536;
  rlimit limit{};
  // Without one a single byte is asked for: some file systems fill what lies before it.
  const bool limited = ::getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  std::uintmax_t behind = limited ? kLargestPage : 0;
  for (const char* ending : {"", "-wal"}) {
    if (!limited) break;
    std::error_code none;
    const std::uintmax_t bytes = fs::file_size(catalogue.string() + ending, none);
    if (!none) behind = std::max(behind, bytes + kLargestPage);
  }
  const std::string file =
      catalogue.parent_path() / (".room." + std::to_string(::getpid()) + ".partial");
  const int made = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
  bool full = made < 0 && isFullDisk(errno);
  if (made < 0) return full;
  full = ::pwrite(made, "?", 1, static_cast<off_t>(behind)) != 1 && isFullDisk(errno);
  ::close(made);
  ::unlink(file.c_str());
  return full;
}

static Error errorAt(const SqlFailure& failure, const fs::path& file) {
  if (failure.code == SQLITE_IOERR_DATA)
    return damagedCatalogue(message("a page was changed"), file);
  const int kind = failure.code & 0xFF;
  // Moved: a repair has put another file in its place.
  if (failure.code == SQLITE_READONLY_DBMOVED || kind == SQLITE_BUSY || kind == SQLITE_LOCKED)
    return {ErrorCode::Failed,
            message("Another program is using the catalogue; close it, then try again."),
            file.string()};
  if (kind == SQLITE_FULL ||
      ((kind == SQLITE_CANTOPEN || kind == SQLITE_IOERR) && isFullBeside(file)))
    return {ErrorCode::CannotWrite,
            message("The disk is full; free some space, then try again. No data was lost."),
            file.string()};
  switch (kind) {
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_CANTOPEN:
      return {ErrorCode::CannotWrite,
              message("The catalogue cannot be written to; check the permissions of the folder."),
              file.string()};
    case SQLITE_IOERR:
      return {ErrorCode::CannotWrite,
              message("The disk reports errors; check it, then reopen the project."),
              file.string()};
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return damagedCatalogue(message("its pages are inconsistent"), file);
    default:
      return Error::unusable(message("The catalogue rejects this operation (%1).", failure.what()),
                             file.string());
  }
}

Error Database::errorOf(const SqlFailure& failure) const {
  if ((failure.code & 0xFF) == SQLITE_BUSY && waiting_.stop.stop_requested())
    return Error::cancelled();
  return errorAt(failure, file_);
}

void Database::copyTo(const fs::path& file) const {
  sqlite3* target = nullptr;
  int code = sqlite3_open_v2(file.c_str(), &target, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE,
                             checkedPagesVfs());
  if (code == SQLITE_OK) {
    if (sqlite3_backup* backup = sqlite3_backup_init(target, "main", handle_, "main")) {
      code = sqlite3_backup_step(backup, -1);  // finishing says nothing of a database that is busy
      sqlite3_backup_finish(backup);
      if (code == SQLITE_DONE) code = SQLITE_OK;
    } else {
      code = sqlite3_extended_errcode(target);
    }
  }
  // The copy is one file, and its header says that it has no WAL (file_header.cpp).
  if (code == SQLITE_OK)
    code = sqlite3_exec(target, "PRAGMA journal_mode = DELETE", nullptr, nullptr, nullptr);
  const std::string text = sqlite3_errmsg(target);
  sqlite3_close(target);
  if (code == SQLITE_OK) return;
  const Error error = errorAt({code, text}, file);
  throw Refused(error.code == ErrorCode::CannotWrite ? error : errorOf({code, text}));
}

}  // namespace ostraka::store
