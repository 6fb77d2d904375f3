// Tools stand in one row; those without room are in the menu at its end.
#include "ui/widgets/tool_row.h"

#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QTest>
#include <QToolButton>

#include "tests/ui/program.h"
#include "ui/widgets/page_acts.h"

namespace ostraka::ui {

class ToolRowTest : public QObject {
  Q_OBJECT

 private slots:
  void init();
  void allToolsAreInTheRowWhereThereIsRoom();
  void theOthersAreInTheMenu();
  void aCompactRowHasNoCaptions();
  void whatIsInvisibleTakesNoRoom();
  void theKeyThatAcceptsHasOneName();

 private:
  QList<QAction*> inMenu() const { return row_->findChild<QMenu*>()->actions(); }

  std::unique_ptr<ToolRow> row_;
  QList<QAction*> view_, decide_;
};

// "Return" in one place and "Enter" in another are two keys to a person.
void ToolRowTest::theKeyThatAcceptsHasOneName() {
  QCOMPARE(keyText(Qt::Key_Return), QStringLiteral("Enter"));
  QCOMPARE(keyText(Qt::Key_Enter), QStringLiteral("Enter"));
  QCOMPARE(keyText(Qt::CTRL | Qt::Key_P), QStringLiteral("Ctrl+P"));
}

void ToolRowTest::init() {
  row_ = std::make_unique<ToolRow>();
  view_ = decide_ = {};
  for (const char* name : {"mirror", "section", "measure"}) {
    view_ << new QAction(QString::fromLatin1(name), row_.get());
    view_.last()->setObjectName(QString::fromLatin1(name));
  }
  decide_ << new QAction(QStringLiteral("aside"), row_.get());
  row_->addGroup(QStringLiteral("View"), view_);
  row_->addGroup(QStringLiteral("Decide"), decide_);
  row_->show();
}

void ToolRowTest::allToolsAreInTheRowWhereThereIsRoom() {
  row_->resize(row_->sizeHint());
  for (QAction* action : view_ + decide_) QVERIFY(row_->buttonOf(action)->isVisible());
  QVERIFY(!row_->findChild<QToolButton*>(QStringLiteral("moreTools"))->isVisible());
  QCOMPARE(row_->buttonOf(view_[0])->objectName(), QStringLiteral("mirrorButton"));
}

void ToolRowTest::theOthersAreInTheMenu() {
  row_->resize(row_->sizeHint().width() - 1, row_->sizeHint().height());
  const QToolButton* more = row_->findChild<QToolButton*>(QStringLiteral("moreTools"));
  QVERIFY(more->isVisible() && row_->rect().contains(more->geometry()));
  QVERIFY(!row_->buttonOf(decide_[0])->isVisible());
  QVERIFY(inMenu().contains(decide_[0]));
  row_->resize(row_->minimumSizeHint());
  for (QAction* action : view_ + decide_) QVERIFY(inMenu().contains(action));
}

void ToolRowTest::aCompactRowHasNoCaptions() {
  const int with = row_->sizeHint().height();
  row_->resize(row_->sizeHint());
  QVERIFY(row_->findChild<QLabel*>()->isVisible());
  row_->setCompact(true);
  QVERIFY(!row_->findChild<QLabel*>()->isVisible());
  QVERIFY(row_->sizeHint().height() < with);
}

void ToolRowTest::whatIsInvisibleTakesNoRoom() {
  const int wide = row_->sizeHint().width();
  decide_[0]->setVisible(false);
  QVERIFY(row_->sizeHint().width() < wide);
  row_->resize(wide, row_->sizeHint().height());
  QVERIFY(!row_->buttonOf(decide_[0])->isVisible());
  QVERIFY(!inMenu().contains(decide_[0]));
}

OSTRAKA_UI_TEST(ToolRowTest)

}  // namespace ostraka::ui

#include "tool_row_test.moc"
