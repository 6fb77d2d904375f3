#pragma once
#include <QObject>
#include <QString>
#include <QUndoStack>
#include <cstdint>
#include <filesystem>
#include <memory>

#include "base/result.h"

namespace ostraka::records {
struct Provenance;
}  // namespace ostraka::records

namespace ostraka::upkeep {
class Project;
}  // namespace ostraka::upkeep

namespace ostraka::ui {

class JobRunner;

/// The project that is open: its catalogue, what can be undone, who works on it, and the way to
/// long work. Screens get it handed in; what they change they tell here, so that the others see
/// it.
class ProjectSession final : public QObject {
  Q_OBJECT

 public:
  /// folder: PROJECT, which holds catalogue.sqlite, batches/Bnnnn, results/Bnnnn, backups/.
  ProjectSession(std::shared_ptr<upkeep::Project> project, std::filesystem::path folder,
                 JobRunner& runner, QObject* parent = nullptr);
  ~ProjectSession() override;

  /// False in tests of what needs no catalogue.
  bool hasProject() const { return project_ != nullptr; }
  /// The open project; for the thread of the window only. Jobs open their own with folder().
  upkeep::Project& project() { return *project_; }
  const std::filesystem::path& folder() const { return folder_; }
  QString whyReadOnly() const;  ///< a sentence; empty where it can be changed
  /// Its folder is where it was when it was opened: not moved, renamed or taken away with its disk.
  bool isThere() const;
  Error goneError() const;
  JobRunner& jobs() { return runner_; }
  QUndoStack& undo() { return undo_; }

  /// Who decides and edits, as in the history: "AP". Empty until the person said so.
  const QString& initials() const { return initials_; }
  void setInitials(const QString& initials);  ///< kept in capitals
  /// What the project remembers of the window under a key; empty: nothing.
  QString setting(const char* key) const;
  void keepSetting(const char* key, const QString& value);
  /// Where the window was left: nobody's act, so the history says nothing of it.
  void noteSetting(const char* key, const QString& value);

  /// Who does something now, for calls that change the catalogue. Makes the person's row when the
  /// project does not know the initials yet.
  records::Provenance provenance(const QString& why = {});

  /// To be called by who changed a batch or sherds; they emit the signals below.
  void tellBatchChanged(const QString& number) { emit batchChanged(number); }
  void tellSherdsChanged() { emit sherdsChanged(); }
  void tellVocabulariesChanged() { emit vocabulariesChanged(); }
  void tellStepRefused(const QString& sentence) { emit stepRefused(sentence); }

  /// Tells the pages when others wrote: another window, the command line, a worker. Done each
  /// kLook_ms.
  void lookForOthers();
  static constexpr int kLook_ms = 1000;

 signals:
  void batchChanged(const QString& number);  ///< "B0031": new, or its state or pairs changed
  void sherdsChanged();                      ///< rows of the catalogue are new or changed
  void othersWrote();                        ///< anything may be new or changed
  void vocabulariesChanged();                ///< the words or the numbering of sherds
  void initialsChanged(const QString& initials);
  /// Undo or redo could not be saved, and its step is gone. Whichever page it is about, the one in
  /// front shows it.
  void stepRefused(const QString& sentence);
  /// The catalogue did not take who works: what is done now has no name in the history.
  void personRefused(const QString& sentence);

 private:
  std::shared_ptr<upkeep::Project> project_;
  std::filesystem::path folder_;
  JobRunner& runner_;
  QUndoStack undo_;
  QString initials_;
  std::int64_t writes_of_others_ = 0;
  std::int64_t person_row_ = 0;  ///< of initials_; 0: not looked up yet
};

}  // namespace ostraka::ui
