// The manual inside the program: its pages, links and pictures are there, F1 opens the page of the
// screen, and each page names the keys that its screen has.
#include <QAction>
#include <QDirIterator>
#include <QLineEdit>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextBrowser>

#include "person.h"
#include "tests/ui/program.h"
#include "ui/frame/project_session.h"
#include "ui/frame/screen.h"
#include "ui/jobs/job.h"
#include "ui/look/look.h"
#include "ui/main/help_page.h"
#include "ui/main/main_window.h"
#include "ui/main/new_project.h"

using namespace ostraka;
using namespace ostraka::ui;

namespace {

QString contentsOf(const QString& name) {
  QFile file(name);
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

// As the manual writes it: "Enter", "Delete", "Shift+Left".
QString written(const QKeySequence& key) {
  QString text = key.toString(QKeySequence::PortableText);
  text.replace(QLatin1String("Return"), QLatin1String("Enter"));
  text.replace(QLatin1String("Del"), QLatin1String("Delete"));
  return text;
}

bool names(const QString& page, const QKeySequence& key) {
  static const QRegularExpression digit(QStringLiteral("^(Ctrl\\+)?[1-9]$"));
  if (digit.match(written(key)).hasMatch()) return true;  // '1 to 9'
  const QRegularExpression word(QStringLiteral("(^|[^A-Za-z+])%1($|[^A-Za-z+])")
                                    .arg(QRegularExpression::escape(written(key))));
  return word.match(page).hasMatch();
}

}  // namespace

class ManualTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { applyLook(*qApp, Theme::Light, 100); }
  void init() {
    home_ = std::make_unique<Home>();
    jobs_ = std::make_unique<ThreadedJobRunner>();
    window_ = std::make_unique<MainWindow>(*jobs_);
    window_->resize(1280, 720);
    activate(*window_);
    auto made = makeVirtualProject(home_->path("Ostraka/Virtual"));
    QVERIFY(made.has_value());
    made->reset();  // the window opens it by itself
  }
  void cleanup() {
    window_.reset();
    jobs_.reset();
  }

  void everyLinkAndPictureOfItIsThere() {
    static const QRegularExpression target(QStringLiteral("(?:href|src)=\"([^\"]+)\""));
    int pages = 0, pictures = 0;
    QDirIterator files(QStringLiteral(":/manual"), {QStringLiteral("*.html")});
    while (files.hasNext()) {
      ++pages;
      const QString page = contentsOf(files.next());
      QVERIFY2(page.contains(QLatin1String("<h1>")), qPrintable(files.fileName()));
      for (auto at = target.globalMatch(page); at.hasNext();) {
        const QString name = QStringLiteral(":/manual/") + at.next().captured(1);
        QVERIFY2(QFile::exists(name), qPrintable(files.fileName() + ": " + name));
        if (!name.endsWith(QLatin1String(".png"))) continue;
        ++pictures;
        QVERIFY2(QImage(name).width() >= 1000, qPrintable(name));
      }
    }
    QVERIFY(pages >= 9);
    QVERIFY(pictures >= 8);
  }

  void f1OpensThePageOfEachScreen() {
    auto* text = named<QTextBrowser>(*window_, "helpText");
    QTest::keyClick(window_.get(), Qt::Key_F1);
    QCOMPARE(text->documentTitle(), QStringLiteral("Projects"));
    openProject();
    for (std::size_t i = 0; i < window_->screens().size(); ++i) {
      window_->showScreen(static_cast<int>(i));
      QTest::keyClick(window_.get(), Qt::Key_F1);
      QTRY_VERIFY(text->isVisible());
      QCOMPARE(text->documentTitle(), window_->screens()[i]->title());
      QTest::keyClick(window_.get(), Qt::Key_Escape);
    }
    window_->showSettings();
    QTest::keyClick(window_.get(), Qt::Key_F1);
    QCOMPARE(text->documentTitle(), QStringLiteral("Settings"));
  }

