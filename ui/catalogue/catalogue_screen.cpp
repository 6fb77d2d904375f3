#include "ui/catalogue/catalogue_screen.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "catalogue/batches.h"
#include "records/sherd.h"
#include "sherds/sherds.h"
#include "tables/import_table.h"
#include "ui/catalogue/compare_window.h"
#include "ui/catalogue/drawing_page.h"
#include "ui/catalogue/frozen_column.h"
#include "ui/catalogue/model_pane.h"
#include "ui/catalogue/places_dialog.h"
#include "ui/frame/no_batch_yet.h"
#include "ui/frame/project_session.h"
#include "ui/look/look.h"
#include "ui/merge/merge_dialog.h"
#include "ui/merge/merge_model.h"
#include "ui/sherds/bulk_edit.h"
#include "ui/sherds/field_words.h"
#include "ui/sherds/filter_line.h"
#include "ui/sherds/number_delegate.h"
#include "ui/sherds/sherd_details.h"
#include "ui/sherds/sherd_edits.h"
#include "ui/sherds/sherd_table_model.h"
#include "ui/tables/import_dialog.h"
#include "ui/tables/import_model.h"
#include "ui/widgets/big_button.h"
#include "ui/widgets/message_panel.h"
#include "ui/widgets/page_acts.h"
#include "ui/widgets/page_area.h"
#include "ui/widgets/parts.h"
#include "upkeep/project.h"

namespace ostraka::ui {

CatalogueScreen::CatalogueScreen(QWidget* parent)
    : Screen(tr("Catalogue"), QStringLiteral("catalogue"), parent) {
  model_ = new SherdTableModel(this);
  import_ = new ImportModel(this);
  merge_ = new MergeModel(this);
  buildLayout();
  addActions();
  connect(model_, &SherdTableModel::failed, this, &CatalogueScreen::complain);
  connect(model_, &QAbstractItemModel::modelReset, this, [this] {
    showCount();
    showSelection();
  });
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          [this] { showSelection(); });
  connect(details_, &SherdDetails::edited, this, &CatalogueScreen::saveField);
  connect(details_, &SherdDetails::confirmed, this,
          [this](const QString& field, const QString& value) {
            keepField(field, value, records::Confirmation::Given);
          });
  connect(details_, &SherdDetails::numberWanted, this, &CatalogueScreen::giveNumbers);
  connect(details_, &SherdDetails::numberingWanted, this,
          [this] { emit wantsScreen("settings", "numbering"); });
  connect(bulk_, &BulkEdit::numbersWanted, this, &CatalogueScreen::giveNumbers);
  connect(bulk_, &BulkEdit::comparisonWanted, this, &CatalogueScreen::compare);
  connect(import_, &ImportModel::entered, this,
          [this](const QString& source, const tables::ImportReport& report) {
            const QString name = source.section('/', -1);
            edits_->took(tr("changes by the import of %1").arg(name), report.changes, report.undo);
            details_->setVocabularies(session_->project().catalogue());
            reload();
            if (report.not_reached > 0) complain(import_->problem());
            emit said(tr("Imported %1: %2").arg(name, import_->summary()));
          });
  connect(merge_, &MergeModel::entered, this, &CatalogueScreen::tookProject);
  connect(bulk_, &BulkEdit::wanted, this, &CatalogueScreen::changeAll);
  setEnabled(false);
}

QWidget* CatalogueScreen::buildFilterLine() {
  filter_ = new FilterLine(this);
  connect(filter_, &FilterLine::wanted, this, [this](const QString& line) {
    const QString why_not = model_->setFilter(line);
    complain(why_not);
    filter_->showConditions(why_not.isEmpty() ? model_->filter() : sherds::Filter());
  });
  QPushButton* to_import =
      iconButton(this, "import", "import", tr("Import…"), this, &CatalogueScreen::openImport);
  to_import->setToolTip(tr("Numbers, contexts and descriptions from a table, or an export (%1)")
                            .arg(QKeySequence(Qt::CTRL | Qt::Key_I).toString()));
  export_ = new BigButton("exportThese", tr("Export these"), this);
  connect(export_, &QPushButton::clicked, this, [this] {
    const QString some = chosen();
    emit wantsScreen("export", some.isEmpty() ? QStringLiteral("filter:") : some);
  });
  filter_->addButton(to_import);
  filter_->addButton(export_);
  return filter_;
}

