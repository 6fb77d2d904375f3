#include "ui/frame/look.h"

#include <QApplication>
#include <QCheckBox>
#include <QDir>
#include <QLabel>
#include <QRadioButton>
#include <QToolButton>
#include <QtTest>
#include <cmath>

#include "ui/frame/lines.h"
#include "ui/frame/state_colours.h"

using namespace ostraka::ui;

namespace {

double luminance(const QColor& colour) {
  const auto linear = [](float c) {
    return c <= 0.04045F ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
         0.0722 * linear(colour.blueF());
}

// The contrast of the Web Content Accessibility Guidelines: 4.5 is readable text.
double contrast(const QColor& a, const QColor& b) {
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

constexpr State kWords[] = {State::Sure,    State::Ask,   State::Failed, State::Busy,
                            State::Waiting, State::Aside, State::Front,  State::Back};

}  // namespace

class LookTest : public QObject {
  Q_OBJECT

 private slots:
  void themes_data() {
    QTest::addColumn<int>("theme");
    QTest::newRow("light") << static_cast<int>(Theme::Light);
    QTest::newRow("dark") << static_cast<int>(Theme::Dark);
    QTest::newRow("sunlight") << static_cast<int>(Theme::Sunlight);
  }

  void headingsFollowATextSizeThatChanges() {
    applyLook(*qApp, Theme::Light, 100);
    QWidget page;
    QLabel heading(&page), bold(&page);
    heading.setFont(scaledFont(page, 1.8));
    QFont heavy;
    heavy.setBold(true);
    heavy.setResolveMask(QFont::WeightResolved);
    bold.setFont(heavy);
    page.show();
    const double before = heading.font().pointSizeF();
    applyLook(*qApp, Theme::Light, 200);
    QCoreApplication::processEvents();
    QVERIFY(qAbs(heading.font().pointSizeF() - 2 * before) < 0.01);
    QVERIFY(qAbs(heading.font().pointSizeF() - 1.8 * QApplication::font().pointSizeF()) < 0.01);
    QVERIFY(qAbs(bold.font().pointSizeF() - QApplication::font().pointSizeF()) < 0.01);
    applyLook(*qApp, Theme::Light, 100);
    QVERIFY(qAbs(heading.font().pointSizeF() - before) < 0.01);
  }

  void whatIsNotTickedCanBeSeenAndGrowsWithTheText_data() { themes_data(); }
  void whatIsNotTickedCanBeSeenAndGrowsWithTheText() {
    QFETCH(int, theme);
    applyLook(*qApp, static_cast<Theme>(theme), 200);
    QCheckBox box;
    QRadioButton choice;
    for (QAbstractButton* button :
         {static_cast<QAbstractButton*>(&box), static_cast<QAbstractButton*>(&choice)}) {
      button->resize(80, 60);
      const QImage shown = button->grab().toImage();
      const QColor around = shown.pixelColor(shown.width() - 1, 0);
      double strongest = 1;
      int widest = 0;
      for (int x = 0; x < shown.width(); ++x) {
        const double seen = contrast(shown.pixelColor(x, shown.height() / 2), around);
        strongest = std::max(strongest, seen);
        if (seen > 1.3) widest = x;
      }
      QVERIFY2(strongest >= 2, qPrintable(QString::number(strongest)));
      QVERIFY2(widest >= button->fontMetrics().height() * 3 / 4,
               qPrintable(QString::number(widest)));
    }
    applyLook(*qApp, Theme::Light, 100);
  }

  void linesShowOnWhatLiesBehindThem_data() { themes_data(); }
  void linesShowOnWhatLiesBehindThem() {
    QFETCH(int, theme);
    const QPalette colours = paletteOf(static_cast<Theme>(theme), QPalette());
    for (const QPalette::ColorRole behind : {QPalette::Window, QPalette::Base})
      QVERIFY(contrast(colours.color(QPalette::Mid), colours.color(behind)) > 1.5);
  }

  void whatIsPressedInShowsItInEachTheme_data() { themes_data(); }
  void whatIsPressedInShowsItInEachTheme() {
    QFETCH(int, theme);
    applyLook(*qApp, static_cast<Theme>(theme), 100);
    QToolButton button;
    button.setText("S");
    button.setCheckable(true);
    button.resize(60, 40);
    const QImage out = button.grab().toImage();
    button.setChecked(true);
    const QImage in = button.grab().toImage();
    double strongest = 1;  // 3 is what WCAG wants of a state that a shape alone tells
    for (int x = 0; x < in.width(); ++x)
      strongest = std::max(strongest, contrast(in.pixelColor(x, 20), out.pixelColor(x, 20)));
    QVERIFY2(strongest >= 3, qPrintable(QString::number(strongest)));
    applyLook(*qApp, Theme::Light, 100);
  }

  void wordsInTheColoursOfStatesAreReadable_data() { themes_data(); }
  void wordsInTheColoursOfStatesAreReadable() {
    QFETCH(int, theme);
    const QPalette palette = paletteOf(static_cast<Theme>(theme), {});
    const StateColours colours(palette);
    for (const State state : kWords) {
      QVERIFY2(contrast(colours.of(state), palette.color(QPalette::Base)) >= 4.5,
               qPrintable(colours.of(state).name()));
      QVERIFY2(contrast(palette.color(QPalette::Text), colours.behind(state)) >= 4.5,
               qPrintable(colours.behind(state).name()));
    }
  }

  void allTextOfThePaletteIsReadable_data() { themes_data(); }
  void allTextOfThePaletteIsReadable() {
    QFETCH(int, theme);
    const QPalette palette = paletteOf(static_cast<Theme>(theme), {});
    const std::pair<QPalette::ColorRole, QPalette::ColorRole> pairs[] = {
        {QPalette::WindowText, QPalette::Window},
        {QPalette::Text, QPalette::Base},
        {QPalette::ButtonText, QPalette::Button},
        {QPalette::HighlightedText, QPalette::Highlight},
        {QPalette::PlaceholderText, QPalette::Base}};
    for (const auto& [ink, ground] : pairs)
      QVERIFY2(contrast(palette.color(ink), palette.color(ground)) >= 4.5,
               qPrintable(palette.color(ink).name()));
  }

  void theScaleAlongTheRimGetsLighterAllTheWay() {
    const StateColours colours(paletteOf(Theme::Light, {}));
    for (int i = 1; i <= 20; ++i)
      QVERIFY(luminance(colours.alongRim(i / 20.0)) > luminance(colours.alongRim((i - 1) / 20.0)));
  }

  void theTextSizeIsAShareOfThePlainOne() {
    applyLook(*qApp, Theme::Light, 100);
    const double plain = QApplication::font().pointSizeF();
    applyLook(*qApp, Theme::Light, 200);
    QCOMPARE(QApplication::font().pointSizeF(), 2 * plain);
    applyLook(*qApp, Theme::Light, 100);
    QCOMPARE(QApplication::font().pointSizeF(), plain);
  }

  void everyIconDrawsSomethingInThePalettesInk() {
    applyLook(*qApp, Theme::Dark, 100);
    (void)icon(QStringLiteral("capture"));  // links the pictures in
    const QStringList names = QDir(QStringLiteral(":/icons")).entryList({QStringLiteral("*.svg")});
    QVERIFY(names.size() > 40);
    for (const QString& name : names) {
      const QImage drawn = icon(name.chopped(4)).pixmap(32, 32).toImage();
      int inked = 0;
      for (int y = 0; y < drawn.height(); ++y)
        for (int x = 0; x < drawn.width(); ++x)
          if (qAlpha(drawn.pixel(x, y)) > 200) {
            ++inked;
            QVERIFY2(qGray(drawn.pixel(x, y)) > 128, qPrintable(name));  // light ink on dark
          }
      QVERIFY2(inked > 15, qPrintable(name));
    }
  }

  void targetsAreTwelveMillimetresAtLeast() {
    QWidget widget;
    const double per_mm = widget.screen()->logicalDotsPerInch() / 25.4;
    QVERIFY(targetSize(widget) >= 12 * per_mm - 1);
  }

  void timesAreSaidInWords() {
    QCOMPARE(timeLeftWords(-1), QString());
    QCOMPARE(timeLeftWords(3), QStringLiteral("5 s left"));
    QCOMPARE(timeLeftWords(42), QStringLiteral("40 s left"));
    QCOMPARE(timeLeftWords(125), QStringLiteral("2 min left"));
    QCOMPARE(timeLeftWords(2 * 3600 + 600), QStringLiteral("2 h 10 min left"));
  }
};

QTEST_MAIN(LookTest)
#include "look_test.moc"
