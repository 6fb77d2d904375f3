#include "ui/jobs/question.h"

#include <condition_variable>
#include <mutex>
#include <optional>

#include "ui/words/sentence.h"

namespace ostraka::ui {

struct Question::Shared {
  std::mutex lock;
  std::condition_variable_any wake;
  Question* owner = nullptr;
  std::optional<bool> answer;
};

Question::Question(QObject* parent) : QObject(parent), shared_(std::make_shared<Shared>()) {
  shared_->owner = this;
}

Question::~Question() {
  const std::lock_guard guard(shared_->lock);
  shared_->owner = nullptr;
  shared_->answer = false;
  shared_->wake.notify_all();
}

std::function<bool(const Message&, std::stop_token)> Question::asker() const {
  return [shared = shared_](const Message& sentence, std::stop_token stop) {
    std::unique_lock guard(shared->lock);
    if (shared->owner == nullptr) return false;
    shared->answer.reset();
    QMetaObject::invokeMethod(
        shared->owner,
        [owner = shared->owner, words = wordsOf(sentence)] {
          owner->sentence_ = words;
          emit owner->asked(words);
        },
        Qt::QueuedConnection);
    shared->wake.wait(guard, stop, [&shared] { return shared->answer.has_value(); });
    const bool done = shared->answer.value_or(false);
    if (shared->owner != nullptr)
      QMetaObject::invokeMethod(
          shared->owner,
          [owner = shared->owner] {
            owner->sentence_.clear();
            emit owner->settled();
          },
          Qt::QueuedConnection);
    return done;
  };
}

void Question::answer(bool done) {
  {
    const std::lock_guard guard(shared_->lock);
    shared_->answer = done;
  }
  shared_->wake.notify_all();
}

}  // namespace ostraka::ui
