#pragma once
#include <QUndoCommand>
#include <functional>

#include "base/result.h"

namespace ostraka::ui {

class ProjectSession;

/// A change of data that was saved before its command was made. redo and undo save ids and values
/// that they hold; what cannot be saved leaves the stack, and the session tells the sentence why.
class SavedCommand final : public QUndoCommand {
 public:
  using Save = std::function<Result<void>()>;
  /// session: whose stack it is pushed on.
  SavedCommand(const QString& title, Save redo, Save undo, ProjectSession& session);
  void redo() override;
  void undo() override { save(undo_); }

 private:
  void save(const Save& change);

  Save redo_, undo_;
  ProjectSession& session_;
  bool first_ = true;
};

}  // namespace ostraka::ui
