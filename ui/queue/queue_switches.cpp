#include "ui/queue/queue_switches.h"

#include "ui/frame/project_session.h"

namespace ostraka::ui {
namespace {

constexpr const char* kPausedKey = "queue.paused";
constexpr const char* kDraftsKey = "queue.drafts";

constexpr const char* kOn = "yes";

}  // namespace

void QueueSwitches::setSession(ProjectSession* session) {
  session_ = session;
  trouble_.clear();
  paused_ = session != nullptr && session->setting(kPausedKey) == kOn;
  if (session != nullptr) drafts_ = session->setting(kDraftsKey) == kOn;
}

void QueueSwitches::stopFor(const QString& trouble) {
  paused_ = true;
  trouble_ = trouble;
}

void QueueSwitches::setPaused(bool paused) {
  if (session_ == nullptr || paused == paused_) return;
  paused_ = paused;
  trouble_.clear();
  session_->keepSetting(kPausedKey, paused ? kOn : "");
  emit pausedChanged(paused);
}

void QueueSwitches::setMakesDrafts(bool drafts) {
  if (session_ == nullptr || drafts == drafts_) return;
  drafts_ = drafts;
  session_->keepSetting(kDraftsKey, drafts ? kOn : "");
}

}  // namespace ostraka::ui
