#include "ui/tables/import_dialog.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/look/look.h"
#include "ui/tables/column_table.h"
#include "ui/widgets/big_button.h"
#include "ui/widgets/page_acts.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/screen_room.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {
namespace {

void showFate(QTableWidgetItem& cell, tables::RowFate fate) {
  const auto show = [&cell](const char* picture, const QString& words) {
    cell.setIcon(icon(picture));
    cell.setText(words);
  };
  switch (fate) {
    case tables::RowFate::Fresh:
      return show("plus", ImportDialog::tr("new"));
    case tables::RowFate::Changed:
      return show("edit", ImportDialog::tr("updated"));
    case tables::RowFate::Refused:
      return show("error", ImportDialog::tr("rejected"));
    case tables::RowFate::Asked:
      return show("question", ImportDialog::tr("to confirm"));
    case tables::RowFate::Same:
      return show("check", ImportDialog::tr("unchanged"));
  }
}

// A line on which kind of table it is taken for; none of an export folder.
QString kindOf(const ImportModel& model) {
  const QString kind = model.report() ? wordsOf(model.report()->mapping.kind) : QString();
  return kind.isEmpty() ? QString() : QLatin1Char('\n') + kind;
}

}  // namespace

ImportDialog::ImportDialog(ImportModel& model, QWidget* parent) : QDialog(parent), model_(model) {
  setObjectName("importDialog");
  setWindowTitle(tr("Import into the catalogue"));
  buildLayout();
  connect(&model_, &ImportModel::changed, this, &ImportDialog::refresh);
  connect(this, &QDialog::rejected, &model_, &ImportModel::cancel);
  resize(
      fittedToScreen(*this, {fontMetrics().averageCharWidth() * 110, fontMetrics().height() * 32}));
  refresh();
}

void ImportDialog::buildLayout() {
  choose_table_ = iconButton(this, "importTable", "table", tr("Table (CSV)…"), this,
                             &ImportDialog::chooseTable);
  choose_export_ = iconButton(this, "importExport", "folder", tr("Export folder…"), this,
                              &ImportDialog::chooseExport);
  merge_ = iconButton(this, "importMerge", "catalogue", tr("Another project…"), this,
                      &ImportDialog::mergeWanted);
  source_ = wrappedLabel(this, "importSource");
  places_ = named<QCheckBox>(
      "importPlaces", tr("Make sites, trenches, contexts and bags that are not there yet"), this);
  places_->setMinimumHeight(controlHeight(*this));
  connect(places_, &QCheckBox::toggled, &model_, &ImportModel::setMakesPlaces);
  summary_ = named<QLabel>("importSummary", this);
  summary_->setFont(scaledFont(*this, Look::kSection, true));
  problem_ = wrappedLabel(this, "importProblem");
  table_ = named<QTableWidget>({"importRows", tr("Effect of each row")}, this);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setTabKeyNavigation(false);
  table_->verticalHeader()->hide();
  connect(table_, &QTableWidget::itemChanged, this, &ImportDialog::confirmed);
  columns_ = new ColumnTable(model_, this);
  tabs_ = named<QTabWidget>("importTabs", this);
  tabs_->addTab(table_, tr("Rows"));
  tabs_->addTab(columns_, tr("Columns"));
  bar_ = new QProgressBar(this);
  bar_->setRange(0, 1000);
  bar_->setAccessibleName(tr("Progress of the import"));
  refusals_ = iconButton(this, "importRefusals", "export", tr("Save rejected rows…"), this,
                         &ImportDialog::saveRefusals);
  confirm_ = iconButton(this, "importConfirm", "check", {}, &model_, &ImportModel::confirmAll);
  cancel_ = iconButton(this, "importCancel", "cancel", {}, this, &ImportDialog::leave);
  enter_ = new BigButton("importEnter", {}, this);
  enter_->setDefault(true);
  connect(enter_, &QPushButton::clicked, &model_, &ImportModel::enter);
  auto* first = filled(new QHBoxLayout, {choose_table_, choose_export_, merge_, {source_, 1}});
  auto* last = filled(new QHBoxLayout, {refusals_, confirm_, Part::room(), cancel_, enter_});
  filled(new QVBoxLayout(this), {first, places_, summary_, problem_, {tabs_, 1}, bar_, last});
}

// What was stopped says here how far it came.
void ImportDialog::leave() {
  if (model_.state() == ImportModel::State::Entering) return model_.cancel();
  reject();
}

void ImportDialog::chooseTable() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Which table?"), {},
                                                    tr("Tables (*.csv *.tsv *.txt);;All (*)"));
  if (!file.isEmpty()) model_.setSource(file);
}

void ImportDialog::chooseExport() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Which export?"));
  if (!folder.isEmpty()) model_.setSource(folder);
}

void ImportDialog::saveRefusals() {
  const QString file = QFileDialog::getSaveFileName(this, tr("Save rejected rows"),
                                                    tr("rejected.csv"), tr("Tables (*.csv)"));
  if (file.isEmpty()) return;
  const Result<QString> saved = model_.saveRefusals(file);
  problem_->setText(saved ? tr("Saved: %1").arg(*saved) : sentenceOf(saved.error()));
  problem_->show();
}

// A row that asks enters once its box is checked.
void ImportDialog::confirmed(QTableWidgetItem* item) {
  if (item->column() == 1 && item->flags().testFlag(Qt::ItemIsUserCheckable))
    model_.setConfirmed(table_->item(item->row(), 0)->text().toInt(),
                        item->checkState() == Qt::Checked);
}

