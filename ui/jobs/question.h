#pragma once
#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <stop_token>

#include "base/message.h"

namespace ostraka::ui {

/// A job asks a person to do something ("Turn the table to mark 3.") and waits for the answer.
class Question final : public QObject {
  Q_OBJECT

 public:
  explicit Question(QObject* parent = nullptr);
  ~Question() override;

  /// For the job: blocks until answered; false when the answer is no, a stop was requested, or the
  /// question's owner is gone.
  std::function<bool(const Message& sentence, std::stop_token stop)> asker() const;
  /// What is asked now; empty when nothing is.
  const QString& sentence() const { return sentence_; }
  void answer(bool done);

 signals:
  void asked(const QString& sentence);
  void settled();  ///< answered, or the job stopped waiting

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
  QString sentence_;
};

}  // namespace ostraka::ui
