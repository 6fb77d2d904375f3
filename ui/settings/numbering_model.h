#pragma once
#include <QObject>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <vector>

#include "base/result.h"
#include "ui/jobs/job.h"

namespace ostraka::records {
struct Provenance;
}  // namespace ostraka::records

namespace ostraka::ui {

class ProjectSession;

/// How the sherds of the open project are numbered from now on: the scheme with the live example of
/// a number, the block of numbers of this computer, and the numbers that were left out. What has a
/// number keeps it. No widget.
class NumberingModel final : public QObject {
  Q_OBJECT

 public:
  struct Numbering {
    QString scheme;
    int first = 1, last = kLastNumber;  ///< the block of this computer
    bool operator==(const Numbering&) const = default;
  };
  static constexpr int kLastNumber = 999'999'999;

  explicit NumberingModel(QObject* parent = nullptr) : QObject(parent) {}

  /// The session must stay until another one or none is set.
  void setSession(ProjectSession* session);
  bool hasProject() const { return session_ != nullptr; }
  const Numbering& numbering() const { return wanted_; }
  QString example() const { return example_; }
  /// Why it cannot be: a sentence; empty when it can.
  QString refusal() const { return refusal_; }
  /// What to mind: contexts whose sherds get no number so, codes that may be misread.
  QString warning() const { return warning_; }
  /// Numbers that were never given, a line for each context: "ARM1 T3 0012: 3, 5–7".
  const QStringList& gaps() const { return gaps_; }
  bool canApply() const { return hasProject() && refusal_.isEmpty() && !(wanted_ == held_); }

  /// Holds from now on; can be undone. Returns why not, or nothing.
  QString apply();

 public slots:
  void lookAgain();  ///< numbers were given since
  void setScheme(const QString& scheme);
  void setBlock(int first, int last);

 signals:
  void changed();
  void gapsChanged();

 private:
  Result<Numbering> stored() const;
  Result<void> store(const Numbering& numbering, const records::Provenance& provenance);
  void read();
  void follow();
  void lookForGaps();

  ProjectSession* session_ = nullptr;
  Numbering held_, wanted_;
  QString example_, refusal_, warning_;
  QStringList gaps_;
  QPointer<JobHandle> looking_;
};

/// "3, 5–7" for 3 5 6 7; the first `most` of them, then an ellipsis.
QString numberRanges(const std::vector<int>& numbers, int most);

}  // namespace ostraka::ui
