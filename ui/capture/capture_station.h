#pragma once
#include <QPointer>

#include "ui/capture/import_batch.h"
#include "ui/capture/rig_source.h"
#include "ui/frame/station.h"

class QAction;
class QLabel;
class QStackedWidget;

namespace ostraka::ui {

class BatchImporter;
class BigButton;
class CaptureWizard;
class FactList;
class MessagePanel;
class PlaceEdit;
class NumberEdit;
class PlateView;
class RigPage;
class SherdNumbers;
class StopBoard;
class Thumbnails;

/// The wizard on the screen: one big button, Space is the next thing, Esc stops.
class CaptureStation final : public Station {
  Q_OBJECT

 public:
  explicit CaptureStation(CaptureWizard* wizard, QWidget* parent = nullptr);

  QString title() const override;
  QString iconName() const override;
  QString manualPage() const override;
  void openProject(ProjectSession& session) override;
  void closeProject() override;
  void setInFront(bool in_front) override;

  QString rigWords() const;
  bool isRigReady() const;
  QString placeWords() const;
  BatchImporter* importer() const { return importer_; }

 public slots:
  void chooseRig(const ostraka::ui::RigChoice& choice);
  void chooseImport(ostraka::ui::ImportKind kind);

 signals:
  void lineChanged();  ///< where we are, or the rig

 private:
  void buildActions();
  QWidget* buildWorkPage();
  QWidget* buildFoot();
  QAction* addAct(const QString& name, const QString& icon_name, const QString& text,
                  const QKeySequence& key);
  void follow();
  void followLive();
  void followNumbers();
  void showTrouble();
  void placeTyped();

  CaptureWizard* wizard_;
  BatchImporter* importer_;
  QPointer<ProjectSession> session_;
  Thumbnails* thumbnails_ = nullptr;
  QStackedWidget *pages_, *middle_;
  RigPage* rig_page_;
  PlateView* plate_;
  StopBoard* board_;
  QLabel *headline_, *instruction_;
  FactList* facts_;
  PlaceEdit* place_;
  SherdNumbers* numbers_;
  NumberEdit* number_edit_;
  MessagePanel *doubts_, *fault_;
  BigButton* button_;
  QAction *next_, *stop_, *again_, *number_, *import_photographs_, *import_scans_, *change_rig_;
  std::vector<QAction*> cameras_;
};

}  // namespace ostraka::ui
