#include "ui/queue/queue_switches.h"

#include "catalogue/settings.h"
#include "ui/frame/project_session.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

constexpr const char* kPausedKey = "queue.paused";
constexpr const char* kDraftsKey = "queue.drafts";

bool isOn(ProjectSession& session, const char* key) {
  const Result<std::string> kept = catalogue::Settings(session.project().catalogue()).value(key);
  return kept && *kept == "yes";
}

void keepSwitch(ProjectSession& session, const char* key, bool on) {
  (void)catalogue::Settings(session.project().catalogue()).setValue(key, on ? "yes" : "");
}

}  // namespace

QueueSwitches::QueueSwitches(QObject* parent) : QObject(parent) {}

void QueueSwitches::setSession(ProjectSession* session) {
  session_ = session;
  trouble_.clear();
  paused_ = session != nullptr && isOn(*session, kPausedKey);
  if (session != nullptr) drafts_ = isOn(*session, kDraftsKey);
}

void QueueSwitches::stopFor(const QString& trouble) {
  paused_ = true;
  trouble_ = trouble;
}

void QueueSwitches::setPaused(bool paused) {
  if (session_ == nullptr || paused == paused_) return;
  paused_ = paused;
  trouble_.clear();
  keepSwitch(*session_, kPausedKey, paused);
  emit pausedChanged(paused);
}

void QueueSwitches::setMakesDrafts(bool drafts) {
  if (session_ == nullptr || drafts == drafts_) return;
  drafts_ = drafts;
  keepSwitch(*session_, kDraftsKey, drafts);
}

}  // namespace ostraka::ui
