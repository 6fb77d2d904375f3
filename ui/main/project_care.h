#pragma once
#include <QObject>
#include <QPointer>
#include <QTimer>
#include <filesystem>

#include "base/result.h"

namespace ostraka::ui {

class JobHandle;
class JobRunner;

/// Looks after the open project while one works: how much room its disk has, copies of its
/// catalogue now and then, and at its beginning whether the catalogue and a share of the files are
/// whole, so that damage by a disk is known while there still are copies.
class ProjectCare final : public QObject {
  Q_OBJECT

 public:
  explicit ProjectCare(JobRunner& runner, QObject* parent = nullptr);

  void begin(const std::filesystem::path& folder, bool read_only);
  void end();  ///< and the check of its files
  void measureRoom();

 signals:
  void roomMeasured(int batches);  ///< how many more fit; -1: the disk does not say
  void said(const QString& sentence);
  void catalogueDamaged(const ostraka::Error& damage);

 private:
  void backUp();
  void checkFiles();

  JobRunner& runner_;
  std::filesystem::path folder_;  ///< empty: no project is open
  QTimer room_timer_, back_up_timer_;
  QPointer<JobHandle> check_;
};

}  // namespace ostraka::ui
