#pragma once
#include <QObject>
#include <QPointer>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "catalogue/catalogue.h"
#include "records/records.h"
#include "records/sherd.h"
#include "ui/jobs/job.h"

namespace ostraka::ui {

class ProjectSession;

/// Saves changes of sherds at once, so that they can be undone; each step is a row of the history.
/// Few are saved before the call returns; many by a worker, one such change at a time, which ends
/// its work when the project is closed meanwhile.
class SherdEdits final : public QObject {
  Q_OBJECT

 public:
  static constexpr std::size_t kAtOnce = 50;  ///< of a call; more are many

  explicit SherdEdits(ProjectSession& session, QObject* parent = nullptr);

  /// Empty when it was saved, or is being saved, else the sentence why not. note: what a person
  /// has to know when it is saved.
  QString change(const QString& title, const std::vector<records::FieldChange>& changes,
                 const QString& note = {});
  /// What an import saved already, so that it can be undone, too.
  void took(const QString& title, const std::vector<records::FieldChange>& done,
            const std::vector<records::FieldChange>& undo);
  /// Gives those of them that are drafts their numbers. The sentence, or empty.
  QString assignNumbers(const std::vector<store::SherdRow>& sherds);

  bool isBusy() const { return job_ != nullptr; }  ///< many are being changed
  double fraction() const { return job_ ? job_->progress().fraction : 0; }
  void stop();  ///< what was changed of the many is taken back

 signals:
  void changed(const std::vector<store::SherdRow>& sherds);
  void failed(const QString& sentence);  ///< changing many was refused
  void noted(const QString& sentence);   ///< it is saved, and this came with it
  void busyChanged();                    ///< began, went on, ended

 private:
  using Changes = std::vector<records::FieldChange>;
  struct Made {
    Changes done, undo;
  };
  using Making = std::function<Result<Changes>(const catalogue::Catalogue&)>;
  using Failing = std::function<void(const Error&)>;
  void changeMany(const Making& making, std::function<void(const Made&)> then,
                  Failing failing = {});
  Result<void> save(const Changes& changes);
  void push(const QString& title, const Changes& done, const Changes& undo);
  void tell(const Changes& changes);
  void takeStepBack(int index, const Error& why);
  QString busyWords() const;

  ProjectSession& session_;
  QPointer<JobHandle> job_;
  std::optional<Result<void>> step_;  ///< what a step of many came to, while it is taken back
  std::stop_source stop_;             ///< of what a person stops; what nobody stops is finished
};

}  // namespace ostraka::ui