QWidget* CatalogueScreen::buildWho() {
  who_ = new QWidget(this);
  auto* initials = named<QLineEdit>({"initials", tr("Your initials")}, who_);
  initials->setMaximumWidth(initials->fontMetrics().averageCharWidth() * 12);
  filled(bareLayout<QHBoxLayout>(who_),
         {labelFor(initials, tr("Who is working? Your initials go into the history:")), initials,
          Part::room()});
  connect(initials, &QLineEdit::editingFinished, this, [this, initials] {
    if (session_ && !initials->text().trimmed().isEmpty())
      session_->setInitials(initials->text().trimmed());
    if (session_) initials->setText(session_->initials());
  });
  return who_;
}

// The table, or why there is none.
QWidget* CatalogueScreen::buildLeft() {
  table_ = named<QTableView>({"sherds", tr("Sherds")}, this);
  table_->setModel(model_);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSortingEnabled(true);
  table_->setAlternatingRowColors(true);
  table_->setShowGrid(false);
  table_->setWordWrap(false);
  table_->setTabKeyNavigation(false);
  table_->setItemDelegateForColumn(0, new NumberDelegate(table_));
  const int height = Look::kRow;
  table_->setIconSize(
      {5 * Look::kThumbnail / 2, Look::kThumbnail});  // front, back and side of the sherd
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table_->verticalHeader()->setDefaultSectionSize(height);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->horizontalHeader()->setSortIndicator(0, Qt::AscendingOrder);
  // Room for the heading with its arrow, and for a picture with a whole number.
  const int letter = fontMetrics().averageCharWidth();
  for (int column = 0; column < model_->columnCount(); ++column) {
    const QString heading = model_->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
    table_->setColumnWidth(column,
                           std::max(fontMetrics().horizontalAdvance(heading) + 5 * letter,
                                    column == 0 ? 5 * height / 2 + 22 * letter : 12 * letter));
  }
  freezeFirstColumn(*table_);
  connect(table_, &QTableView::activated, this, [this] { openDetails(); });
  none_ = new NoBatchYet("sherd", tr("No sherds yet"),
                         tr("Sherds appear here when a batch is processed."), this);
  no_match_ = new EmptyState("filter", tr("No sherds match this filter"),
                             tr("Remove a condition to see more."), this);
  clear_ = no_match_->addAct(tr("Clear filter"), "clearFilter");
  connect(clear_, &QPushButton::clicked, this, [this] { filter_->setText({}); });
  left_ = new QStackedWidget(this);
  left_->addWidget(table_);
  left_->addWidget(new PageArea(none_, left_));
  left_->addWidget(new PageArea(no_match_, left_));
  return left_;
}

void CatalogueScreen::buildLayout() {
  QWidget* filter_line = buildFilterLine();
  problem_ = wrappedLabel(this, "problem");
  connect(problem_, &QLabel::linkActivated, this, &CatalogueScreen::forgetImports);
  problem_->hide();
  QWidget* who = buildWho();
  QSplitter* split =
      filled(new QSplitter(Qt::Horizontal, this), {{buildLeft(), 3}, {buildRight(), 1}});
  split->setChildrenCollapsible(false);
  split->setSizes({760, 420});
  filled(pageColumn(this), {filter_line, problem_, who, {split, 1}});
}