  void aSearchRanksPagesByWhereTheirTitlesAndHeadingsHaveTheWordsAsTheyAreTyped() {
    HelpPage help;
    auto* text = help.findChild<QTextBrowser*>("helpText");
    QTest::keyClicks(help.findChild<QLineEdit*>("helpSearch"), "photograph without a rig");
    const QString found = text->toPlainText();
    QVERIFY2(found.startsWith(QLatin1String("First models from a telephone and a printed sheet")),
             qPrintable(found));
    QVERIFY2(!found.contains(QLatin1String("line ")), qPrintable(found));
    auto* search = help.findChild<QLineEdit*>("helpSearch");
    search->clear();
    QTest::keyClicks(search, "telephone zeppelin");  // what can be found is
    QVERIFY2(text->toPlainText().startsWith(QLatin1String("First models from a telephone")),
             qPrintable(text->toPlainText()));
  }

  void theListOfKeysNamesEachKeyOfAScreenOnce() {
    QWidget screen;
    for (const auto& [words, key] :
         {std::pair("Stop", Qt::Key_Escape), {"Next", Qt::Key_Space}, {"Keep", Qt::Key_Escape}}) {
      auto* action = new QAction(QLatin1String(words), &screen);
      action->setShortcut(key);
    }
    HelpPage help;
    help.showShortcuts({{QStringLiteral("Capture"), &screen}});
    const QString keys = help.findChild<QTextBrowser*>("helpText")->toPlainText();
    QVERIFY2(keys.contains(QLatin1String("Stop / Keep")), qPrintable(keys));
    QCOMPARE(keys.count(QLatin1String("Esc")), 1);
  }

  void aSearchListsPagesAndLeadsToTheWords() {
    QTest::keyClick(window_.get(), Qt::Key_F1);
    auto* text = named<QTextBrowser>(*window_, "helpText");
    auto* search = named<QLineEdit>(*window_, "helpSearch");
    search->setFocus();
    QTest::keyClicks(search, "ORTHOPHOTOS dpi");
    QTest::keyClick(search, Qt::Key_Return);
    QVERIFY2(text->toPlainText().contains(QLatin1String("Catalogue")),
             qPrintable(text->toPlainText()));
    QVERIFY(!text->toPlainText().contains(QLatin1String("Map")));
    QString link;
    for (QTextBlock block = text->document()->begin(); block.isValid(); block = block.next())
      for (auto at = block.begin(); !at.atEnd(); ++at)
        if (at.fragment().text().startsWith(QLatin1String("Catalogue")))
          link = at.fragment().charFormat().anchorHref();
    text->setSource(QUrl(link));
    QCOMPARE(text->documentTitle(), QStringLiteral("Catalogue"));
    QCOMPARE(text->textCursor().selectedText().toLower(), QStringLiteral("orthophotos"));
    QVERIFY(text->textCursor().block().text().contains(QLatin1String("dpi")));
    search->setFocus();
    search->selectAll();
    QTest::keyClicks(search, "zeppelin");
    QTest::keyClick(search, Qt::Key_Return);
    QVERIFY(text->toPlainText().contains(QLatin1String("does not mention 'zeppelin'")));
  }

  void eachPageNamesTheKeysOfItsScreen() {
    openProject();
    int keys = 0;
    for (const Screen* screen : window_->screens()) {
      QTextDocument page;
      page.setHtml(contentsOf(QStringLiteral(":/manual/%1.html").arg(screen->iconName())));
      for (const QAction* action : screen->findChildren<QAction*>())
        for (const QKeySequence& key : action->shortcuts()) {
          if (action->text().isEmpty()) continue;
          ++keys;
          QVERIFY2(names(page.toPlainText(), key),
                   qPrintable(screen->iconName() + ": " + written(key) + ", " + action->text()));
        }
    }
    QVERIFY(keys > 30);
  }

 private:
  void openProject() {
    window_->openProject(home_->path("Ostraka/Virtual"));
    QVERIFY(window_->session() != nullptr);
    activate(*window_);
  }

  std::unique_ptr<Home> home_;
  std::unique_ptr<JobRunner> jobs_;
  std::unique_ptr<MainWindow> window_;
};

OSTRAKA_UI_TEST(ManualTest)
#include "manual_test.moc"
