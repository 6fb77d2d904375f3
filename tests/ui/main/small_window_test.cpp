// A laptop of 1280 x 720 at 150 % leaves 853 x 480 logical pixels: what decides is in sight there.
#include <QAbstractButton>
#include <QAction>
#include <QBuffer>
#include <QImage>
#include <QLabel>
#include <QTabBar>
#include <QTabWidget>
#include <QTranslator>

#include "../wizard/fake_rig.h"
#include "catalogue/batches.h"
#include "person.h"
#include "sherds/sherds.h"
#include "synthetic_out.h"
#include "tests/ui/program.h"
#include "ui/frame/project_session.h"
#include "ui/frame/screen.h"
#include "ui/jobs/job.h"
#include "ui/look/look.h"
#include "ui/main/main_window.h"
#include "ui/queue/batch_queue.h"
#include "ui/queue/queue_switches.h"
#include "ui/viewport/sherd_view.h"
#include "ui/widgets/big_button.h"
#include "ui/wizard/capture_wizard.h"
#include "ui/wizard/plate_pictures.h"
#include "ui/wizard/rig_connection.h"
#include "upkeep/project.h"

using namespace ostraka;
using namespace ostraka::ui;

namespace {

const QSize kSmall(853, 480);

std::string pictureOfAPlate() {
  QImage plate(640, 480, QImage::Format_RGB32);
  plate.fill(Qt::darkGray);
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  plate.save(&buffer, "JPG");
  return bytes.toStdString();
}

}  // namespace

class SmallWindowTest : public QObject {
  Q_OBJECT

 public:
  static void initMain() { prepareOpenGl(); }

 private slots:
  void initTestCase() { applyLook(*qApp, Theme::Light, 100); }
  void init() {
    home_ = std::make_unique<Home>();
    jobs_ = std::make_unique<ThreadedJobRunner>();
  }
  void cleanup() {
    window_.reset();
    jobs_.reset();
    for (auto& translator : translators_) QApplication::removeTranslator(translator.get());
    translators_.clear();
  }

  void languages() {
    QTest::addColumn<QString>("language");
    QTest::newRow("English") << QStringLiteral("en");
    QTest::newRow("German") << QStringLiteral("de");
  }
  void thePrimaryButtonOfEachScreenIsInSight_data() { languages(); }
  void thePrimaryButtonOfEachScreenIsInSight() {
    open();
    for (const Screen* screen : window_->screens()) {
      window_->showScreenNamed(screen->iconName(), {});
      QTRY_VERIFY(screen->isVisible());
      QTRY_VERIFY2(isInSight(screen->primary()), qPrintable(reportOf(*screen)));
    }
  }

  // An empty project and one with sherds: on each screen one button can be filled, the one to
  // press.
  void eachScreenShowsOnePrimaryButtonAndFillsNoOther() {
    for (const bool empty : {true, false}) {
      open(empty);
      for (const Screen* screen : window_->screens()) {
        window_->showScreenNamed(screen->iconName(), {});
        QTRY_VERIFY(screen->isVisible());
        QTRY_VERIFY2(isTheOnlyFilled(*screen, screen->primary()),
                     qPrintable(screen->title() + QStringLiteral(": ") +
                                filledOn(*screen).join(QStringLiteral(", "))));
      }
      cleanup();
      init();
    }
  }

  void thePrimaryButtonOfTheMasksIsInSight_data() { languages(); }
  void thePrimaryButtonOfTheMasksIsInSight() {
    open();
    window_->showScreenNamed(QStringLiteral("queue"), {});
    named<QAction>(*window_, "queueMasks")->setEnabled(true);
    named<QAction>(*window_, "queueMasks")->trigger();
    const QWidget* primary = named<QWidget>(*window_, "masksComputeButton");
    QTRY_VERIFY(primary->isVisible());
    QTRY_VERIFY2(isInSight(primary), "what the strokes are painted for");
  }

  void theFieldsOfTheDetailsHaveRoomForWhatIsTyped_data() { languages(); }
  void theFieldsOfTheDetailsHaveRoomForWhatIsTyped() {
    open();
    window_->showScreenNamed(QStringLiteral("catalogue"), {});
    QWidget* details = named<QWidget>(*window_, "details");
    for (const char* field : {"field_number", "field_place", "field_ware"})
      QTRY_VERIFY2(details->findChild<QWidget*>(QString::fromLatin1(field))->width() >= 100, field);
  }