QWidget* CatalogueScreen::buildRight() {
  details_ = named<SherdDetails>("details", this);
  bulk_ = new BulkEdit(this);
  model_pane_ = new ModelPane(this);
  drawing_ = new DrawingPage(this);
  QSplitter* one = filled(new QSplitter(Qt::Vertical, this), {{model_pane_, 3}, {details_, 4}});
  one->setChildrenCollapsible(false);
  one->setSizes({300, 400});
  one_ = one;
  edit_ = new QStackedWidget(this);
  edit_->addWidget(one_);
  many_ = new PageArea(bulk_, edit_);
  edit_->addWidget(many_);
  right_ = named<QTabWidget>({"right", tr("About what is chosen")}, this);
  right_->addTab(edit_, icon("edit"), tr("Details"));
  drawing_tab_ = right_->addTab(new PageArea(drawing_, right_), icon("drawing"), tr("Drawing"));
  right_->tabBar()->setAccessibleName(tr("Details or drawing"));
  right_->setUsesScrollButtons(false);  // they would cut a tab's name rather than shorten it
  right_->setElideMode(Qt::ElideRight);
  show_model_ = named<QToolButton>("showModel", right_);
  show_model_->setIcon(icon("model"));
  show_model_->setText(tr("Model"));
  show_model_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  show_model_->setCheckable(true);
  show_model_->setAutoRaise(true);
  show_model_->setChecked(true);
  connect(show_model_, &QToolButton::toggled, this, &CatalogueScreen::followModel);
  connect(model_pane_, &ModelPane::largeChanged, this, &CatalogueScreen::followModel);
  right_->setCornerWidget(show_model_);
  connect(drawing_, &DrawingPage::said, this, &Screen::said);
  connect(drawing_, &DrawingPage::measuresWanted, this,
          [this](const std::vector<records::FieldChange>& changes) {
            if (edits_) complain(edits_->change(tr("enter the rim's diameter"), changes));
          });
  return right_;
}

void CatalogueScreen::addActions() {
  const auto add = [this](const QString& text, const QString& picture, const QKeySequence& keys,
                          const char* name, auto act) {
    QAction* made = addPageAct(this, name, picture, text, keys, this, act);
    made->setAutoRepeat(false);
    return made;
  };
  add(tr("Search"), "search", QKeySequence::Find, "search", [this] { filter_->takeKeys(); });
  QAction* edit = add(tr("Edit"), "edit", Qt::Key_F2, "edit", [this] { openDetails(); });
  QAction* drawing =
      add(tr("Drawing"), "drawing", QKeySequence(Qt::CTRL | Qt::Key_D), "drawing", [this] {
        right_->setCurrentIndex(drawing_tab_);
        drawing_->setFocus(Qt::ShortcutFocusReason);
      });
  compare_ = add(tr("Compare"), "compare", QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C),
                 "compare", [this] { compare(); });
  compare_->setEnabled(false);
  add(tr("Import"), "import", QKeySequence(Qt::CTRL | Qt::Key_I), "openImport",
      [this] { openImport(); });
  QAction* number =
      add(tr("Assign numbers"), "label", QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N),
          "giveNumbers", [this] { giveNumbers(); });
  QAction* labels = add(tr("Print labels"), "print", QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_L),
                        "printLabels", [this] { printLabels(); });
  QAction* places = add(tr("Rename places"), "map", QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_R),
                        "renamePlaces", [this] { renamePlaces(); });
  table_->setContextMenuPolicy(Qt::ActionsContextMenu);
  table_->addActions({edit, drawing, compare_, number, labels, places});
}

// F2, Enter and a double click: what is chosen can be typed into at once.
void CatalogueScreen::openDetails() {
  right_->setCurrentWidget(edit_);
  if (compact_) show_model_->setChecked(false);
  model_pane_->setLarge(false);
  if (edit_->currentWidget() == many_)
    bulk_->findChild<QLineEdit*>("bulkValue")->setFocus(Qt::ShortcutFocusReason);
  else
    details_->edit();
}

// In the order of the table.
void CatalogueScreen::compare() {
  std::vector<store::SherdRow> two = selected();
  if (!session_ || two.size() != 2) return;
  if (model_->rowOf(two[0]) > model_->rowOf(two[1])) std::swap(two[0], two[1]);
  if (!compare_window_) compare_window_ = new CompareWindow(*session_, this);
  compare_window_->showSherds(two[0], two[1]);
  compare_window_->show();
  compare_window_->activateWindow();
}

QAbstractButton* CatalogueScreen::primary() const {
  const int shown = left_->currentIndex();
  return shown == 0 ? export_ : shown == 1 ? none_->act() : clear_;
}

// Details and model one at a time, where both would show a line each.
void CatalogueScreen::setCompact(bool compact) {
  if (compact != std::exchange(compact_, compact)) show_model_->setChecked(!compact);
  // In few pixels the words say more than the pictures beside them.
  right_->setTabIcon(0, compact ? QIcon() : icon("edit"));
  right_->setTabIcon(drawing_tab_, compact ? QIcon() : icon("drawing"));
  followModel();
}

// Without the model the details have its height.
void CatalogueScreen::followModel() {
  const bool shown = show_model_->isChecked(), large = shown && model_pane_->isLarge();
  model_pane_->setVisible(shown);
  left_->setVisible(!large);
  details_->setVisible(!large && !(compact_ && shown));
}

