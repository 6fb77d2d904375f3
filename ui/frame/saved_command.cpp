#include "ui/frame/saved_command.h"

#include <utility>

#include "ui/words/sentence.h"

namespace ostraka::ui {

SavedCommand::SavedCommand(const QString& title, Save redo, Save undo,
                           std::function<void(const QString&)> failed)
    : QUndoCommand(title),
      redo_(std::move(redo)),
      undo_(std::move(undo)),
      failed_(std::move(failed)) {}

void SavedCommand::redo() {
  if (!std::exchange(first_, false)) save(redo_);
}

void SavedCommand::save(const Save& change) {
  const Result<void> done = change();
  if (done) return;
  setObsolete(true);
  failed_(sentenceOf(done.error()));
}

}  // namespace ostraka::ui
