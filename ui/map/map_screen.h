#pragma once
#include <QPointer>
#include <QVector>
#include <functional>

#include "ui/frame/plate_screen.h"
#include "ui/jobs/job.h"
#include "ui/map/map_pages.h"

class QPrinter;
class QPushButton;

namespace ostraka::ui {

class BigButton;
class MapView;
class NoBatchYet;
struct PlateSherd;

/// The screen Map: which sherd is which on the plate, on screen and on paper.
class MapScreen final : public PlateScreen {
  Q_OBJECT

 public:
  explicit MapScreen(QWidget* parent = nullptr);

  void openProject(ProjectSession& session) override;
  void closeProject() override;
  void setInFront(bool in_front) override;
  QAbstractButton* primary() const override;

  /// As the catalogue has them; before it has, with the batch's and the sherd's number. None for
  /// what is void.
  QVector<SherdLabel> labels() const;

 public slots:
  void showItem(const QString& batch) override;
  void print();  ///< asks for the printer, or for a file where there is none
  void printBags();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void listBatches();
  void showBatch(const QString& batch) override;
  void openBatch(const QString& batch);
  void nameMarks();
  QVector<PlateSherd> sherds() const;
  void allowPrint(const QString& why_not);  ///< empty: it may be printed
  bool isOfScans() const;
  QString unnumberedWords() const;
  QString dayOf(const MapPicture& picture) const;
  QString pageTitle() const;

  QString date_;
  QString stale_;  ///< the batch to be read when somebody looks
  MapView* view_ = nullptr;
  BigButton* print_ = nullptr;
  NoBatchYet* empty_ = nullptr;
  QPushButton* bags_ = nullptr;
  QPointer<JobHandle> opening_;
};

}  // namespace ostraka::ui