void CatalogueScreen::openProject(ProjectSession& session) {
  closeProject();
  session_ = &session;
  edits_ = new SherdEdits(session, this);
  connect(edits_, &SherdEdits::changed, this, &CatalogueScreen::sherdsChanged);
  connect(edits_, &SherdEdits::failed, this, &CatalogueScreen::complain);
  connect(edits_, &SherdEdits::noted, this, &CatalogueScreen::complain);
  connect(edits_, &SherdEdits::busyChanged, this, [this] {
    bulk_->showProgress(edits_->isBusy() ? edits_->fraction() : -1);
    table_->setEnabled(!edits_->isBusy());  // what is being changed stays chosen
    details_->setEnabled(!edits_->isBusy());
    showNewRows();
  });
  connect(bulk_, &BulkEdit::stopWanted, edits_, &SherdEdits::stop);
  const auto showNews = [this] {
    stale_ = true;
    showNewRows();
  };
  connect(&session, &ProjectSession::batchChanged, this, showNews);
  const auto showNewWords = [this, showNews] {
    details_->setVocabularies(session_->project().catalogue());
    model_->readVocabularies();
    showNews();
  };
  connect(&session, &ProjectSession::othersWrote, this, showNewWords);
  connect(&session, &ProjectSession::vocabulariesChanged, this, [this, showNewWords] {
    complain({});  // what could not be done by the old ones
    showNewWords();
  });
  connect(&session, &ProjectSession::stepRefused, this, [this](const QString& why) {
    if (isVisible()) complain(why);
  });
  connect(&session, &ProjectSession::initialsChanged, this, [this](const QString& initials) {
    if (!isVisible() || initials.isEmpty()) who_->setVisible(initials.isEmpty());
  });
  who_->setVisible(session.initials().isEmpty());
  details_->setVocabularies(session.project().catalogue());
  model_->setCatalogue(&session.project().catalogue(), session.folder(), &session.jobs());
  setEnabled(true);
  tellOfImports();
}

void CatalogueScreen::closeProject() {
  if (session_) disconnect(session_, nullptr, this, nullptr);
  session_ = nullptr;
  delete import_dialog_.data();
  import_->openProject(nullptr);
  delete merge_dialog_.data();
  delete places_dialog_.data();
  delete compare_window_.data();
  merge_->openProject(nullptr);
  delete edits_;
  edits_ = nullptr;
  filter_->clear();
  model_->setCatalogue(nullptr, {}, nullptr);
  bulk_->setSherds(nullptr, {});
  details_->clear();
  details_->forgetUnsaved();
  model_pane_->clear();
  drawing_->setSherds(nullptr, {});
  complain({});
  setEnabled(false);
}

void CatalogueScreen::setInFront(bool in_front) {
  // Once answered the question goes with the page: the table stays where it is looked at.
  if (!in_front && session_) who_->setVisible(session_->initials().isEmpty());
  if (in_front) table_->setFocus();  // the arrow keys choose a sherd
  if (in_front) showNewRows();
}

void CatalogueScreen::showNewRows() {
  // While many are being changed, what is chosen stays as it is.
  if (stale_ && session_ && isVisible() && !edits_->isBusy()) reload();
}

// What was chosen stays chosen, and what is being typed about it stays in its line: nothing else is
// shown in between.
void CatalogueScreen::reload() {
  stale_ = false;
  const std::vector<store::SherdRow> chosen = selected();
  const store::SherdRow current = model_->sherdAt(table_->currentIndex().row());
  {
    const QScopedValueRollback<bool> reloading(reloading_, true);
    model_->reload();
    choose(chosen, current);
  }
  const auto sorted = [](std::vector<store::SherdRow> sherds) {
    std::sort(sherds.begin(), sherds.end());
    return sherds;
  };
  if (chosen.size() < 2 || sorted(selected()) != sorted(chosen)) return showSelection();
  bulk_->preview();
  drawing_->setSherds(session_, chosen);
}

