#include "ui/catalogue/frozen_column.h"

#include <QEvent>
#include <QHeaderView>
#include <QScrollBar>
#include <QTableView>

namespace ostraka::ui {
namespace {

class FrozenColumn final : public QTableView {
 public:
  explicit FrozenColumn(QTableView& table) : QTableView(&table), table_(table) {
    setObjectName(table.objectName() + QStringLiteral("Frozen"));
    setAccessibleName(table.accessibleName());
    setModel(table.model());
    setSelectionModel(table.selectionModel());
    takeLook();
    const QHeaderView* columns = table.horizontalHeader();
    connect(columns, &QHeaderView::sectionResized, this, &FrozenColumn::place);
    connect(columns, &QHeaderView::sectionCountChanged, this, &FrozenColumn::hideOthers);
    connect(columns, &QHeaderView::sortIndicatorChanged, this, &FrozenColumn::showOrder);
    connect(horizontalHeader(), &QHeaderView::sectionClicked, this, &FrozenColumn::sort);
    connect(table.horizontalScrollBar(), &QScrollBar::valueChanged, this, &FrozenColumn::place);
    connect(table.verticalScrollBar(), &QScrollBar::valueChanged, verticalScrollBar(),
            &QScrollBar::setValue);
    connect(verticalScrollBar(), &QScrollBar::valueChanged, table.verticalScrollBar(),
            &QScrollBar::setValue);
    connect(this, &QTableView::activated, &table, &QTableView::activated);
    connect(this, &QTableView::pressed, &table, qOverload<>(&QWidget::setFocus));
    table.viewport()->installEventFilter(this);
    hideOthers();
    showOrder();
    hide();
  }

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::Resize || event->type() == QEvent::Move) place();
    return false;
  }

 private:
  void takeLook() {
    setSelectionBehavior(table_.selectionBehavior());
    setSelectionMode(table_.selectionMode());
    setEditTriggers(table_.editTriggers());
    setAlternatingRowColors(table_.alternatingRowColors());
    setShowGrid(table_.showGrid());
    setWordWrap(table_.wordWrap());
    setIconSize(table_.iconSize());
    setItemDelegateForColumn(0, table_.itemDelegateForColumn(0));
    setFocusPolicy(Qt::NoFocus);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(table_.verticalScrollMode());
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setDefaultSectionSize(table_.verticalHeader()->defaultSectionSize());
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setSectionsClickable(true);
    horizontalHeader()->setSortIndicatorShown(true);
  }

  void hideOthers() {
    for (int column = 1; column < model()->columnCount(); ++column) setColumnHidden(column, true);
    place();
  }

  // Where nothing is scrolled the table itself shows the column.
  void place() {
    setVisible(table_.horizontalScrollBar()->value() > table_.horizontalScrollBar()->minimum());
    if (isHidden()) return;
    setColumnWidth(0, table_.columnWidth(0));
    horizontalHeader()->setFixedHeight(table_.horizontalHeader()->height());
    const QRect rows = table_.viewport()->geometry();
    const int heading = table_.horizontalHeader()->height();
    setGeometry(rows.x(), rows.y() - heading, table_.columnWidth(0), rows.height() + heading);
    verticalScrollBar()->setValue(table_.verticalScrollBar()->value());
  }

  void showOrder() {
    const QHeaderView* columns = table_.horizontalHeader();
    horizontalHeader()->setSortIndicator(columns->sortIndicatorSection(),
                                         columns->sortIndicatorOrder());
  }

  void sort() {
    const QHeaderView* columns = table_.horizontalHeader();
    const bool ascends =
        columns->sortIndicatorSection() == 0 && columns->sortIndicatorOrder() == Qt::AscendingOrder;
    table_.sortByColumn(0, ascends ? Qt::DescendingOrder : Qt::AscendingOrder);
  }

  QTableView& table_;
};

}  // namespace

void freezeFirstColumn(QTableView& table) {
  table.setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  new FrozenColumn(table);  // the table's
}

}  // namespace ostraka::ui
