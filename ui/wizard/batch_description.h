#pragma once
#include <QObject>
#include <QPointer>
#include <QStringList>
#include <vector>

#include "ui/import/place_text.h"

namespace ostraka::ui {

class BatchInHand;
class ProjectSession;

/// The bag and the count of the batch in hand: typed by a person, read from the bag's label under
/// the camera, or kept with the batch.
class BatchDescription final : public QObject {
  Q_OBJECT

 public:
  /// batch: outlives it.
  BatchDescription(BatchInHand* batch, QObject* parent);

  void setSession(ProjectSession* session);
  const PlaceText& place() const { return place_; }
  void takePlaceOfBatch();
  void readLabels(const QStringList& codes);  ///< QR codes in sight while sherds are placed
  /// The same while they are turned over: what other bag's label lies there makes a doubt.
  void compareLabels(const QStringList& codes);
  QString otherBag() const;  ///< on labels beside the backs that do not name place(); empty: none
  void forgetLabelsOfBacks() { of_backs_.clear(); }

 public slots:
  void setPlace(const ostraka::ui::PlaceText& place);
  void setCounted(int sherds);
  void takeNumbersAsRight();

 signals:
  void changed();
  void countChanged();
  void placeRead();  ///< place() was read from a bag's label under the camera, or of a batch
  void said(const QString& sentence);

 private:
  std::vector<PlaceText> bagsIn(const QStringList& codes);

  QPointer<ProjectSession> session_;
  BatchInHand* batch_;
  PlaceText place_;
  std::vector<PlaceText> of_backs_;  ///< on labels, last seen while sherds were turned over
  QStringList labels_;  ///< of bags, seen last; while they lie there they say nothing new
  int looks_without_label_ = 0;
};

}  // namespace ostraka::ui