void ImportDialog::fill() {
  const QSignalBlocker quiet(table_);
  const std::vector<ImportModel::Row>& rows = model_.rows();
  const QStringList head = QStringList{tr("Line"), tr("Action"), tr("Reason")} + model_.columns();
  table_->setColumnCount(static_cast<int>(head.size()));
  table_->setHorizontalHeaderLabels(head);
  table_->setRowCount(static_cast<int>(rows.size()));
  for (int r = 0; r < table_->rowCount(); ++r) {
    const ImportModel::Row& row = rows[static_cast<std::size_t>(r)];
    auto* line = new QTableWidgetItem(QString::number(row.line));
    line->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    table_->setItem(r, 0, line);
    auto* fate = new QTableWidgetItem;
    showFate(*fate, row.fate);
    const bool asks = row.fate == tables::RowFate::Asked;
    fate->setFlags(fate->flags().setFlag(Qt::ItemIsUserCheckable, asks));
    if (asks) fate->setCheckState(Qt::Unchecked);
    table_->setItem(r, 1, fate);
    auto* why = new QTableWidgetItem(row.refusal);
    why->setToolTip(row.refusal);
    table_->setItem(r, 2, why);
    for (int c = 0; c < row.values.size() && c + 3 < table_->columnCount(); ++c) {
      auto* cell = new QTableWidgetItem(row.values[c]);
      if (row.changed.contains(c)) {
        cell->setIcon(icon("edit"));
        cell->setToolTip(row.values[c]);
      }
      table_->setItem(r, c + 3, cell);
    }
  }
  // First: a hidden column has no width to keep.
  const bool reasons =
      std::ranges::any_of(rows, [](const auto& row) { return !row.refusal.isEmpty(); });
  table_->setColumnHidden(2, !reasons);
  table_->resizeColumnsToContents();
  const int most = fontMetrics().averageCharWidth() * 60;
  for (int c = 0; c < table_->columnCount(); ++c)
    table_->setColumnWidth(c, std::min(table_->columnWidth(c), most));
  for (int r = 0; r < table_->rowCount(); ++r)  // a reason ends with what to do: it wraps
    if (reasons && !rows[static_cast<std::size_t>(r)].refusal.isEmpty())
      table_->resizeRowToContents(r);
}

// The columns come first where one of them has to be checked.
void ImportDialog::showColumns() {
  const tables::TableMapping mapping =
      model_.report() ? model_.report()->mapping : tables::TableMapping();
  const int to_check = ColumnTable::toCheck(mapping);
  tabs_->setTabVisible(1, !mapping.columns.empty());
  tabs_->setTabText(1,
                    to_check == 0 ? tr("Columns") : tr("Columns (%n to check)", nullptr, to_check));
  if (mapping.columns.empty() || shown_ == model_.source()) return;
  shown_ = model_.source();
  tabs_->setCurrentIndex(to_check > 0 ? 1 : 0);
}

void ImportDialog::refresh() {
  using State = ImportModel::State;
  const State state = model_.state();
  const bool works = state == State::Looking || state == State::Entering;
  source_->setText(model_.source().isEmpty()
                       ? tr("A table of sherds has a column with their numbers; one of contexts "
                            "has a column with theirs. Their names may be in any of the "
                            "program's languages.")
                       : model_.source() + kindOf(model_));
  {
    const QSignalBlocker quiet(places_);
    places_->setChecked(model_.makesPlaces());
  }
  places_->setEnabled(!works && state != State::Done);
  choose_table_->setEnabled(state != State::Entering);
  choose_export_->setEnabled(state != State::Entering);
  merge_->setEnabled(state != State::Entering);
  places_->setVisible(!model_.isOfContexts());  // such a table is there to make them
  summary_->setText(state == State::Looking ? tr("Reading…")
                    : state == State::Done  ? tr("Imported: %1").arg(model_.summary())
                                            : model_.summary());
  QStringList words = model_.warnings();
  if (!model_.problem().isEmpty()) words.prepend(model_.problem());
  problem_->setText(words.join('\n'));
  problem_->setVisible(!words.isEmpty());
  const void* rows = model_.rows().empty() ? nullptr : model_.rows().data();
  if (rows != filled_ || rows == nullptr) {
    fill();
    columns_->fill();
  }
  filled_ = rows;
  showColumns();
  {
    const QSignalBlocker quiet(table_);
    for (int r = 0; r < table_->rowCount(); ++r) {
      QTableWidgetItem* fate = table_->item(r, 1);
      if (!fate->flags().testFlag(Qt::ItemIsUserCheckable)) continue;
      const bool taken = model_.isConfirmed(table_->item(r, 0)->text().toInt());
      fate->setCheckState(taken ? Qt::Checked : Qt::Unchecked);
    }
  }
  bar_->setVisible(works);
  bar_->setValue(qRound(1000 * model_.fraction()));
  refusals_->setVisible(model_.report() && model_.report()->refused + model_.report()->asked > 0);
  const int asked = model_.report() ? model_.report()->asked : 0;
  confirm_->setVisible(model_.asks());
  confirm_->setText(tr("Confirm %n row(s)", nullptr, asked));
  cancel_->setText(state == State::Done ? tr("Close") : works ? tr("Stop") : tr("Cancel"));
  const int count = model_.entering();
  enter_->setText(count == 0 && model_.canEnter() ? tr("Keep the other versions")
                                                  : tr("Import %n row(s)", nullptr, count));
  enter_->setEnabled(model_.canEnter());
  enter_->setVisible(state != State::Done || model_.canEnter());
}

}  // namespace ostraka::ui
