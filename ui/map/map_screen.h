#pragma once
#include <QPointer>
#include <QVector>

#include "ui/frame/screen.h"
#include "ui/jobs/job.h"
#include "ui/map/map_pages.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace ostraka::ui {

class BigButton;
class EmptyState;
class MapView;
struct PlateSherd;

/// The screen Map: which sherd is which on the plate, on screen and on paper.
class MapScreen final : public Screen {
  Q_OBJECT

 public:
  explicit MapScreen(QWidget* parent = nullptr);

  QString title() const override { return tr("Map"); }
  QString iconName() const override { return QStringLiteral("map"); }
  QString manualPage() const override { return QStringLiteral("map"); }
  void openProject(ProjectSession& session) override;
  void closeProject() override;
  void setInFront(bool in_front) override;
  QAbstractButton* primary() const override;
  QString chosen() const override;
  QString whereWords() const override;
  void takeChosen(const QString& what) override;

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
  void showBatch(const QString& batch);
  void openBatch(const QString& batch);
  void nameMarks();
  QVector<PlateSherd> sherds() const;
  bool isOfScans() const;
  QString unnumberedWords() const;
  QString dayOf(const MapPicture& picture) const;
  void say(const QString& sentence);
  QString pageTitle() const;

  QPointer<ProjectSession> session_;
  QString batch_, date_;
  QString stale_;  ///< the batch to be read when somebody looks
  QComboBox* batches_ = nullptr;
  QLabel* message_ = nullptr;
  MapView* view_ = nullptr;
  BigButton* print_ = nullptr;
  EmptyState* empty_ = nullptr;
  QPushButton *bags_ = nullptr, *to_capture_ = nullptr;
  QPointer<JobHandle> opening_;
};

}  // namespace ostraka::ui