  void thePrimaryButtonStaysInSightWhileABatchIsCaptured_data() { languages(); }
  void thePrimaryButtonStaysInSightWhileABatchIsCaptured() {
    open();
    Screen* capture = window_->screens().front();
    window_->showScreenNamed(capture->iconName(), {});
    QTRY_VERIFY2(isInSight(capture->primary()), qPrintable(reportOf(*capture)));  // no rig yet
    CaptureWizard& wizard = *window_->wizard();
    rig_ = std::make_unique<FakeRig>();
    rig_->preview = pictureOfAPlate();
    wizard.rig()->choose(sourceOf(*rig_));
    QTRY_COMPARE(wizard.phase(), CapturePhase::Place);
    QTRY_VERIFY(wizard.pictures()->live().has_value());  // the picture is there
    QTRY_VERIFY2(isInSight(capture->primary()), qPrintable(reportOf(*capture)));
    rig_->refuse_shoot = Error{ErrorCode::Failed,
                               "Camera B did not answer at position 5. Check its cable, then press "
                               "Space.",
                               "camera B"};
    wizard.next();
    QTRY_VERIFY(wizard.fault().has_value() && !wizard.rig()->isBusy());
    QTRY_VERIFY2(isInSight(capture->primary()), qPrintable(reportOf(*capture)));
    wizard.next();
    QTRY_COMPARE(wizard.phase(), CapturePhase::Flip);
    QTRY_VERIFY2(isInSight(capture->primary()), qPrintable(reportOf(*capture)));
    rig_->back = 8;  // doubts take room as well
    wizard.next();
    QTRY_COMPARE(wizard.phase(), CapturePhase::Done);
    QTRY_VERIFY2(isInSight(capture->primary()), qPrintable(reportOf(*capture)));
  }

  void thePrimaryButtonOfTheCaptureKeepsToOneLine_data() { languages(); }
  void thePrimaryButtonOfTheCaptureKeepsToOneLine() {
    open();
    window_->resize(1280, 720);
    Screen* capture = window_->screens().front();
    window_->showScreenNamed(capture->iconName(), {});
    CaptureWizard& wizard = *window_->wizard();
    rig_ = std::make_unique<FakeRig>();
    rig_->preview = pictureOfAPlate();
    wizard.rig()->choose(sourceOf(*rig_));
    const auto* button = named<BigButton>(*window_, "captureButton");
    for (const CapturePhase phase : {CapturePhase::Place, CapturePhase::Flip, CapturePhase::Done}) {
      QTRY_COMPARE(wizard.phase(), phase);
      QTRY_VERIFY(button->isVisible() && button->isEnabled());
      QTRY_VERIFY2(button->isOnOneLine(), qPrintable(button->text()));
      if (phase != CapturePhase::Done) wizard.next();
    }
  }

  void theReviewShowsPhotographsModelAndTools() {
    open();
    window_->showScreenNamed(QStringLiteral("review"), {});
    for (const char* part : {"sherd", "pictures"}) {
      QWidget* shown = named<QWidget>(*window_, part);
      QTRY_VERIFY2(shown->height() >= kSmall.height() / 4 && isInSight(shown), part);
    }
    const QWidget* tools = named<QWidget>(*window_, "reviewTools");
    QTRY_VERIFY(isInSight(tools));
    QVERIFY(named<QWidget>(*window_, "mirrorButton")->isVisible());
    QVERIFY(isInSight(tools->findChild<QWidget*>(QStringLiteral("moreTools"))));  // and the others
  }

  void thePlotsOfTheReviewAreAwayWhereTheyCouldNotBeRead() {
    open();
    window_->showScreenNamed(QStringLiteral("review"), {});
    const QWidget* plots = named<QWidget>(*window_, "outlines");
    QTRY_VERIFY(named<QWidget>(*window_, "pictures")->isVisible());
    QTRY_VERIFY(!plots->isVisible());
    window_->resize(1800, 480);
    QTRY_VERIFY(plots->isVisible());
    QTRY_VERIFY(plots->width() >= 20 * plots->fontMetrics().averageCharWidth());
    window_->resize(853, 700);  // below the pictures there is room
    QTRY_VERIFY(plots->isVisible());
  }

