#include "ui/sherds/sherd_edits.h"

#include <QUndoStack>
#include <memory>

#include "records/sherd.h"
#include "sherds/many_changes.h"
#include "sherds/numbers.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherds.h"
#include "ui/frame/project_session.h"
#include "ui/frame/saved_command.h"
#include "ui/jobs/when_done.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

using Changes = std::vector<records::FieldChange>;

// Numbers for those that can have one; the others lack a part of it, mostly their context.
struct Numbers {
  Changes changes;
  int left = 0;
  Error why_left{};
};

Result<Numbers> numbersFor(const catalogue::Catalogue& catalogue,
                           const std::vector<store::SherdRow>& sherds) {
  const Result<std::vector<records::SherdRecord>> records = sherds::Sherds(catalogue).of(sherds);
  if (!records) return records.error();
  std::vector<store::SherdRow> drafts;
  for (const records::SherdRecord& sherd : *records)
    if (sherd.state == records::SherdState::Draft) drafts.push_back(sherd.row);
  Numbers made;
  if (drafts.empty()) return made;
  const int wanted = static_cast<int>(drafts.size());
  Result<std::vector<std::string>> numbers = sherds::Numbers(catalogue).propose(drafts);
  if (!numbers) {
    std::erase_if(drafts, [&](const store::SherdRow& draft) {
      const auto alone = sherds::Numbers(catalogue).propose(std::span(&draft, 1));
      if (!alone) made.why_left = alone.error();
      return !alone.has_value();
    });
    if (drafts.empty()) return numbers.error();
    made.left = wanted - static_cast<int>(drafts.size());
    numbers = sherds::Numbers(catalogue).propose(drafts);
    if (!numbers) return numbers.error();
  }
  for (std::size_t i = 0; i < drafts.size(); ++i)
    made.changes.push_back({drafts[i], "number", (*numbers)[i]});
  return made;
}

}  // namespace

SherdEdits::SherdEdits(ProjectSession& session, QObject* parent)
    : QObject(parent), session_(session) {}

QString SherdEdits::busyWords() const {
  return tr("Other changes are still being saved; wait for them, or stop them.");
}

Result<void> SherdEdits::save(const Changes& changes) {
  if (step_) return *step_;
  if (isBusy()) return Error{ErrorCode::CannotWrite, busyWords().toStdString(), {}};
  if (changes.size() > kAtOnce) {
    changeMany(
        [changes](const catalogue::Catalogue&) -> Result<Changes> { return changes; },
        [](const Made&) {},
        [this, index = session_.undo().index()](const Error& why) { takeStepBack(index, why); });
  } else {
    const auto done =
        sherds::SherdChanges(session_.project().catalogue()).apply(changes, session_.provenance());
    if (!done) return done.error();
    tell(changes);
  }
  return {};
}

// A step of many is known to fail only after the stack took it as done. Stopped by a person it can
// be done later; refused it leaves the stack.
void SherdEdits::takeStepBack(int index, const Error& why) {
  QUndoStack& stack = session_.undo();
  step_ = why.code == ErrorCode::Cancelled ? Result<void>() : why;
  if (stack.index() == index - 1) stack.redo();
  if (stack.index() == index + 1) stack.undo();
  step_.reset();
}

void SherdEdits::push(const QString& title, const Changes& done, const Changes& undo) {
  const auto saves = [this](const Changes& changes) {
    return [this, changes] { return save(changes); };
  };
  session_.undo().push(
      new SavedCommand(title, saves(sherds::changesAgain(done, undo)), saves(undo), session_));
}

void SherdEdits::tell(const Changes& changes) {
  std::vector<store::SherdRow> sherds;
  for (const records::FieldChange& change : changes) sherds.push_back(change.sherd);
  emit changed(sherds);
  session_.tellSherdsChanged();
}

