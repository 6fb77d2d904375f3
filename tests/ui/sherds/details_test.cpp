// The details of a sherd: what is refused, and what has little room.
#include "catalogue/files.h"
#include "catalogue/history.h"
#include "catalogue/places.h"
#include "sherds/measurements.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherds.h"
#include "ui/sherds/munsell_line.h"
#include "ui/sherds/sherd_details.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QTranslator>
#include <QTreeWidget>
#include <algorithm>

#include "catalogue_window.h"
#include "records/records.h"
#include "records/sherd.h"
#include "tests/ui/program.h"
#include "ui/catalogue/catalogue_screen.h"
#include "ui/sherds/number_delegate.h"
#include "ui/widgets/elided_button.h"

using namespace ostraka;
using namespace ostraka::ui;

class DetailsTest : public CatalogueWindow {
  Q_OBJECT

 private slots:
  void init() { open(); }
  void cleanup() { close(); }

  void withLargeLettersANumberKeepsItsEndAndTheDetailsTheirWidth() {
    sample_->addDraft();
    filter("state:draft");
    choose(0);
    QFont large = screen_->font();
    large.setPointSizeF(1.6 * large.pointSizeF());
    screen_->setFont(large);
    auto* give = static_cast<ElidedButton*>(child<QPushButton>("giveNumber"));
    give->setText("Donner le numéro ARAGATS-T2-000005-000123");
    screen_->findChild<SherdDetails*>()->setFixedWidth(300);
    QTRY_VERIFY(give->isVisible() && give->width() <= 300);
    QCOMPARE(screen_->findChild<SherdDetails*>()->horizontalScrollBar()->maximum(), 0);
    QVERIFY2(give->shownText().endsWith("0123"), qPrintable(give->shownText()));
    filter("state:numbered");
    QStyleOptionViewItem option;
    NumberDelegate().initStyleOption(&option, table()->model()->index(0, 0));
    QCOMPARE(option.text, QString("ARM1-T3-0012-0001"));
    QCOMPARE(option.textElideMode, Qt::ElideLeft);
  }

  void whatIsRefusedStaysUntilItIsMendedOrGivenUp() {
    choose(0);
    const auto type = [&](const char* field, const QString& value) {
      auto* line = child<QLineEdit>(field);
      line->setFocus();
      line->selectAll();
      QTest::keyClicks(line, value);
      QTest::keyClick(line, Qt::Key_Tab);
    };
    auto* date = child<QLineEdit>("field_date_edtf");
    const QString before = date->text();
    QVERIFY(date->placeholderText().contains("-0599/-0549: 600 to 550 BC"));
    type("field_date_edtf", "MB II");
    QVERIFY(child<QLabel>("refusalText")->text().contains("belong in the field for the period"));
    type("field_date_edtf", "27-30 AD");
    type("field_weight_g", "12,75");
    QCOMPARE(sample_->value(0, "weight_g"), QString("12.75"));
    QCOMPARE(date->text(), QString("27-30 AD"));
    QVERIFY(child<QLabel>("refusalText")->isVisible());
    type("field_munsell_out", "brown");
    auto* told = child<QLabel>("refusalText");
    QVERIFY2(told->text().contains("Munsell") && told->text().contains("Not saved yet: date"),
             qPrintable(told->text()));
    QTest::keyClick(child<QLineEdit>("field_munsell_out"), Qt::Key_Escape);
    choose(3);
    QVERIFY(date->text() != QString("27-30 AD"));
    choose(0);
    QCOMPARE(date->text(), QString("27-30 AD"));
    date->setFocus();
    QTest::keyClick(date, Qt::Key_Escape);
    QCOMPARE(date->text(), before);
    QVERIFY(!child<QLabel>("refusalText")->isVisible());
    type("field_date_edtf", "0027/0030");
    QCOMPARE(sample_->value(0, "date_edtf"), QString("0027/0030"));
  }