  void theCatalogueShowsDetailsOrTheModel() {
    open();
    window_->showScreenNamed(QStringLiteral("catalogue"), {});
    QWidget* details = named<QWidget>(*window_, "details");
    QTRY_VERIFY(details->isVisible() && details->height() >= kSmall.height() / 3);
    auto* toggle = named<QAbstractButton>(*window_, "showModel");
    QTRY_VERIFY(toggle->isVisible());
    const auto* tabs = named<QTabWidget>(*window_, "right")->tabBar();
    QVERIFY(!tabs->usesScrollButtons() && tabs->tabIcon(1).isNull());
    QTest::mouseClick(toggle, Qt::LeftButton);
    QTRY_VERIFY(!details->isVisible() && named<QWidget>(*window_, "model")->isVisible());
    window_->resize(1280, 720);
    const QWidget* model = named<QWidget>(*window_, "model");
    QTRY_VERIFY(details->isVisible() && model->isVisible());
    QTRY_VERIFY2(10 * details->height() > 12 * model->height(), "four sevenths are the details'");
    const int beside = details->height();
    QTest::mouseClick(toggle, Qt::LeftButton);
    QTRY_VERIFY(!model->isVisible() && details->height() > beside);
  }

  void headAndStatusBarStay() {
    open();
    for (const char* part : {"headerWhere", "footerWork", "queuePauseFootButton"})
      QTRY_VERIFY2(isInSight(named<QWidget>(*window_, part)), part);
  }

 private:
  void open(bool empty = false) {
    QStringList names{QStringLiteral("ostraka_en")};
    if (QTest::currentDataTag() == QLatin1String("German")) names << QStringLiteral("ostraka_de");
    for (const QString& name : names) {
      auto translator = std::make_unique<QTranslator>();
      QVERIFY(translator->load(name, QStringLiteral(OSTRAKA_QM)));
      QApplication::installTranslator(translator.get());
      translators_.push_back(std::move(translator));
    }
    makeProject(empty);
    window_ = std::make_unique<MainWindow>(*jobs_);
    window_->resize(kSmall);
    activate(*window_);
    window_->openProject(home_->path("Hill"));
    QVERIFY(window_->session() != nullptr);
    window_->queue()->switches()->setPaused(true);
    QCOMPARE(window_->size(), kSmall);
  }

  void makeProject(bool empty) {
    const std::filesystem::path folder = home_->path("Hill").toStdString();
    records::ProjectRecord record;
    record.code = "ARM";
    record.title = "Hill";
    auto made = upkeep::Project::create(folder, record);
    QVERIFY2(made.has_value(), made ? "" : made.error().sentence().english().c_str());
    if (empty) return;
    pipeline::SyntheticOptions options;
    options.sherds = 6;
    (void)pipeline::writeSyntheticOut(folder / "results" / "B0001", options);
    records::BatchRecord batch;
    batch.number = "B0001";
    batch.state = records::BatchState::Review;
    QVERIFY(catalogue::Batches(made->catalogue()).add(batch, {}).has_value());
    for (int i = 0; i < 8; ++i) {
      records::SherdRecord sherd;
      sherd.ware = "grey";
      QVERIFY(sherds::Sherds(made->catalogue()).add(sherd, {}).has_value());
    }
  }

  bool isInSight(const QWidget* widget) const {
    if (widget == nullptr || !widget->isVisible()) return false;
    const QRect there(widget->mapTo(window_.get(), QPoint()), widget->size());
    return window_->rect().contains(there) &&
           widget->visibleRegion().boundingRect() == widget->rect();
  }
  static QStringList filledOn(const QWidget& screen) {
    QStringList names;
    for (const QAbstractButton* button : screen.findChildren<QAbstractButton*>())
      if (button->isVisible() && button->isEnabled() && button->property("primary").toBool())
        names << button->objectName();
    return names;
  }
  static bool isTheOnlyFilled(const QWidget& screen, const QAbstractButton* button) {
    if (button == nullptr || !button->isVisible() || !button->property("primary").toBool())
      return false;
    const QStringList filled = filledOn(screen);
    return button->isEnabled() ? filled == QStringList{button->objectName()} : filled.isEmpty();
  }
  QString reportOf(const Screen& screen) const {
    const QWidget* button = screen.primary();
    if (button == nullptr) return screen.title() + QStringLiteral(": no primary button");
    const QPoint at = button->mapTo(window_.get(), QPoint());
    const QRect seen = button->visibleRegion().boundingRect();
    return QStringLiteral("%1: '%2' at %3, %4 of %5 x %6, seen %7 x %8")
        .arg(screen.title(), button->objectName())
        .arg(at.x())
        .arg(at.y())
        .arg(button->width())
        .arg(button->height())
        .arg(seen.width())
        .arg(seen.height());
  }

  std::unique_ptr<Home> home_;
  std::unique_ptr<JobRunner> jobs_;
  std::unique_ptr<MainWindow> window_;
  std::vector<std::unique_ptr<QTranslator>> translators_;
  std::unique_ptr<FakeRig> rig_;
};

OSTRAKA_UI_TEST(SmallWindowTest)
#include "records/records.h"
#include "records/sherd.h"
#include "small_window_test.moc"
