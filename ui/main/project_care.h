#pragma once
#include <QObject>
#include <QTimer>
#include <filesystem>

namespace ostraka::ui {

class JobRunner;

/// Looks after the open project while one works: how much room its disk has, and copies of its
/// catalogue now and then.
class ProjectCare final : public QObject {
  Q_OBJECT

 public:
  explicit ProjectCare(JobRunner& runner, QObject* parent = nullptr);

  void begin(const std::filesystem::path& folder, bool read_only);
  void end() { folder_.clear(); }
  void measureRoom();

 signals:
  void roomMeasured(int batches);  ///< how many more fit; -1: the disk does not say
  void said(const QString& sentence);

 private:
  void backUp();

  JobRunner& runner_;
  std::filesystem::path folder_;  ///< empty: no project is open
  QTimer room_timer_, back_up_timer_;
};

}  // namespace ostraka::ui
