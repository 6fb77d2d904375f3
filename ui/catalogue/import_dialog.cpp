#include "ui/catalogue/import_dialog.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include "ui/frame/look.h"

namespace ostraka::ui {
namespace {

QString wordOf(exchange::RowFate fate) {
  switch (fate) {
    case exchange::RowFate::Fresh:
      return ImportDialog::tr("new");
    case exchange::RowFate::Changed:
      return ImportDialog::tr("changed");
    case exchange::RowFate::Refused:
      return ImportDialog::tr("refused");
    case exchange::RowFate::Same:
      break;
  }
  return ImportDialog::tr("as it is");
}

QIcon iconOf(exchange::RowFate fate) {
  switch (fate) {
    case exchange::RowFate::Fresh:
      return icon("plus");
    case exchange::RowFate::Changed:
      return icon("edit");
    case exchange::RowFate::Refused:
      return icon("error");
    case exchange::RowFate::Same:
      break;
  }
  return icon("check");
}

}  // namespace

ImportDialog::ImportDialog(ImportModel& model, QWidget* parent) : QDialog(parent), model_(model) {
  setObjectName("importDialog");
  setWindowTitle(tr("Import into the catalogue"));
  buildLayout();
  connect(&model_, &ImportModel::changed, this, &ImportDialog::refresh);
  connect(this, &QDialog::rejected, &model_, &ImportModel::cancel);
  resize(fontMetrics().averageCharWidth() * 110, fontMetrics().height() * 32);
  refresh();
}

void ImportDialog::buildLayout() {
  const auto button = [this](const char* name, const char* picture, const QString& text) {
    auto* made = new QPushButton(icon(picture), text, this);
    made->setObjectName(name);
    made->setMinimumHeight(targetSize(*this));
    made->setAutoDefault(false);
    return made;
  };
  choose_table_ = button("importTable", "table", tr("A table (CSV) …"));
  choose_export_ = button("importExport", "folder", tr("An export folder …"));
  connect(choose_table_, &QPushButton::clicked, this, &ImportDialog::chooseTable);
  connect(choose_export_, &QPushButton::clicked, this, &ImportDialog::chooseExport);
  source_ = new QLabel(this);
  source_->setObjectName("importSource");
  source_->setWordWrap(true);
  places_ =
      new QCheckBox(tr("Make sites, trenches, contexts and bags that are not there yet"), this);
  places_->setObjectName("importPlaces");
  places_->setMinimumHeight(targetSize(*this) * 3 / 4);
  connect(places_, &QCheckBox::toggled, &model_, &ImportModel::setMakesPlaces);
  summary_ = new QLabel(this);
  summary_->setObjectName("importSummary");
  summary_->setFont(scaledFont(*this, 1.3));
  problem_ = new QLabel(this);
  problem_->setObjectName("importProblem");
  problem_->setWordWrap(true);
  table_ = new QTableWidget(this);
  table_->setObjectName("importRows");
  table_->setAccessibleName(tr("What each row would do"));
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setTabKeyNavigation(false);
  table_->verticalHeader()->hide();
  bar_ = new QProgressBar(this);
  bar_->setRange(0, 1000);
  bar_->setAccessibleName(tr("Progress of the import"));
  refusals_ = button("importRefusals", "export", tr("Save what is refused …"));
  connect(refusals_, &QPushButton::clicked, this, &ImportDialog::saveRefusals);
  cancel_ = button("importCancel", "cancel", {});
  connect(cancel_, &QPushButton::clicked, this, &ImportDialog::leave);
  enter_ = button("importEnter", "check", {});
  enter_->setDefault(true);
  connect(enter_, &QPushButton::clicked, &model_, &ImportModel::enter);
  auto* first = new QHBoxLayout;
  first->addWidget(choose_table_);
  first->addWidget(choose_export_);
  first->addWidget(source_, 1);
  auto* last = new QHBoxLayout;
  last->addWidget(refusals_);
  last->addStretch();
  last->addWidget(cancel_);
  last->addWidget(enter_);
  auto* column = new QVBoxLayout(this);
  column->addLayout(first);
  column->addWidget(places_);
  column->addWidget(summary_);
  column->addWidget(problem_);
  column->addWidget(table_, 1);
  column->addWidget(bar_);
  column->addLayout(last);
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
  const QString file = QFileDialog::getSaveFileName(this, tr("Save what is refused"),
                                                    tr("refused.csv"), tr("Tables (*.csv)"));
  if (file.isEmpty()) return;
  const QString why = model_.saveRefusals(file);
  problem_->setText(why.isEmpty() ? tr("Saved: %1").arg(file) : why);
  problem_->show();
}

void ImportDialog::fill() {
  const std::vector<ImportModel::Row>& rows = model_.rows();
  const QStringList head =
      QStringList{tr("line"), tr("what happens"), tr("why not")} + model_.columns();
  table_->setColumnCount(static_cast<int>(head.size()));
  table_->setHorizontalHeaderLabels(head);
  table_->setRowCount(static_cast<int>(rows.size()));
  for (int r = 0; r < table_->rowCount(); ++r) {
    const ImportModel::Row& row = rows[static_cast<std::size_t>(r)];
    auto* line = new QTableWidgetItem(QString::number(row.line));
    line->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    table_->setItem(r, 0, line);
    table_->setItem(r, 1, new QTableWidgetItem(iconOf(row.fate), wordOf(row.fate)));
    auto* why = new QTableWidgetItem(row.refusal);
    why->setToolTip(row.refusal);
    table_->setItem(r, 2, why);
    for (int c = 0; c < row.values.size() && c + 3 < table_->columnCount(); ++c)
      table_->setItem(r, c + 3, new QTableWidgetItem(row.values[c]));
  }
  // First: a hidden column has no width to keep.
  const bool refused = model_.report() && model_.report()->refused > 0;
  table_->setColumnHidden(2, !refused);
  table_->resizeColumnsToContents();
  const int most = fontMetrics().averageCharWidth() * 60;
  for (int c = 0; c < table_->columnCount(); ++c)
    table_->setColumnWidth(c, std::min(table_->columnWidth(c), most));
}

void ImportDialog::refresh() {
  using State = ImportModel::State;
  const State state = model_.state();
  const bool works = state == State::Looking || state == State::Entering;
  source_->setText(model_.source().isEmpty()
                       ? tr("A table of sherds has a column number or uuid; one of contexts has "
                            "site, context and, if you like, trench and bag.")
                       : model_.source());
  {
    const QSignalBlocker quiet(places_);
    places_->setChecked(model_.makesPlaces());
  }
  places_->setEnabled(!works && state != State::Done);
  choose_table_->setEnabled(state != State::Entering);
  choose_export_->setEnabled(state != State::Entering);
  places_->setVisible(!model_.isOfContexts());  // such a table is there to make them
  summary_->setText(state == State::Looking ? tr("Looking at it …")
                    : state == State::Done  ? tr("Entered: %1").arg(model_.summary())
                                            : model_.summary());
  QStringList words = model_.warnings();
  if (!model_.problem().isEmpty()) words.prepend(model_.problem());
  problem_->setText(words.join('\n'));
  problem_->setVisible(!words.isEmpty());
  const void* rows = model_.rows().empty() ? nullptr : model_.rows().data();
  if (rows != filled_ || rows == nullptr) fill();
  filled_ = rows;
  bar_->setVisible(works);
  bar_->setValue(qRound(1000 * model_.fraction()));
  refusals_->setVisible(model_.report() && model_.report()->refused > 0);
  cancel_->setText(state == State::Done ? tr("Close") : works ? tr("Stop") : tr("Take nothing"));
  const int count = model_.report() ? model_.report()->fresh + model_.report()->changed : 0;
  enter_->setText(count == 0 && model_.canEnter() ? tr("Keep the other versions")
                                                  : tr("Enter %n row(s)", nullptr, count));
  enter_->setEnabled(model_.canEnter());
  enter_->setVisible(state != State::Done);
}

}  // namespace ostraka::ui
