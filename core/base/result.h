#pragma once
#include <cassert>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "base/message.h"

namespace ostraka {

/// Why something expected went wrong. Callers branch on the code; people read the sentence.
enum class ErrorCode {
  Cancelled,      ///< the person asked to stop
  UnusableInput,  ///< a file or a value that cannot be used; exit status 2
  CannotWrite,    ///< disk full, no permission, folder taken
  NotEnough,      ///< readable, but too little to compute from (markers, views, points)
  Missing,        ///< an optional program or device is absent
  Failed,         ///< a computation failed
  Damaged         ///< a file of the program itself was changed; it can be repaired
};

/// One sentence for a person: what happened and what to do; `where` names the file or device.
struct Error {
  ErrorCode code = ErrorCode::Failed;
  Message what;
  std::string where;

  static Error cancelled() { return {ErrorCode::Cancelled, message("Cancelled."), {}}; }
  static Error unusable(Message what, std::string where = {}) {
    return {ErrorCode::UnusableInput, std::move(what), std::move(where)};
  }
  static Error notEnough(Message what, std::string where = {}) {
    return {ErrorCode::NotEnough, std::move(what), std::move(where)};
  }
  static Error missing(Message what, std::string where = {}) {
    return {ErrorCode::Missing, std::move(what), std::move(where)};
  }
  static Error failed(Message what, std::string where = {}) {
    return {ErrorCode::Failed, std::move(what), std::move(where)};
  }
  /// Undo and redo write only where the field still holds what their step left.
  static Error changedMeanwhile(std::string_view field, std::string where = {}) {
    return unusable(
        message("The field %1 was changed meanwhile; nothing was undone or redone.", field),
        std::move(where));
  }
  /// "where: what", or just what.
  Message sentence() const { return where.empty() ? what : about(where, what); }
};

/// A value or an Error, with the names of C++23's std::expected, which replaces it later.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  bool has_value() const { return state_.index() == 0; }
  explicit operator bool() const { return has_value(); }
  T& value() & { return *std::get_if<0>(&state_); }
  const T& value() const& { return *std::get_if<0>(&state_); }
  T&& value() && { return std::move(*std::get_if<0>(&state_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  const Error& error() const {
    assert(!has_value());
    return *std::get_if<1>(&state_);
  }

 private:
  std::variant<T, Error> state_;
};

template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)), failed_(true) {}

  bool has_value() const { return !failed_; }
  explicit operator bool() const { return has_value(); }
  const Error& error() const {
    assert(failed_);
    return error_;
  }

 private:
  Error error_;
  bool failed_ = false;
};

}  // namespace ostraka
