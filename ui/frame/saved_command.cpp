#include "ui/frame/saved_command.h"

#include <utility>

#include "ui/frame/project_session.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {

SavedCommand::SavedCommand(const QString& title, Save redo, Save undo, ProjectSession& session)
    : QUndoCommand(title), redo_(std::move(redo)), undo_(std::move(undo)), session_(session) {}

void SavedCommand::redo() {
  if (!std::exchange(first_, false)) save(redo_);
}

void SavedCommand::save(const Save& change) {
  const Result<void> done = change();
  if (done) return;
  setObsolete(true);
  session_.tellStepRefused(sentenceOf(done.error()));
}

}  // namespace ostraka::ui