  // A field that jumps is another one when the pointer gets there.
  void noFieldMovesForWhatIsSaidAboveOrBelowIt() {
    sample_->addDraft();
    auto* details = screen_->findChild<SherdDetails*>();
    const auto places = [&] {
      QTest::qWait(0);
      QList<int> heights{details->verticalScrollBar()->value()};
      for (const char* field : {"field_number", "field_ware", "field_munsell_in", "field_note"})
        heights << named<QWidget>(*details, field)->mapTo(details->widget(), QPoint()).y();
      return heights;
    };
    choose(0);
    auto* bag = child<QLineEdit>("field_bag");
    bag->setFocus();
    QTest::qWait(100);  // for the rows, which are laid out when their sherd has been read
    details->verticalScrollBar()->setValue(bag->mapTo(details->widget(), QPoint()).y());
    const QList<int> before = places();
    bag->selectAll();
    QTest::keyClicks(bag, "neck");
    QTest::keyClick(bag, Qt::Key_Return);
    QVERIFY(child<QLabel>("refusalText")->isVisible());
    QCOMPARE(places(), before);
    QCOMPARE(bag->actions().size(), 1);  // the mark
    QTest::keyClick(bag, Qt::Key_Escape);
    QVERIFY(!child<QLabel>("refusalText")->isVisible());
    QCOMPARE(bag->actions().size(), 0);
    QCOMPARE(places(), before);
    filter("state:draft");
    choose(0);
    QVERIFY(child<QPushButton>("giveNumber")->isVisible());
    QCOMPARE(places().mid(1), before.mid(1));
  }

