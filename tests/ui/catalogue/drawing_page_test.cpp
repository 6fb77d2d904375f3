// The drawing of what is chosen, in a real window: one at once, many on demand.
#include "ui/catalogue/drawing_page.h"

#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLocale>
#include <QPdfWriter>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QTranslator>
#include <cmath>

#include "../named.h"
#include "paper/sheet.h"
#include "sample_project.h"
#include "sherds/sherds.h"
#include "tests/ui/program.h"
#include "ui/catalogue/sheet_view.h"
#include "ui/look/look.h"

using namespace ostraka;
using namespace ostraka::ui;

class DrawingPageTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<SampleProject> sample_;
  std::unique_ptr<DrawingPage> page_;

  template <class T>
  T* child(const char* name) {
    return named<T>(*page_, name);
  }
  void show(std::vector<int> sherds) {
    std::vector<store::SherdRow> rows;
    for (const int sherd : sherds) rows.push_back(sample_->sherds()[static_cast<size_t>(sherd)]);
    page_->setSherds(&sample_->session(), rows);
  }
  QString words() { return child<QLabel>("drawingWords")->text(); }
  bool isDrawing() { return words().startsWith("Drawing "); }
  static QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

 private slots:
  void init() {
    sample_ = std::make_unique<SampleProject>(6);
    sample_->giveModel(1);  // 1, 2, 4, 5 are body sherds
    sample_->giveModel(2);
    page_ = std::make_unique<DrawingPage>();
    page_->resize(420, 680);
    activate(*page_);
  }
  void cleanup() {
    page_.reset();
    sample_.reset();
  }

  void oneSherdIsDrawnByItself() {
    show({1});
    QVERIFY(isDrawing());
    QTRY_COMPARE_WITH_TIMEOUT(page_->pages().size(), size_t(1), 30000);
    QTRY_VERIFY_WITH_TIMEOUT(child<SheetView>("sheet")->hasSheet(), 30000);
    const QString svg = QString::fromStdString(formatSvg(page_->pages().front(), {}));
    QVERIFY(svg.contains(">ARM1-T3-0013-0001</text>"));
    QVERIFY(svg.contains(">1 : 1</text>"));
    QVERIFY(child<QPushButton>("saveDrawing")->isEnabled());
    QVERIFY2(!child<QPushButton>("enterRim")->isVisible(), "a body sherd has no mouth");
  }

  void theScaleIsAChoice() {
    show({1});
    QTRY_VERIFY_WITH_TIMEOUT(!page_->pages().empty(), 30000);
    auto* scale = child<QComboBox>("drawingScale");
    scale->setFocus();
    QTest::keyClick(scale, Qt::Key_Down);
    QVERIFY(isDrawing());
    QTRY_VERIFY_WITH_TIMEOUT(!page_->pages().empty(), 30000);
    QVERIFY(formatSvg(page_->pages().front(), {}).find(">1 : 2</text>") != std::string::npos);
  }

  void theOrthophotoIsAChoiceAndHasColours() {
    show({1});
    QTRY_VERIFY_WITH_TIMEOUT(!page_->pages().empty(), 30000);
    QVERIFY(formatPdf(page_->pages(), {}).find("/DeviceRGB") == std::string::npos);
    auto* surface = child<QComboBox>("drawingSurface");
    QCOMPARE(surface->itemText(2), QString("Orthophoto, 300 dpi"));
    surface->setFocus();
    for (int k = 0; k < 2; ++k) QTest::keyClick(surface, Qt::Key_Down);
    QVERIFY(isDrawing());
    QTRY_VERIFY_WITH_TIMEOUT(!page_->pages().empty(), 30000);
    QVERIFY(formatPdf(page_->pages(), {}).find("/DeviceRGB") != std::string::npos);
  }

  void aSherdWithoutAModelSaysSo() {
    show({4});
    QTRY_VERIFY_WITH_TIMEOUT(words().contains("has no model yet"), 30000);
    QVERIFY(!child<QPushButton>("saveDrawing")->isEnabled());
  }

  void manyBecomePlatesWhenTheyAreWanted() {
    show({1, 2, 4});
    QVERIFY(!isDrawing());
    auto* draw = child<QPushButton>("drawMany");
    QVERIFY(draw->isVisible());
    QTest::mouseClick(draw, Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(page_->pages().size(), size_t(1), 60000);
    QVERIFY(words().startsWith("2 drawn, 1 left out."));
    QVERIFY(words().contains("ARM1-T3-0012-0003"));
    const std::string svg = formatSvg(page_->pages().front(), {});
    QVERIFY(svg.find(">ARM1-T3-0013-0001</text>") != std::string::npos);
    QVERIFY(svg.find(">ARM1-T3-0012-0002</text>") != std::string::npos);
  }

  void aVoidSherdIsOnNoPlateAndSaysSoBesideItsOwnSheet() {
    QVERIFY(
        sherds::Sherds(sample_->catalogue()).voidSherd(sample_->row(1), "a brick", {}).has_value());
    show({1, 2});
    QTest::mouseClick(child<QPushButton>("drawMany"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(page_->pages().size(), size_t(1), 60000);
    QCOMPARE(words(), QString("1 drawn, 1 left out.\nARM1-T3-0013-0001 is void and was left out."));
    QVERIFY(formatSvg(page_->pages().front(), {}).find("0013-0001") == std::string::npos);
    show({1});
    QTRY_COMPARE_WITH_TIMEOUT(page_->pages().size(), size_t(1), 30000);
    QVERIFY2(words().contains("This sherd is void; reason: a brick"), qPrintable(words()));
    QVERIFY(formatSvg(page_->pages().front(), {}).find("void") == std::string::npos);
  }

  void theSheetIsInTheWindowsLanguage() {
    class French final : public QTranslator {
     public:
      QString translate(const char* context, const char* source, const char*, int) const override {
        const bool wall =
            qstrcmp(context, "ostraka::Error") == 0 && qstrcmp(source, "wall %1 mm") == 0;
        return wall ? QStringLiteral("paroi %1 mm") : QString();
      }
      bool isEmpty() const override { return false; }
    } french;
    const QLocale before;
    QVERIFY(QCoreApplication::installTranslator(&french));
    QLocale::setDefault(QLocale(QLocale::French));
    show({1});
    QTRY_VERIFY_WITH_TIMEOUT(!page_->pages().empty(), 30000);
    const QString svg = QString::fromStdString(formatSvg(page_->pages().front(), {}));
    QCoreApplication::removeTranslator(&french);
    QLocale::setDefault(before);
    // As the catalogue has them by hand.
    QVERIFY2(svg.contains(">41,0 × 31,0 mm, paroi 4,5 mm</text>"), qPrintable(svg.right(1500)));
  }

  // A jagged break is no lip, whoever says so: there is nothing to enter.
  void aDiameterThatIsNotKnownIsNotOffered() {
    TriangleMesh jagged = exchange::closedShell();
    for (Eigen::Vector3f& p : jagged.vertices)
      p.head<2>() *= 1 + 0.006F * std::sin(40 * std::atan2(p.y(), p.x()));
    sample_->giveModel(1, jagged);
    show({1});
    child<QComboBox>("drawingRim")->setFocus();
    QTest::keyClick(child<QComboBox>("drawingRim"), Qt::Key_Down);
    QTRY_VERIFY_WITH_TIMEOUT(!page_->pages().empty(), 30000);
    QVERIFY2(words().contains("barely resembles one"), qPrintable(words()));
    QVERIFY2(!words().contains("Mouth"), qPrintable(words()));
    QVERIFY(!child<QPushButton>("enterRim")->isVisible());
  }

  // Of each sherd its own, whatever is looked at between, and in the next window.
  void whatIsSaidOfARimStaysWithItsSherd() {
    const auto press = [&](int key) {
      child<QComboBox>("drawingRim")->setFocus();
      QTest::keyClick(child<QComboBox>("drawingRim"), static_cast<Qt::Key>(key));
    };
    const auto shown = [&] { return child<QComboBox>("drawingRim")->currentText(); };
    show({1});
    press(Qt::Key_Down);
    QCOMPARE(shown(), QString("Rim sherd"));
    show({2});
    QCOMPARE(shown(), QString("Automatic"));
    press(Qt::Key_End);
    show({1});  // set again, as after every edit of the table
    QCOMPARE(shown(), QString("Rim sherd"));
    show({1, 2});
    QVERIFY2(shown().isEmpty(), qPrintable(shown()));
    page_ = std::make_unique<DrawingPage>();
    show({2});
    QCOMPARE(shown(), QString("No rim"));
    show({1, 2});
    press(Qt::Key_Home);  // of both
    show({1});
    QCOMPARE(shown(), QString("Automatic"));
  }

  void stoppingDrawsNothing() {
    show({1, 2});
    QTest::mouseClick(child<QPushButton>("drawMany"), Qt::LeftButton);
    QVERIFY(child<QPushButton>("stopDrawing")->isVisible());
    QTest::mouseClick(child<QPushButton>("stopDrawing"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(words().startsWith("Cancelled"), 30000);
    QVERIFY(page_->pages().empty());
    QVERIFY(child<QPushButton>("drawMany")->isVisible());
  }

  void itIsSavedInEachForm() {
    show({1});
    QTRY_VERIFY_WITH_TIMEOUT(!page_->pages().empty(), 30000);
    const QSignalSpy said(page_.get(), &DrawingPage::said);
    page_->saveTo(sample_->folder() + "/one.svg");
    QTRY_COMPARE(said.count(), 1);
    QVERIFY(bytesOf(sample_->folder() + "/one.svg").contains("</svg>"));
    page_->saveTo(sample_->folder() + "/one");
    QTRY_COMPARE(said.count(), 2);
    QVERIFY(bytesOf(sample_->folder() + "/one.pdf").startsWith("%PDF"));
    page_->saveTo(sample_->folder() + "/one.png");
    QTRY_COMPARE(said.count(), 3);
    QVERIFY(bytesOf(sample_->folder() + "/one.png").contains("pHYs"));
    page_->saveTo(sample_->folder() + "/kind.pdf", "TIFF, the views of each sherd (*.tif)");
    QTRY_COMPARE(said.count(), 4);
    QVERIFY(QFile::exists(sample_->folder() + "/kind.tif"));
    page_->saveTo(sample_->folder() + "/typed.svg", "PNG, the views of each sherd (*.png)");
    QTRY_COMPARE(said.count(), 5);
    QVERIFY(QFile::exists(sample_->folder() + "/typed.svg"));
    page_->saveTo(sample_->folder() + "/one.svg/within.pdf");  // a file is no folder
    QTRY_VERIFY(words().contains("one.svg"));
    QCOMPARE(said.count(), 5);
  }

  // A batch was entered meanwhile, say, and the table is read again.
  void whatIsSavedIsWhatWasShownWhenAPersonPressedSave() {
    show({1});
    QTRY_VERIFY_WITH_TIMEOUT(!page_->pages().empty(), 30000);
    const QString file = sample_->folder() + "/kept.pdf";
    QTimer::singleShot(0, page_.get(), [&] {
      show({});
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      QVERIFY(dialog != nullptr);
      dialog->selectFile(file);
      static_cast<QDialog*>(dialog)->accept();
    });
    const QSignalSpy said(page_.get(), &DrawingPage::said);
    QTest::mouseClick(child<QPushButton>("saveDrawing"), Qt::LeftButton);
    QTRY_COMPARE(said.count(), 1);
    QVERIFY(bytesOf(file).startsWith("%PDF"));
  }

  // A sherd of 3 cm on A4 is not shown as a stamp.
  void theSheetIsShownWhereItIsDrawnOn() {
    SheetView view;
    view.resize(300, 300);
    view.show();
    Page page{210, 297, {}};
    Sheet ruler;
    ruler.line({60, 20}, {110, 20}, 0.5);
    page.layers.push_back({ruler, {0, 0}, {}});
    const QImage sheet = paintedSheet(page, 200);
    view.showSheet(sheet);
    const double per_mm = 200 / 25.4;
    const auto seen = [&view] { return view.mapToScene(view.viewport()->rect()).boundingRect(); };
    QVERIFY(seen().contains(QRectF(60 * per_mm, 20 * per_mm, 50 * per_mm, 1)));
    QVERIFY(seen().width() < 100 * per_mm);
    const double first = view.transform().m11();
    QTest::keyClick(&view, Qt::Key_Plus);
    QVERIFY(view.transform().m11() > first);
    QTest::keyClick(&view, Qt::Key_0);
    QCOMPARE(view.transform().m11(), first);
    view.showSheet(paintedSheet({210, 297, {}}, 200));  // nothing on it: all of it
    QVERIFY(seen().width() >= sheet.width());
  }

  void printingKeepsPapersAndTrueScale() {
    Page upright{210, 297, {}}, across{297, 210, {}}, large{500, 400, {}};
    Sheet ruler;
    ruler.line({10, 10}, {110, 10}, 0.5);
    upright.layers.push_back({ruler, {0, 0}, {}});
    const QString file = sample_->folder() + "/printed.pdf";
    {
      QPdfWriter pdf(file);
      pdf.setResolution(254);  // ten dots a millimetre
      const Result<void> printed = printSheets(pdf, {upright, across, large});
      QVERIFY2(printed.has_value(), printed ? "" : printed.error().what.english().c_str());
    }
    const QByteArray bytes = bytesOf(file);
    QVERIFY(bytes.contains("/MediaBox [0 0 595"));
    QVERIFY(bytes.contains("/MediaBox [0 0 842") || bytes.contains("/MediaBox [0 0 841"));
    QVERIFY(bytes.contains("/MediaBox [0 0 1417"));
    const QImage picture = paintedSheet(upright, 254);
    QCOMPARE(picture.size(), QSize(2100, 2970));
    QVERIFY(picture.pixelColor(110, 100).lightness() < 50);
    QVERIFY(picture.pixelColor(1090, 100).lightness() < 50);
    QVERIFY(picture.pixelColor(1120, 100).lightness() > 200);
  }

  void looksRightInEveryTheme() {
    const QString folder = qEnvironmentVariable("OSTRAKA_SCREENSHOTS");
    for (const Theme theme : {Theme::Light, Theme::Dark}) {
      applyLook(*qApp, theme, 100);
      show({});
      show({1});
      QTRY_VERIFY_WITH_TIMEOUT(child<SheetView>("sheet")->hasSheet(), 30000);
      if (!folder.isEmpty()) page_->grab().save(folder + "/drawing-" + themeName(theme) + ".png");
      QVERIFY(child<QComboBox>("drawingScale")->isVisible());
    }
  }
};

OSTRAKA_UI_TEST(DrawingPageTest)
#include "drawing_page_test.moc"
