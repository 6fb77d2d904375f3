#pragma once
#include "ui/widgets/message_panel.h"

namespace ostraka::ui {

class ProjectSession;
class Screen;

/// A screen that shows nothing before a batch is processed: capture one, or, where one is on its
/// way, look at the queue.
class NoBatchYet final : public EmptyState {
  Q_OBJECT

 public:
  /// words: what appears here, and when.
  NoBatchYet(const QString& icon_name, const QString& headline, const QString& words,
             Screen* screen);
  QPushButton* act() const { return act_; }
  /// The batches of the project have changed, perhaps.
  void follow(ProjectSession* session);

 private:
  QString first_words_, leads_to_;
  QPushButton* act_;
};

}  // namespace ostraka::ui
