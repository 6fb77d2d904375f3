#pragma once
#include <QPointer>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "base/result.h"
#include "batch/batch.h"
#include "records/records.h"
#include "ui/import/place_text.h"
#include "ui/wizard/capture_facts.h"

namespace ostraka::ui {

class ProjectSession;

/// The batch that lies on the plate, as the catalogue keeps it: what a capture writes there, and
/// where one that was interrupted goes on. No widget, no device.
class BatchInHand {
 public:
  void setSession(ProjectSession* session);
  void forget();
  /// The newest whose photographs are not whole, or queued, yet; newer ones may have come from
  /// elsewhere since.
  void resume();
  /// This one, if its photographs are not whole yet.
  void resume(const QString& number);

  bool isThere() const { return row_ != 0; }
  const QString& number() const { return number_; }  ///< empty: it has not begun
  int index() const;  ///< 31 of B0031; of the next one before it has begun
  std::filesystem::path folder() const;
  /// Those of a side that its folder holds, by stop and camera.
  std::vector<TakenShot> photographs(batch::Side side) const;
  /// The same as files, by camera.
  std::vector<std::vector<std::filesystem::path>> files(batch::Side side, int cameras) const;
  records::BatchState state() const;
  bool isComputed() const;  ///< and be it as a draft
  /// Sherds that a person has counted; 0: not counted.
  int counted() const { return counted_; }
  void setCounted(int sherds) { counted_ = sherds; }

  PlaceText place() const;  ///< of its bag; empty: none
  /// Sherds of earlier plates that a person wants photographed again: "ARM1-T3-0012-0007 (B0003)".
  QStringList toPhotographAgain() const;

  /// Those typed on its sherds that its bag was changed under, and that are not as this bag's
  /// sherds are numbered; none once a person says that they are right.
  QStringList numbersOfAnotherBag() const;
  void takeNumbersAsRight() { of_another_bag_.clear(); }

  /// Makes it, with the place that its sherds are from, or keeps what came later of place and
  /// count.
  Result<void> begin(const PlaceText& place);
  Result<void> setState(records::BatchState state);
  /// Its photographs are whole. seen: sherds on the photographs, 0 when not known; what a person
  /// has counted goes before.
  Result<void> queue(int seen);

 private:
  void take(const records::BatchRecord& batch);
  QStringList numbersThatMayFit() const;

  QPointer<ProjectSession> session_;
  QString number_;
  std::int64_t row_ = 0;
  int counted_ = 0;
  QStringList of_another_bag_;
};

}  // namespace ostraka::ui
