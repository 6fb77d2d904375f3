#pragma once
#include <functional>
#include <optional>
#include <string>

#include "records/records.h"
#include "ui/frame/project_session.h"
#include "ui/frame/saved_command.h"
#include "upkeep/project.h"

namespace ostraka::ui {

/// A value of the open project's catalogue that a page changes as a whole.
template <class Value>
struct SavedValue {
  std::string field;  ///< as a refusal names it
  std::function<Result<Value>()> read;
  std::function<Result<void>(const Value&, const records::Provenance&)> write;
  std::function<void()> written;  ///< after each change: shows it
};

/// Saves the value, as a step that is undone and done again only where the catalogue still holds
/// what the step left.
template <class Value>
Result<void> saveValue(ProjectSession& session, const QString& title, const SavedValue<Value>& of,
                       const Value& value) {
  const auto change = [&session, of](const std::optional<Value>& expected, const Value& to) {
    // Before the transaction: the row of a new person stays where the value is refused.
    const records::Provenance provenance = session.provenance();
    std::optional<Value> before;
    const Result<void> done = session.project().catalogue().together([&]() -> Result<void> {
      Result<Value> now = of.read();
      if (!now) return now.error();
      if (expected && !(*now == *expected)) return Error::changedMeanwhile(of.field);
      before = std::move(*now);
      return of.write(to, provenance);
    });
    if (!done) return Result<Value>(done.error());
    of.written();
    return Result<Value>(std::move(*before));
  };
  const Result<Value> before = change({}, value);
  if (!before) return before.error();
  const auto step = [&change](const Value& from, const Value& to) {
    return [change, from, to]() -> Result<void> {
      const Result<Value> done = change(from, to);
      return done ? Result<void>() : done.error();
    };
  };
  session.undo().push(new SavedCommand(title, step(*before, value), step(value, *before), session));
  return {};
}

}  // namespace ostraka::ui