QString SherdEdits::change(const QString& title, const Changes& changes, const QString& note) {
  if (isBusy()) return busyWords();
  if (changes.size() > kAtOnce) {
    changeMany([changes](const catalogue::Catalogue&) -> Result<Changes> { return changes; },
               [this, title, note](const Made& made) {
                 if (made.undo.empty()) return;
                 push(title, made.done, made.undo);
                 if (!note.isEmpty()) emit noted(note);
               });
    return {};
  }
  const auto undo =
      sherds::SherdChanges(session_.project().catalogue()).apply(changes, session_.provenance());
  if (!undo) return sentenceOf(undo.error());
  if (undo->empty()) return {};
  push(title, changes, *undo);
  tell(changes);
  if (!note.isEmpty()) emit noted(note);
  return {};
}

void SherdEdits::took(const QString& title, const Changes& done, const Changes& undo) {
  if (!undo.empty()) push(title, done, undo);
  session_.tellSherdsChanged();
}

QString SherdEdits::assignNumbers(const std::vector<store::SherdRow>& sherds) {
  if (isBusy()) return busyWords();
  const QString nothing = tr("The sherds that are chosen have their numbers.");
  const auto title = [](const Changes& changes) {
    return tr("numbering of %n sherd(s)", nullptr, static_cast<int>(changes.size()));
  };
  const auto leftWords = [](const Numbers& numbers) {
    if (numbers.left == 0) return QString();
    return tr("%n sherd(s) got no number: %1", nullptr, numbers.left)
        .arg(sentenceOf(numbers.why_left));
  };
  if (sherds.size() > kAtOnce) {
    const auto left = std::make_shared<Numbers>();  // written before the job ends, read after it
    changeMany(
        [sherds, left](const catalogue::Catalogue& catalogue) -> Result<Changes> {
          Result<Numbers> numbers = numbersFor(catalogue, sherds);
          if (!numbers) return numbers.error();
          *left = *numbers;
          return std::move(numbers->changes);
        },
        [this, title, nothing, left, leftWords](const Made& made) {
          if (made.undo.empty()) return emit failed(nothing);
          push(title(made.done), made.done, made.undo);
          if (left->left > 0) emit failed(leftWords(*left));
        });
    return {};
  }
  const Result<Numbers> numbers = numbersFor(session_.project().catalogue(), sherds);
  if (!numbers) return sentenceOf(numbers.error());
  if (numbers->changes.empty()) return nothing;
  const QString refused = change(title(numbers->changes), numbers->changes);
  return refused.isEmpty() ? leftWords(*numbers) : refused;
}

void SherdEdits::changeMany(const Making& making, std::function<void(const Made&)> then,
                            Failing failing) {
  stop_ = std::stop_source();
  const auto work = [folder = session_.folder(), making, provenance = session_.provenance(),
                     stop = stop_.get_token()](
                        Progress& progress,
                        std::stop_token) -> Result<std::shared_ptr<const Made>> {
    Result<catalogue::Catalogue> catalogue = upkeep::Project::connect(folder);
    if (!catalogue) return catalogue.error();
    Result<Changes> changes = making(*catalogue);
    if (!changes) return changes.error();
    Result<Changes> undo = sherds::changeMany(*catalogue, *changes, provenance, progress, stop);
    if (!undo) return undo.error();
    return std::make_shared<const Made>(Made{std::move(*changes), std::move(*undo)});
  };
  session_.undo().setActive(false);  // until it is known what there is to undo
  Job job = makeJob(work);
  job.is_promised = true;
  job_ = session_.jobs().start(std::move(job), this);
  connect(job_, &JobHandle::progressed, this, &SherdEdits::busyChanged);
  whenDone<std::shared_ptr<const Made>>(job_, this, [this, then, failing](const auto& made) {
    session_.undo().setActive(true);
    emit busyChanged();
    if (!made) {
      emit failed(made.error().code == ErrorCode::Cancelled ? tr("Cancelled. Nothing was changed.")
                                                            : sentenceOf(made.error()));
      if (failing) failing(made.error());
      return;
    }
    tell((*made)->done);
    then(**made);  // what it says stays
  });
  emit busyChanged();
}

void SherdEdits::stop() {
  stop_.request_stop();
}

}  // namespace ostraka::ui
