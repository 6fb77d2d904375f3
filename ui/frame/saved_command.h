#pragma once
#include <QUndoCommand>
#include <functional>

#include "base/result.h"

namespace ostraka::ui {

/// A change of data that was saved before its command was made. redo and undo save ids and values
/// that they hold; what cannot be saved leaves the stack, and failed is told the sentence why.
class SavedCommand final : public QUndoCommand {
 public:
  using Save = std::function<Result<void>()>;
  SavedCommand(const QString& title, Save redo, Save undo,
               std::function<void(const QString&)> failed);
  void redo() override;
  void undo() override { save(undo_); }

 private:
  void save(const Save& change);

  Save redo_, undo_;
  std::function<void(const QString&)> failed_;
  bool first_ = true;
};

}  // namespace ostraka::ui
