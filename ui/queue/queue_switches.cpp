#include "ui/queue/queue_switches.h"

#include "ui/frame/project_session.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

using catalogue::QueuePause;

constexpr const char* kDraftsKey = "queue.drafts";

constexpr const char* kOn = "yes";

}  // namespace

void QueueSwitches::setSession(ProjectSession* session) {
  session_ = session;
  trouble_.clear();
  pause_ = QueuePause::None;
  if (session == nullptr) return;
  if (const auto kept = catalogue::queuePause(session->project().catalogue())) pause_ = *kept;
  drafts_ = session->setting(kDraftsKey) == kOn;
}

void QueueSwitches::stopFor(const QString& trouble) {
  pause_ = QueuePause::ByPerson;
  trouble_ = trouble;
}

void QueueSwitches::setPaused(bool paused) {
  if (session_ == nullptr || paused == isPaused()) return;
  pause_ = paused ? QueuePause::ByPerson : QueuePause::None;
  trouble_.clear();
  (void)catalogue::setQueuePause(session_->project().catalogue(), pause_, session_->provenance());
  emit pausedChanged(paused);
}

void QueueSwitches::setMakesDrafts(bool drafts) {
  if (session_ == nullptr || drafts == drafts_) return;
  drafts_ = drafts;
  session_->keepSetting(kDraftsKey, drafts ? kOn : "");
}

}  // namespace ostraka::ui