// Those of them that are in the table.
void CatalogueScreen::choose(const std::vector<store::SherdRow>& sherds, store::SherdRow current) {
  std::vector<int> rows;
  for (const store::SherdRow sherd : sherds)
    if (const int row = model_->rowOf(sherd); row >= 0) rows.push_back(row);
  std::sort(rows.begin(), rows.end());
  QItemSelection all;
  for (std::size_t first = 0, next = 1; first < rows.size(); first = next++) {
    while (next < rows.size() && rows[next] == rows[next - 1] + 1) ++next;
    all.append(
        {model_->index(rows[first], 0), model_->index(rows[next - 1], model_->columnCount() - 1)});
  }
  table_->selectionModel()->select(all, QItemSelectionModel::ClearAndSelect);
  if (const int row = model_->rowOf(current); row >= 0)
    table_->selectionModel()->setCurrentIndex(model_->index(row, 0), QItemSelectionModel::NoUpdate);
}

void CatalogueScreen::showItem(const QString& what) {
  if (!session_) return;
  const auto sherd = sherds::Sherds(session_->project().catalogue()).byNumber(what.toStdString());
  if (!sherd || !*sherd) {
    filter_->setText(
        catalogue::Batches(session_->project().catalogue()).byNumber(what.toStdString())
            ? "batch:" + what
            : what);
    if (model_->rowCount() > 0) table_->selectRow(0);
    return;
  }
  if (model_->rowOf(*sherd) < 0) {
    filter_->setText({});
  }
  table_->selectRow(model_->rowOf(*sherd));
  table_->scrollTo(model_->index(model_->rowOf(*sherd), 0), QAbstractItemView::PositionAtCenter);
}

void CatalogueScreen::showCount() {
  const int rows = model_->rowCount();
  filter_->showCount(rows);
  if (rows == 0) none_->follow(session_);
  left_->setCurrentIndex(rows > 0 ? 0 : model_->filter().conditions.empty() ? 1 : 2);
  right_->setVisible(left_->currentIndex() != 1);  // of no sherd there is nothing to fill in
  export_->setEnabled(rows > 0);                   // the one thing to do is another then
}

std::vector<store::SherdRow> CatalogueScreen::selected() const {
  std::vector<store::SherdRow> sherds;
  for (const QItemSelectionRange& range : table_->selectionModel()->selection())
    for (int row = range.top(); row <= range.bottom(); ++row)
      sherds.push_back(model_->sherdAt(row));
  return sherds;
}

// One is only looked at: what is listed is meant then.
QString CatalogueScreen::chosen() const {
  QStringList rows;
  for (const store::SherdRow row : selected()) rows << QString::number(row.value);
  if (rows.size() > 1) return "rows:" + rows.join(',');
  return filter_->text().isEmpty() ? QString() : "filter:" + filter_->text();
}

void CatalogueScreen::showSelection() {
  if (reloading_) return;
  const std::vector<store::SherdRow> sherds = selected();
  compare_->setEnabled(session_ != nullptr && sherds.size() == 2);
  export_->setText(sherds.size() < 2 ? tr("Export these")
                                     : tr("Export %n sherd(s)", nullptr, int(sherds.size())));
  if (!session_ || sherds.empty()) {
    edit_->setCurrentWidget(one_);
    details_->clear();
    model_pane_->clear();
  } else if (sherds.size() == 1) {
    edit_->setCurrentWidget(one_);
    details_->showSherd(session_->project().catalogue(), session_->folder(), sherds.front(),
                        session_->jobs());
    showModelOf(sherds.front());
  } else {
    bulk_->setSherds(session_, sherds);
    edit_->setCurrentWidget(many_);
  }
  drawing_->setSherds(session_, sherds);
}

void CatalogueScreen::showModelOf(store::SherdRow row) {
  const auto sherd = sherds::Sherds(session_->project().catalogue()).get(row);
  if (sherd)
    model_pane_->showSherd(session_->jobs(), session_->folder(), *sherd);
  else
    model_pane_->clear();
}

void CatalogueScreen::sherdsChanged(const std::vector<store::SherdRow>& sherds) {
  complain({});
  model_->refresh(sherds);
  showSelection();
}

void CatalogueScreen::complain(const QString& sentence) {
  problem_->setText(sentence);
  // Only what says something can be reached by keyboard.
  problem_->setTextInteractionFlags(sentence.isEmpty() ? Qt::NoTextInteraction
                                                       : Qt::TextBrowserInteraction);
  problem_->setVisible(!sentence.isEmpty());
}

}  // namespace ostraka::ui
