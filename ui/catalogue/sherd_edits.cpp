#include "ui/catalogue/sherd_edits.h"

#include <QUndoStack>

#include "catalogue/project.h"
#include "ui/frame/project_session.h"

namespace ostraka::ui {

/// Ids and values only; what undoes it comes from the catalogue each time.
class SherdEditCommand final : public QUndoCommand {
 public:
  SherdEditCommand(SherdEdits& edits, const QString& title,
                   std::vector<catalogue::FieldChange> done,
                   std::vector<catalogue::FieldChange> undo)
      : QUndoCommand(title), edits_(edits), redo_(std::move(done)), undo_(std::move(undo)) {}

  void redo() override {
    if (first_)
      first_ = false;  // it was saved before the command was made
    else
      apply(redo_);
  }
  void undo() override { apply(undo_); }

 private:
  void apply(const std::vector<catalogue::FieldChange>& changes) {
    const auto done = edits_.session_.project().catalogue().change(changes, edits_.act());
    if (!done) {
      setObsolete(true);
      emit edits_.failed(QString::fromStdString(done.error().sentence()));
      return;
    }
    std::vector<catalogue::SherdRow> sherds;
    for (const catalogue::FieldChange& change : changes) sherds.push_back(change.sherd);
    emit edits_.changed(sherds);
    edits_.session_.tellSherdsChanged();
  }

  SherdEdits& edits_;
  std::vector<catalogue::FieldChange> redo_, undo_;
  bool first_ = true;
};

SherdEdits::SherdEdits(ProjectSession& session, QObject* parent)
    : QObject(parent), session_(session) {}

catalogue::Act SherdEdits::act() const {
  catalogue::Act act;
  const std::string initials = session_.initials().toStdString();
  const auto persons = session_.project().catalogue().persons();
  if (persons)
    for (const catalogue::PersonRecord& person : *persons)
      if (person.initials == initials) act.person = person.row;
  if (!act.person && !initials.empty()) {
    const auto added = session_.project().catalogue().save(
        catalogue::PersonRecord{{}, {}, initials, initials, {}}, act);
    if (added) act.person = *added;
  }
  return act;
}

QString SherdEdits::change(const QString& title,
                           const std::vector<catalogue::FieldChange>& changes) {
  const auto undo = session_.project().catalogue().change(changes, act());
  if (!undo) return QString::fromStdString(undo.error().sentence());
  if (undo->empty()) return {};
  session_.undo().push(new SherdEditCommand(*this, title, changes, *undo));
  std::vector<catalogue::SherdRow> sherds;
  for (const catalogue::FieldChange& change : changes) sherds.push_back(change.sherd);
  emit changed(sherds);
  session_.tellSherdsChanged();
  return {};
}

QString SherdEdits::assignNumbers(const std::vector<catalogue::SherdRow>& sherds) {
  const auto numbers = session_.project().catalogue().proposeNumbers(sherds);
  if (!numbers) return QString::fromStdString(numbers.error().sentence());
  std::vector<catalogue::FieldChange> changes;
  for (std::size_t i = 0; i < sherds.size(); ++i)
    changes.push_back({sherds[i], "number", (*numbers)[i]});
  return change(tr("number %n sherd(s)", nullptr, static_cast<int>(sherds.size())), changes);
}

}  // namespace ostraka::ui
