#pragma once
#include <QObject>
#include <QUndoCommand>
#include <functional>
#include <vector>

#include "catalogue/catalogue.h"

namespace ostraka::ui {

class ProjectSession;

/// Saves changes of sherds at once, so that they can be undone; each step is a row of the history.
class SherdEdits final : public QObject {
  Q_OBJECT

 public:
  explicit SherdEdits(ProjectSession& session, QObject* parent = nullptr);

  /// Empty when it was saved, else the sentence why not.
  QString change(const QString& title, const std::vector<catalogue::FieldChange>& changes);
  /// Gives drafts their numbers. The sentence, or empty.
  QString assignNumbers(const std::vector<catalogue::SherdRow>& sherds);
  /// Who works now, as the history names it.
  catalogue::Act act() const;

 signals:
  void changed(const std::vector<catalogue::SherdRow>& sherds);
  void failed(const QString& sentence);  ///< undoing or redoing was refused

 private:
  friend class SherdEditCommand;
  ProjectSession& session_;
};

}  // namespace ostraka::ui
