#include "ui/look/look.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDirIterator>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QRadioButton>
#include <QRegularExpression>
#include <QSpinBox>
#include <QToolButton>
#include <QtTest>
#include <cmath>

#include "tests/ui/program.h"
#include "ui/frame/lines.h"
#include "ui/look/state_colours.h"
#include "ui/widgets/big_button.h"
#include "ui/widgets/pill.h"

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

constexpr State kWords[] = {State::Sure, State::Ask,     State::Failed,
                            State::Busy, State::Waiting, State::Aside};

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

  void anEmptyFieldIsToldFromAFilledOne_data() { themes_data(); }
  void anEmptyFieldIsToldFromAFilledOne() {
    QFETCH(int, theme);
    applyLook(*qApp, static_cast<Theme>(theme), 100);
    const QPalette palette = QApplication::palette();
    for (const QPalette::ColorGroup group : {QPalette::Active, QPalette::Disabled}) {
      const QColor empty = palette.color(group, QPalette::PlaceholderText);
      QVERIFY(contrast(empty, palette.color(group, QPalette::Base)) >= 4.5);
      QVERIFY(empty != palette.color(group, QPalette::Text));
    }
    // As if both had one colour: the shape of the letters tells it, too.
    const auto shapeOf = [](QLineEdit& line, QPalette::ColorRole role) {
      QPalette same = line.palette();
      same.setColor(role, Qt::black);
      same.setColor(QPalette::Base, Qt::white);
      line.setPalette(same);
      line.resize(300, 40);
      return line.grab(line.rect().adjusted(8, 8, -8, -8)).toImage();
    };
    const auto ink = [](const QImage& shape) {
      double sum = 0;
      for (int y = 0; y < shape.height(); ++y)
        for (int x = 0; x < shape.width(); ++x) sum += 255 - qGray(shape.pixel(x, y));
      return sum;
    };
    QLineEdit empty, filled;
    empty.setPlaceholderText("rim; neck; shoulder");
    filled.setText("rim; neck; shoulder");
    const QImage hint = shapeOf(empty, QPalette::PlaceholderText);
    const QImage typed = shapeOf(filled, QPalette::Text);
    QVERIFY(ink(hint) > 0);
    QVERIFY(hint != typed);
    if (QApplication::font().bold()) QVERIFY(ink(hint) < 0.9 * ink(typed));
    applyLook(*qApp, Theme::Light, 100);
  }

  // 4.5 : 1 for what is read, 3 : 1 for the edges of controls and for lines that mean something.
  void allPairsOfColoursHaveTheirContrast_data() { themes_data(); }
  void allPairsOfColoursHaveTheirContrast() {
    QFETCH(int, theme);
    const Colours& c = coloursOf(static_cast<Theme>(theme));
    for (const QColor& ground : {c.page, c.surface, c.raised}) {
      for (const QColor& ink : {c.text, c.secondary, c.accent, c.good, c.check, c.bad})
        QVERIFY2(contrast(ink, ground) >= 4.5, qPrintable(ink.name() + " on " + ground.name()));
      for (const QColor& line : {c.control, c.front, c.back, c.accent})
        QVERIFY2(contrast(line, ground) >= 3, qPrintable(line.name() + " on " + ground.name()));
    }
    QVERIFY(contrast(c.on_accent, c.accent) >= 4.5);
    const StateColours colours(paletteOf(static_cast<Theme>(theme), {}));
    for (const State state : kWords)  // a pill
      QVERIFY2(contrast(colours.of(state), colours.behind(state)) >= 4.5,
               qPrintable(colours.of(state).name() + " on " + colours.behind(state).name()));
    const QPalette matte = mattePalette();
    QVERIFY(contrast(matte.color(QPalette::Text), matte.color(QPalette::Base)) >= 4.5);
    QVERIFY(contrast(matte.color(QPalette::PlaceholderText), matte.color(QPalette::Base)) >= 4.5);
  }

  void inSunlightStatesDifferByFormAndLinesAreThick() {
    QVERIFY(coloursOf(Theme::Sunlight).border_width > coloursOf(Theme::Light).border_width);
    applyLook(*qApp, Theme::Sunlight, 100);
    const auto form = [](State state) {
      QImage drawn(120, 30, QImage::Format_RGB32);
      drawn.fill(Qt::white);
      QPainter painter(&drawn);
      drawPill(painter, drawn.rect(), {state, "check", {}}, QApplication::palette());
      painter.end();
      return drawn.convertToFormat(QImage::Format_Mono, Qt::ThresholdDither);  // no colour left
    };
    const QList<QImage> forms{form(State::Sure), form(State::Ask), form(State::Failed),
                              form(State::Waiting)};
    for (int i = 0; i < forms.size(); ++i)
      for (int k = 0; k < i; ++k) QVERIFY(forms[i] != forms[k]);
    applyLook(*qApp, Theme::Light, 100);
  }

  void noOtherFileHasAColourOfItsOwn() {
    static const QRegularExpression literal(
        QStringLiteral("QColor\\(\\s*(0x|\\d|Qt::(?!transparent))|\"#[0-9a-fA-F]{6}\"|"
                       "Qt::(black|white|red|blue|green|yellow|gray|darkGray|lightGray)\\b"));
    QDirIterator files(QStringLiteral(OSTRAKA_SOURCES),
                       {QStringLiteral("*.cpp"), QStringLiteral("*.h")}, QDir::Files,
                       QDirIterator::Subdirectories);
    int read = 0;
    while (files.hasNext()) {
      const QString path = files.next();
      if (path.contains(QLatin1String("/look/look.")) ||
          path.contains(QLatin1String("/look/distance_scale.")))
        continue;
      QFile file(path);
      QVERIFY(file.open(QIODevice::ReadOnly));
      const QRegularExpressionMatch found = literal.match(QString::fromUtf8(file.readAll()));
      QVERIFY2(!found.hasMatch(), qPrintable(path + ": " + found.captured()));
      ++read;
    }
    QVERIFY(read > 100);
  }

  void theDefaultIsTheLightThemeAndASystemIsFollowedByItsLightness() {
    QCOMPARE(themeFromName(QStringLiteral("unheard of")), Theme::Light);
    QCOMPARE(paletteOf(Theme::System, QPalette(Qt::black)), paletteOf(Theme::Dark, {}));
    QCOMPARE(paletteOf(Theme::System, QPalette(Qt::white)), paletteOf(Theme::Light, {}));
  }

  void thereAreTwoHeightsOfControls() {
    applyLook(*qApp, Theme::Light, 100);
    QWidget page;
    QCOMPARE(controlHeight(page), Look::kControl);
    QCOMPARE(targetSize(page), Look::kPrimary);
    QLineEdit line;
    QComboBox box;
    QSpinBox number;
    QPushButton button(QStringLiteral("Open"));
    for (const QWidget* control :
         {static_cast<const QWidget*>(&line), static_cast<const QWidget*>(&box),
          static_cast<const QWidget*>(&number), static_cast<const QWidget*>(&button)})
      QCOMPARE(control->sizeHint().height(), Look::kControl);
    QCOMPARE(BigButton({}, {}, nullptr).sizeHint().height(), Look::kPrimary);
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

  // The sides are lines and marks, never words: 3 is what WCAG wants of them.
  void linesInTheColoursOfTheSidesAreSeen_data() { themes_data(); }
  void linesInTheColoursOfTheSidesAreSeen() {
    QFETCH(int, theme);
    const QPalette palette = paletteOf(static_cast<Theme>(theme), {});
    const QColor base = palette.color(QPalette::Base), matte = StateColours::matte();
    for (const State side : {State::Front, State::Back}) {
      QVERIFY(contrast(StateColours(palette).of(side), base) >= 3);
      QVERIFY(contrast(StateColours::onMatte().of(side), matte) >= 4.5);
    }
    QVERIFY(contrast(StateColours::inkOnMatte(), matte) >= 4.5);
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

  void timesAreSaidInWords() {
    QCOMPARE(timeLeftWords(-1), QString());
    QCOMPARE(timeLeftWords(42), QStringLiteral("less than a minute left"));
    QCOMPARE(timeLeftWords(125), QStringLiteral("about 2 min left"));
    QCOMPARE(timeLeftWords(9 * 60 + 40), QStringLiteral("about 10 min left"));
    QCOMPARE(timeLeftWords(42 * 60), QStringLiteral("about 40 min left"));
    QCOMPARE(timeLeftWords(58 * 60), QStringLiteral("about 1 h left"));
    QCOMPARE(timeLeftWords(2 * 3600 + 1500), QStringLiteral("about 2.5 h left"));
  }
};

OSTRAKA_UI_TEST(LookTest)
#include "look_test.moc"
