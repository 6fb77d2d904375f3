#pragma once
#include <QObject>
#include <QPointer>
#include <QStringList>
#include <vector>

#include "capture/shot_checks.h"
#include "sherds/typed_numbers.h"
#include "store/row.h"

namespace ostraka::ui {

class ProjectSession;

/// The numbers that a person gives the sherds on the picture of the fronts, by typing or with a
/// code reader; they are in the catalogue at once and follow their sherds. No widget.
class SherdNumbers final : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;
  /// The sherds of this batch as the picture of its fronts shows them; null: none are shown.
  void follow(ProjectSession* session, const QString& batch,
              const capture::PlateInspection* inspection);

  int count() const { return static_cast<int>(places_mm_.size()); }
  QString of(int sherd) const { return numbers_.value(sherd); }  ///< empty: none was typed
  const QStringList& all() const { return numbers_; }
  /// A whole number, its last digits, or what a label's code says; empty takes it back. Returns the
  /// sentence why it is refused; empty when it is kept.
  QString give(int sherd, const QString& typed);
  /// What to look at again: a number that is hardly another sherd's, or of another context than the
  /// bag's; empty: nothing.
  QString doubtOf(int sherd) const;

 signals:
  void changed();

 private:
  void assign();

  QPointer<ProjectSession> session_;
  QString batch_;
  store::BatchRow row_;
  std::vector<Eigen::Vector2d> places_mm_;
  std::vector<sherds::TypedNumber> typed_;
  QStringList numbers_;
};

}  // namespace ostraka::ui