  void whereNoNumberCanBeGivenAButtonLeadsToTheNumbering() {
    sample_->addDraft(false);
    filter("state:draft");
    choose(0);
    QVERIFY2(child<QLabel>("whyNoNumber")->isVisible(), "a number needs a context");
    const QSignalSpy wanted(screen_.get(), &Screen::wantsScreen);
    QTest::mouseClick(child<QPushButton>("openNumbering"), Qt::LeftButton);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted.front(), QVariantList({"settings", "numbering"}));
  }

  // Long words, and a column that is narrower.
  void theTablesShowTheirTextsWhole() {
    const records::FieldChange note{sample_->row(0), "note",
                                    QString("a long remark ").repeated(20).toStdString()};
    SampleProject::must(sherds::SherdChanges(sample_->catalogue()).apply(std::span(&note, 1), {}));
    records::FileRecord drawing;
    drawing.path = "imported/drawn/sherd.svg";
    drawing.sha256 = std::string(64, '0');
    drawing.media_type = "image/svg+xml";
    drawing.role = "drawing";
    drawing.sherd = sample_->row(0);
    SampleProject::must(catalogue::Files(sample_->catalogue()).save(drawing, {}));
    class German final : public QTranslator {
      QString translate(const char*, const char* source, const char*, int) const override {
        return qstrcmp(source, "drawing") == 0 ? QStringLiteral("Zeichnung") : QString();
      }
      bool isEmpty() const override { return false; }
    } german;
    QVERIFY(QCoreApplication::installTranslator(&german));
    choose(0);
    QCoreApplication::removeTranslator(&german);
    QStringList kinds;
    int tallest = 0;
    for (QTreeWidget* tree : screen_->findChild<SherdDetails*>()->findChildren<QTreeWidget*>()) {
      QTest::qWait(0);
      int high = 0;
      for (int row = 0; row < std::min(tree->topLevelItemCount(), 12); ++row) {
        const int one = tree->visualItemRect(tree->topLevelItem(row)).height();
        tallest = std::max(tallest, one);
        high += one;
        kinds << tree->topLevelItem(row)->text(1);
      }
      QVERIFY2(tree->viewport()->height() >= high, qPrintable(tree->accessibleName()));
    }
    QVERIFY2(tallest >= 3 * screen_->fontMetrics().height(), "the remark goes on in other lines");
    QVERIFY(kinds.contains("Zeichnung"));
  }

  void aModelWithoutProposedColoursSaysWhyOnce() {
    records::SherdRecord sherd;
    MunsellLine inside("munsell_in", nullptr), core("munsell_core", nullptr);
    QVERIFY2(!core.offer({}, sherd), "without a model nobody expects any");
    sherd.model_path = "models/1.ply";
    QVERIFY(!inside.offer({}, sherd));
    QVERIFY(core.offer({}, sherd));
    const auto* why = core.findChild<QLabel*>("proposed_munsell_core");
    QVERIFY2(why->text().startsWith("No colours proposed:"), qPrintable(why->text()));
    sherd.munsell_out = "10YR 5/1";
    QVERIFY2(!core.offer({}, sherd), "somebody read them from a book");
  }

  // Sherd 1 has 10YR 3/1 outside, from a person.
  void whatThePhotographsProposeIsEnteredByAPressOnly() {
    colour::MunsellProposals proposals;
    proposals.out = colour::proposedFor({152, 114, 83});
    proposals.core = colour::proposedFor({84, 69, 53});
    sample_->propose(0, proposals);
    choose(0);
    auto* told = child<QLabel>("proposed_munsell_out");
    QTRY_VERIFY(told->isVisible());
    QVERIFY2(told->text().contains("7.5YR 5/4 (Delta E 2000: 0.9), then 5YR 5/4 (2.2)"),
             qPrintable(told->text()));
    QVERIFY(told->text().endsWith("Rough estimate."));
    QVERIFY(told->toolTip().contains("no usable colour chart"));
    QVERIFY(told->toolTip().contains("first"));
    QVERIFY(!child<QLabel>("proposed_munsell_in")->isVisible());
    QCOMPARE(sample_->value(0, "munsell_out"), QString("10YR 3/1"));
    QCOMPARE(sample_->value(0, "munsell_core"), QString());
    auto* take_over = child<QPushButton>("takeOver_munsell_core");
    QVERIFY(take_over->y() > child<QLabel>("proposed_munsell_core")->y());
    const auto* note = child<QLineEdit>("field_note");
    QTest::qWait(100);  // for the rows
    const int below = note->y();
    take_over->click();
    QCOMPARE(sample_->value(0, "munsell_core"), QString("10YR 3/2"));
    QCOMPARE(child<QLineEdit>("field_munsell_core")->text(), QString("10YR 3/2"));
    QTRY_VERIFY(!take_over->isEnabled());
    QTest::qWait(0);
    QVERIFY2(child<QLabel>("proposed_munsell_core")->isVisible(), "no field moves");
    QCOMPARE(note->y(), below);
    QCOMPARE(sample_->session().undo().undoText(), QString("change Munsell core"));
    const auto history = catalogue::History(sample_->catalogue()).of(sample_->row(0));
    QCOMPARE(history->front().new_value, std::string("10YR 3/2"));
    QVERIFY2(static_cast<bool>(history->front().by), "a person's word, as if it were typed");
    proposals.chart = {0.84, 1.92};
    sample_->propose(1, proposals);
    const QString number = QString::fromStdString(sample_->stored(1).number);
    int row = 0;  // in the table's own order
    while (child<QLineEdit>("field_number")->text() != number) choose(++row);
    QTRY_VERIFY(told->text().endsWith("Measured."));
    QVERIFY2(told->toolTip().contains("median 0.8, 95 % 1.9"), qPrintable(told->toolTip()));
    choose(row + 1);
    QVERIFY2(!told->isVisible(), "it has no model");
  }

  // As when it is typed at the capture.
  void digitsAreTheRunningNumberInTheSherdsContext() {
    choose(0);
    auto* number = child<QLineEdit>("field_number");
    const auto type = [&](const QString& value) {
      number->setFocus();
      number->selectAll();
      QTest::keyClicks(number, value);
      QTest::keyClick(number, Qt::Key_Return);
      return sample_->value(0, "number");
    };
    QCOMPARE(type("62"), QString("ARM1-T3-0012-0062"));
    QCOMPARE(number->text(), QString("ARM1-T3-0012-0062"));
    QCOMPARE(type("62"), QString("ARM1-T3-0012-0062"));
    QCOMPARE(number->text(), QString("ARM1-T3-0012-0062"));
    QVERIFY(number->toolTip().contains("=7"));
    QCOMPARE(type("=62"), QString("62"));
    QCOMPARE(type("2"), QString("62"));  // of row 2
    QVERIFY(child<QLabel>("refusalText")->isVisible());
    QCOMPARE(number->text(), QString("2"));
  }

  // In an English window 4,246 is how the window writes thousands itself.
  void aNumberThatReadsInTwoWaysIsAskedForAgain() {
    choose(0);
    const QString before = sample_->value(0, "weight_g");
    auto* weight = child<QLineEdit>("field_weight_g");
    const auto type = [&](const QString& value) {
      weight->setFocus();
      weight->selectAll();
      QTest::keyClicks(weight, value);
      QTest::keyClick(weight, Qt::Key_Return);
      return sample_->value(0, "weight_g");
    };
    QCOMPARE(type("1,250"), before);
    QVERIFY2(child<QLabel>("refusalText")->text().startsWith("'1,250' can be read as 1250 or as"),
             qPrintable(child<QLabel>("refusalText")->text()));
    QCOMPARE(weight->text(), QString("1,250"));
    QCOMPARE(type("1250"), QString("1250"));
    QVERIFY(!child<QLabel>("refusalText")->isVisible());
    QCOMPARE(type("12,75"), QString("12.75"));
    const QLocale english;
    QLocale::setDefault(QLocale(QLocale::German));
    const QString refused = type("1.250"), taken = type("1,250");
    QLocale::setDefault(english);
    QCOMPARE(refused, QString("12.75"));
    QCOMPARE(taken, QString("1.25"));
  }

  // Keys and buttons that take the cursor out of no field.
  void whatIsBeingTypedOutlivesUndoAndNumbers() {
    filter("state:draft");
    sample_->addDraft();
    filter("state:draft");
    choose(0);
    auto* ware = child<QLineEdit>("field_ware");
    ware->setFocus();
    QTest::keyClicks(ware, "grey");
    QTest::keyClick(ware, Qt::Key_Return);
    QCOMPARE(sample_->value(40, "ware"), QString("grey"));
    auto* note = child<QLineEdit>("field_note");
    note->setFocus();
    QTest::keyClicks(note, "half a ");
    sample_->session().undo().undo();
    QCOMPARE(sample_->value(40, "ware"), QString());
    QCOMPARE(ware->text(), QString());
    QCOMPARE(note->text(), QString("half a "));
    child<QAction>("giveNumbers")->trigger();
    QCOMPARE(sample_->value(40, "state"), QString("numbered"));
    QVERIFY(note->hasFocus());
    QTest::keyClicks(note, "sentence");
    QTest::keyClick(note, Qt::Key_Tab);
    QCOMPARE(sample_->value(40, "note"), QString("half a sentence"));
  }

  void aSherdIsVoidOnlyWhenAPersonSaysSoOnceMore() {
    choose(0);
    auto* line = child<QLineEdit>("field_void_reason");
    line->setFocus();
    QTest::keyClicks(line, "x");
    QTest::keyClick(line, Qt::Key_Tab);  // meant for the note above
    auto* yes = child<QPushButton>("confirmChange");
    QVERIFY(yes->isVisible());
    QCOMPARE(sample_->value(0, "state"), QString("numbered"));
    line->setFocus();
    QTest::keyClick(line, Qt::Key_Escape);
    QVERIFY(!yes->isVisible());
    QTest::keyClicks(line, "a stone");
    QTest::keyClick(line, Qt::Key_Return);
    QTest::mousePress(yes, Qt::LeftButton);
    QVERIFY2(!yes->hasFocus(), "what gets the focus is brought into view, off the pointer");
    screen_->findChild<SherdDetails*>()->setFocus();  // as a press beside all fields does
    QVERIFY2(yes->isDown(), "the question is not asked anew under the pointer");
    QTest::mouseRelease(yes, Qt::LeftButton);
    QCOMPARE(sample_->value(0, "state"), QString("void"));
    QCOMPARE(sample_->value(0, "void_reason"), QString("a stone"));
    QVERIFY(!yes->isVisible());
    QCOMPARE(screen_->focusWidget(), line);
    // Nothing was typed in it since: the shortcut is not the field's.
    QKeyEvent undo(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
    undo.ignore();
    QApplication::sendEvent(line, &undo);
    QVERIFY(!undo.isAccepted());
    QTest::keyClicks(line, "x");
    QApplication::sendEvent(line, &undo);
    QVERIFY(undo.isAccepted());
    QTest::keyClick(line, Qt::Key_Escape);
    sample_->session().undo().undo();
    QCOMPARE(sample_->value(0, "state"), QString("numbered"));
  }

  // 7 for 72: one key of a tired hand.
  void aSlipOverAComputedLengthIsAskedAboutAndTheComputedOneIsKept() {
    records::Measurement length;
    length.sherd = sample_->sherds()[0];
    length.kind = "length";
    length.unit = "mm";
    length.value = 72.39;
    length.method = "program";
    // The sample's own length is a person's; only where that is gone the computed one stands.
    const records::FieldChange clear{length.sherd, "length_mm", "", records::Confirmation::Given};
    QVERIFY(sherds::SherdChanges(sample_->catalogue()).apply(std::span(&clear, 1), {}).has_value());
    QVERIFY(sherds::Measurements(sample_->catalogue()).add(length, {}).has_value());
    choose(0);
    auto* line = child<QLineEdit>("field_length_mm");
    const QString computed = line->text();
    const auto type = [line](const char* text) {
      line->setFocus();
      line->selectAll();
      QTest::keyClicks(line, text);
      QTest::keyClick(line, Qt::Key_Return);
    };
    type("7");
    auto* yes = child<QPushButton>("confirmChange");
    QVERIFY(yes->isVisible());
    const QString question = child<QLabel>("refusalText")->text();
    QVERIFY2(question.contains("about a tenth") && question.contains("below the width"),
             qPrintable(question));
    QCOMPARE(sample_->value(0, "length_mm"), computed);
    QVERIFY2(screen_->losesByClosing().contains("length", Qt::CaseInsensitive),
             qPrintable(screen_->losesByClosing()));
    QTest::keyClick(line, Qt::Key_Tab);
    QCOMPARE(screen_->focusWidget(), yes);  // the next after the field
    line->setFocus();
    // The question and its button are seen whole, at the end of a small page, too.
    QTRY_COMPARE(yes->visibleRegion().boundingRect(), yes->rect());
    QTest::keyClick(line, Qt::Key_Escape);
    QVERIFY(!yes->isVisible());
    QCOMPARE(line->text(), computed);
    type("71.5");  // plausible, and still not without a word
    QVERIFY(yes->isVisible());
    QCOMPARE(yes->text(), QString("Replace with measured value"));
    QTest::mouseClick(yes, Qt::LeftButton);
    QCOMPARE(sample_->value(0, "length_mm"), QString("71.5"));
    const auto sherd = sherds::Sherds(sample_->catalogue()).get(sample_->sherds()[0]);
    QCOMPARE(QString::number(sherd->replaced.at("length")), computed);
    // Its mark in the table leaves room for the figure.
    const QAbstractItemModel* rows = table()->model();
    int marks = 0;
    for (int column = 1; column < rows->columnCount(); ++column)
      if (const QVariant mark = rows->index(0, column).data(Qt::DecorationRole); mark.isValid()) {
        ++marks;
        QCOMPARE(rows->headerData(column, Qt::Horizontal).toString(), QString("length, mm"));
        QVERIFY(mark.value<QPixmap>().width() > 0 && mark.value<QPixmap>().width() <= 24);
      }
    QCOMPARE(marks, 1);
  }

  void aFieldOfTheUsersOwnIsAFieldLikeTheOthers() {
    const records::FieldChange shelf{sample_->row(0), "extra.shelf", "4"};
    SampleProject::must(sherds::SherdChanges(sample_->catalogue()).apply(std::span(&shelf, 1), {}));
    auto* details = screen_->findChild<SherdDetails*>();
    details->setVocabularies(sample_->catalogue());
    choose(0);
    auto* line = child<QLineEdit>("field_extra.shelf");
    QCOMPARE(line->accessibleName(), QString("shelf"));
    QCOMPARE(line->text(), QString("4"));
    QTRY_VERIFY(line->isVisible());  // the form shows a new row once events are processed
    child<QLineEdit>("field_note")->setFocus();
    QTest::keyClick(screen_->focusWidget(), Qt::Key_Tab);
    QCOMPARE(screen_->focusWidget(), line);
    choose(1);  // sorted by number: sample 2
    QCOMPARE(line->text(), QString());
    line->setFocus();
    QTest::keyClicks(line, "5");
    QTest::keyClick(line, Qt::Key_Tab);
    QCOMPARE(screen_->focusWidget()->objectName(), QString("field_void_reason"));
    QCOMPARE(sample_->value(2, "extra.shelf"), QString("5"));
    QCOMPARE(sample_->session().undo().undoText(), QString("change shelf"));
    sample_->session().undo().undo();
    QCOMPARE(sample_->value(2, "extra.shelf"), QString());
    // Another project has none.
    SampleProject other(1);
    details->clear();
    details->setVocabularies(other.catalogue());
    QVERIFY(screen_->findChild<QLineEdit*>("field_extra.shelf") == nullptr);
  }

  void tabGoesFromTheNumberDownTheForm() {
    choose(0);
    auto* number = child<QLineEdit>("field_number");
    number->setFocus();
    QTest::keyClick(number, Qt::Key_Tab);
    QCOMPARE(screen_->focusWidget()->objectName(), QString("field_place"));
    child<QLineEdit>("field_note")->setFocus();
    QTest::keyClick(screen_->focusWidget(), Qt::Key_Tab);
    QCOMPARE(screen_->focusWidget()->objectName(), QString("field_void_reason"));
  }

  void theSameContextChosenAgainKeepsTheBag() {
    choose(0);
    auto* place = child<QComboBox>("field_place");
    const int before = sample_->session().undo().count();
    emit place->activated(place->currentIndex());
    QCOMPARE(sample_->session().undo().count(), before);
  }

  void aRefusalIsInThePersonsLanguage() {
    class Marks final : public QTranslator {
      QString translate(const char* context, const char* source, const char*, int) const override {
        return qstrcmp(context, "ostraka::Error") == 0 ? "<" + QString::fromUtf8(source) + ">"
                                                       : QString();
      }
      bool isEmpty() const override { return false; }
    } marks;
    QVERIFY(QCoreApplication::installTranslator(&marks));
    choose(1);
    auto* text = child<QLabel>("refusalText");
    const auto refused = [&](const char* field, const QString& value) {
      auto* line = child<QLineEdit>(field);
      line->setFocus();
      line->selectAll();
      QTest::keyClicks(line, value);
      QTest::keyClick(line, Qt::Key_Return);
      return text->text();
    };
    const QString weight = refused("field_weight_g", "abc"), bag = refused("field_bag", "neck"),
                  number = refused("field_number", "ARM1-T3-0012-0001");
    QCoreApplication::removeTranslator(&marks);
    QCOMPARE(weight, QString("<'abc' is not a number; write 12.5 or 12,5, without a unit.>"));
    QVERIFY2(bag.startsWith("<There is no bag neck in context 0012 yet"), qPrintable(bag));
    QVERIFY2(number.startsWith("<The number ARM1-T3-0012-0001 belongs to another sherd.>"),
             qPrintable(number));
  }
};

OSTRAKA_UI_TEST(DetailsTest)
#include "details_test.moc"
