#pragma once
#include <QPointer>

#include "ui/frame/screen.h"
#include "ui/import/import_batch.h"
#include "ui/wizard/capture_text.h"
#include "ui/wizard/rig_source.h"

class QAction;
class QLabel;
class QStackedWidget;
class QVBoxLayout;

namespace ostraka::ui {

class BatchImporter;
class CaptureFoot;
class CaptureWizard;
class FactList;
class MessagePanel;
class PlaceEdit;
class NumberEdit;
class ImportAsk;
class ImportChooser;
class PlateView;
class RigPage;
class RigRenewal;
class SherdNumbers;
class StopBoard;
class Thumbnails;

/// The wizard on the screen: one big button, Space is the next thing, Esc stops.
class CaptureScreen final : public Screen {
  Q_OBJECT

 public:
  explicit CaptureScreen(CaptureWizard* wizard, QWidget* parent = nullptr);

  void openProject(ProjectSession& session) override;
  void closeProject() override;
  void setInFront(bool in_front) override;
  QAbstractButton* primary() const override;
  void setCompact(bool compact) override;

  QString rigWords() const;
  bool isRigReady() const;
  QString whereWords() const override;
  BatchImporter* importer() const { return importer_; }
  void importPhotographs(const QStringList& paths);  ///< shows what they are, and asks

 public slots:
  void chooseRig(const ostraka::ui::RigChoice& choice);
  /// "calibrate:B0031": by this batch's photographs, because a camera was bumped.
  void showItem(const QString& what) override;

 signals:
  void lineChanged();  ///< where we are, or the rig
  void rigRenewed(const QString& batch);
  void batchSetAside(const QString& number);
  void importLeft();  ///< cancelled before it began, or while it ran

 private:
  void buildActions();
  QWidget* buildWorkPage();
  QWidget* buildFoot();
  QWidget* buildMiddle(QWidget* page);
  double headlineSize() const;
  void buildTwice();
  void goOn();
  bool namesABag();  ///< what is typed; else it says so, and the cursor is there
  void follow();
  void tellWork();
  void followLive();
  void followNumbers();
  void showTrouble();
  void followBag();
  void placeTyped();
  void followRig(const std::optional<Error>& why_not);
  void buildImport(QVBoxLayout* all);
  void showFailure(const Error& error);
  void showImported(const QString& number, int files, const QStringList& doubts,
                    const QString& note);
  RigChoice rigChoice() const;
  void keepChoice(const RigChoice& choice);
  void leaveRig();

  CaptureWizard* wizard_;
  CaptureText text_;
  BatchImporter* importer_;
  RigRenewal* renewal_;
  QPointer<ProjectSession> session_;
  Thumbnails* thumbnails_ = nullptr;
  RigPage* rig_page_;
  QWidget* work_page_;
  bool compact_ = false;
  bool working_ = false;  ///< what it does is told to the status bar
  RigChoice tried_rig_;   ///< takes the place of the kept one when it opens
  QStackedWidget* middle_;
  PlateView* plate_;
  StopBoard* board_;
  QLabel *headline_, *instruction_;
  FactList* facts_;
  CaptureFoot* foot_;
  PlaceEdit* place_;
  SherdNumbers* numbers_;
  NumberEdit* number_edit_;
  MessagePanel *doubts_, *fault_;
  MessagePanel* other_numbers_;  ///< than this bag's
  MessagePanel* twice_ = nullptr;
  ImportAsk* import_ask_;
  ImportChooser* chooser_;
  MessagePanel* failure_;  ///< of an import or a calibration: nothing to do with the wizard
  QAction *next_, *stop_, *again_, *keep_, *number_, *count_sherds_, *import_photographs_,
      *import_scans_, *change_rig_, *set_aside_;
  std::vector<QAction*> cameras_;
};

}  // namespace ostraka::ui
