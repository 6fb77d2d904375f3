#include "ui/wizard/rig_connection.h"

#include <utility>

#include "ui/frame/project_session.h"
#include "ui/jobs/when_done.h"
#include "ui/wizard/capture_wizard.h"

namespace ostraka::ui {

RigConnection::RigConnection(QObject* parent) : QObject(parent) {
  connect(&question_, &Question::asked, this, &RigConnection::changed);
  connect(&question_, &Question::settled, this, &RigConnection::changed);
}

RigConnection::~RigConnection() = default;

void RigConnection::setSession(ProjectSession* session) {
  dropJob(work_);
  dropJob(preview_);
  after_preview_ = {};
  waiting_.reset();
  previous_.reset();
  devices_.reset();
  forgetHolders();
  session_ = session;
}

void RigConnection::clear() {
  choose({});
}

// Whatever runs now goes on with the devices that it has.
void RigConnection::choose(RigSource source) {
  waiting_ = std::move(source);
  if (isBusy()) return emit waited();
  takeWaiting();
}

void RigConnection::restore() {
  if (previous_ && !isBusy()) choose(*std::exchange(previous_, std::nullopt));
}

void RigConnection::forgetPrevious() {
  previous_.reset();
  emit changed();
}

bool RigConnection::takeWaiting() {
  if (!waiting_ || isBusy()) return false;
  if (devices_ != nullptr && source_.open) previous_ = source_;
  source_ = *std::exchange(waiting_, std::nullopt);
  devices_.reset();
  emit taken();
  return true;
}

int RigConnection::cameras() const {
  return devices_ == nullptr ? 0 : static_cast<int>(devices_->cameras.size());
}

// Batches that were imported since took the number that the next one was going to have.
bool RigConnection::isFor(int batch) const {
  return !source_.anew_for_each_batch || opened_for_ == batch;
}

void RigConnection::open(int batch) {
  opened_for_ = batch;
  whenFree([this] {
    start(makeJob([open = source_.open, ask = question_.asker(), batch = opened_for_](
                      Progress&, std::stop_token stop) { return open(batch, ask, stop); }),
          [this](const JobOutcome& outcome) {
            if (!takeWaiting())
              takeDevices(outcomeAs<std::shared_ptr<capture::RigDevices>>(outcome));
          });
  });
}

void RigConnection::takeDevices(const Result<std::shared_ptr<capture::RigDevices>>& devices) {
  if (!devices && previous_) {
    emit tried(devices.error());
    return choose(*std::exchange(previous_, std::nullopt));
  }
  if (!devices) return emit failed(devices.error());
  devices_ = *devices;
  previous_.reset();
  emit tried({});
  emit opened();
}

void RigConnection::preview(Job job, Done done) {
  if (session_ == nullptr || isBusy() || preview_ != nullptr) return;
  preview_ = session_->jobs().start(std::move(job), this);
  connect(preview_, &JobHandle::finished, preview_, &QObject::deleteLater);
  connect(preview_, &JobHandle::finished, this,
          [this, done = std::move(done)](const JobOutcome& outcome) {
            preview_ = nullptr;
            if (after_preview_) return std::exchange(after_preview_, nullptr)();
            done(outcome);
          });
}

void RigConnection::whenFree(std::function<void()> act) {
  emit begun();
  if (preview_ == nullptr) return act();
  preview_->cancel();
  after_preview_ = std::move(act);
  emit changed();
}

JobHandle* RigConnection::start(Job job, Done done) {
  stopping_ = false;
  work_ = session_->jobs().start(std::move(job), this);
  connect(work_, &JobHandle::finished, work_, &QObject::deleteLater);
  connect(work_, &JobHandle::finished, this,
          [this, done = std::move(done)](const JobOutcome& outcome) {
            work_ = nullptr;
            done(outcome);
          });
  return work_;
}

JobHandle* RigConnection::work(Job job, Done done) {
  return start(std::move(job), [this, done = std::move(done)](const JobOutcome& outcome) {
    done(outcome);
    takeWaiting();
  });
}

void RigConnection::cancel() {
  question_.answer(false);
  if (work_ != nullptr) {
    stopping_ = true;
    emit changed();
    return work_->cancel();
  }
  after_preview_ = {};  // it has not begun
  if (!takeWaiting()) emit failed(Error::cancelled());
}

// Desktops open cameras as soon as they are plugged in; then the one button is to release them.
void RigConnection::findHolders() {
  if (session_ == nullptr || !source_.holders) return;
  holders_job_ =
      session_->jobs().start(makeJob([holders = source_.holders](Progress&, std::stop_token)
                                         -> Result<std::vector<std::string>> { return holders(); }),
                             this);
  whenDone<std::vector<std::string>>(holders_job_, this, [this](const auto& found) {
    if (!found || found->empty() || isBusy()) return;
    for (const std::string& holder : *found) holders_ << QString::fromStdString(holder);
    emit changed();
  });
}

void RigConnection::forgetHolders() {
  dropJob(holders_job_);
  holders_.clear();
}

void RigConnection::release() {
  forgetHolders();
  start(makeJob(
            [release = source_.release](Progress&, std::stop_token stop) { return release(stop); }),
        [this](const JobOutcome& outcome) {
          if (takeWaiting()) return;
          if (const Result<void> done = outcomeAs<void>(outcome); !done)
            return emit failed(done.error());
          emit released();
        });
  emit changed();
}

}  // namespace ostraka::ui
