#include "ui/merge/merge_dialog.h"

#include <QAction>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <set>

#include "ui/frame/project_session.h"
#include "ui/look/look.h"
#include "ui/merge/merge_words.h"
#include "ui/widgets/big_button.h"
#include "ui/widgets/page_acts.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/screen_room.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

enum Column { kRecord, kField, kThis, kOther, kDecision, kColumns };

QPushButton* actButton(QWidget* parent, QAction* act) {
  QPushButton* button = iconButton(parent, act->objectName() + QStringLiteral("Button"), {}, {});
  const auto follow = [button, act] {
    button->setIcon(act->icon());
    button->setText(QStringLiteral("%1 (%2)").arg(
        act->text(), act->shortcut().toString(QKeySequence::NativeText)));
    button->setEnabled(act->isEnabled());
  };
  follow();
  QObject::connect(act, &QAction::changed, button, follow);
  QObject::connect(button, &QPushButton::clicked, act, &QAction::trigger);
  return button;
}

}  // namespace

MergeDialog::MergeDialog(MergeModel& model, QWidget* parent) : QDialog(parent), model_(model) {
  setObjectName("mergeDialog");
  setWindowTitle(tr("Merge another project"));
  if (model_.session()) terms_.read(model_.session()->project().catalogue());
  buildLayout();
  connect(&model_, &MergeModel::changed, this, &MergeDialog::refresh);
  connect(this, &QDialog::rejected, &model_, &MergeModel::cancel);
  resize(
      fittedToScreen(*this, {fontMetrics().averageCharWidth() * 120, fontMetrics().height() * 34}));
  refresh();
}

void MergeDialog::buildTable() {
  table_ = named<QTableWidget>({"mergeConflicts", tr("Conflicts")}, 0, kColumns, this);
  table_->setHorizontalHeaderLabels(
      {tr("Record"), tr("Field"), tr("This project"), tr("Other project"), tr("Decision")});
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setTabKeyNavigation(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  for (const int values : {kThis, kOther})
    table_->horizontalHeader()->setSectionResizeMode(values, QHeaderView::Stretch);
  connect(table_, &QTableWidget::itemSelectionChanged, this, &MergeDialog::showDecisions);
  connect(table_, &QTableWidget::cellDoubleClicked, this, [this](int, int column) {
    if (column == kThis) settle(merge::Take::A);
    if (column == kOther) settle(merge::Take::B);
  });
}

QWidget* MergeDialog::buildSettling() {
  settling_ = new QWidget(this);
  this_ = addPageAct(this, "mergeThis", "check", tr("This project"), Qt::Key_1, this,
                     [this] { settle(merge::Take::A); });
  other_ = addPageAct(this, "mergeOther", "import", tr("Other project"), Qt::Key_2, this,
                      [this] { settle(merge::Take::B); });
  renumber_ = addPageAct(this, "mergeNumber", "label", tr("New number"), Qt::Key_3, this,
                         [this] { settle(merge::Take::Number); });
  undo_ = addPageAct(this, "mergeUndo", "undo", tr("Undo"), QKeySequence::Undo, &model_,
                     &MergeModel::undo);
  new_number_ = named<QLineEdit>({"mergeNewNumber", tr("New number of the other project's record")},
                                 settling_);
  new_number_->setMinimumWidth(fontMetrics().averageCharWidth() * 16);
  number_ = actButton(settling_, renumber_);
  number_->setDefault(true);  // Return behind a typed number
  rest_ = iconButton(settling_, "mergeRest", "check", tr("All open ones: this project"), &model_,
                     &MergeModel::settleRestForThis);
  filled(bareLayout<QHBoxLayout>(settling_),
         {actButton(settling_, this_), actButton(settling_, other_), new_number_, number_,
          Part::room(), rest_, actButton(settling_, undo_)});
  return settling_;
}

void MergeDialog::buildLayout() {
  choose_ = iconButton(this, "mergeChoose", "folder", tr("Choose project…"), this,
                       &MergeDialog::chooseFolder);
  source_ = wrappedLabel(this, "mergeSource");
  summary_ = wrappedLabel(this, "mergeSummary");
  summary_->setFont(scaledFont(*this, Look::kSection, true));
  notes_ = wrappedLabel(this, "mergeNotes");
  buildTable();
  bar_ = new QProgressBar(this);
  bar_->setAccessibleName(tr("Progress of the merge"));
  cancel_ = iconButton(this, "mergeCancel", "cancel", {}, this, &MergeDialog::leave);
  enter_ = new BigButton("mergeEnter", {}, this);
  connect(enter_, &QPushButton::clicked, &model_, &MergeModel::enter);
  auto* first = filled(new QHBoxLayout, {choose_, {source_, 1}});
  auto* last = filled(new QHBoxLayout, {Part::room(), cancel_, enter_});
  filled(new QVBoxLayout(this),
         {first, summary_, notes_, {table_, 1}, buildSettling(), bar_, Part::room(), last});
}

void MergeDialog::leave() {
  if (model_.state() == MergeModel::State::Entering) return model_.cancel();
  reject();
}

void MergeDialog::chooseFolder() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder of the other project"));
  if (!folder.isEmpty()) model_.setFolder(folder);
}

std::vector<int> MergeDialog::selected() const {
  std::set<int> rows;
  for (const QTableWidgetItem* item : table_->selectedItems()) rows.insert(item->row());
  return {rows.begin(), rows.end()};
}

void MergeDialog::settle(merge::Take take) {
  const std::vector<int> rows = selected();
  const QString number = new_number_->text().trimmed();
  if (rows.empty()) return;
  if (take == merge::Take::Number && number.isEmpty()) return new_number_->setFocus();
  model_.settle(rows, {take, take == merge::Take::Number ? number.toStdString() : std::string()});
  new_number_->clear();
  selectNext(rows.back());
}

// The next one that is open, from there on and then from the top.
void MergeDialog::selectNext(int after) {
  const int count = static_cast<int>(model_.conflicts().size());
  for (int i = 1; i <= count; ++i) {
    const int row = (after + i) % count;
    if (model_.choiceOf(model_.conflicts()[static_cast<std::size_t>(row)])) continue;
    table_->setCurrentCell(row, kThis);
    return table_->setFocus();
  }
  enter_->setFocus();
}

void MergeDialog::fill() {
  const auto& conflicts = model_.conflicts();
  table_->setRowCount(static_cast<int>(conflicts.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const merge::Conflict& conflict = conflicts[static_cast<std::size_t>(row)];
    const QString words[] = {recordWords(conflict), fieldWords(conflict),
                             versionWords(conflict, conflict.a, terms_),
                             versionWords(conflict, conflict.b, terms_), QString()};
    for (int column = 0; column < kColumns; ++column)
      table_->setItem(row, column, new QTableWidgetItem(words[column]));
  }
  if (!conflicts.empty()) selectNext(-1);
}

void MergeDialog::showDecisions() {
  const auto& conflicts = model_.conflicts();
  const bool settling = model_.state() == MergeModel::State::Settling;
  const auto offered = [&, rows = selected()](merge::Take take) {
    return settling && std::any_of(rows.begin(), rows.end(), [&](int row) {
             return conflicts[static_cast<std::size_t>(row)].offers(take);
           });
  };
  this_->setEnabled(offered(merge::Take::A));
  other_->setEnabled(offered(merge::Take::B));
  renumber_->setEnabled(offered(merge::Take::Number));
  new_number_->setEnabled(renumber_->isEnabled());
  undo_->setEnabled(model_.canUndo());
  rest_->setEnabled(settling && model_.unsettled() > 0);
  for (int row = 0; row < table_->rowCount(); ++row) {
    const merge::Choice* choice = model_.choiceOf(conflicts[static_cast<std::size_t>(row)]);
    const auto takes = [&](merge::Take take) { return choice && choice->take == take; };
    table_->item(row, kThis)->setIcon(takes(merge::Take::A) ? icon("check") : QIcon());
    table_->item(row, kOther)->setIcon(takes(merge::Take::B) ? icon("check") : QIcon());
    QTableWidgetItem* decision = table_->item(row, kDecision);
    decision->setIcon(choice ? icon("check") : icon("question"));
    decision->setText(takes(merge::Take::A)   ? tr("This project")
                      : takes(merge::Take::B) ? tr("Other project")
                      : choice ? tr("New number %1").arg(QString::fromStdString(choice->number))
                               : tr("Open"));
  }
}

void MergeDialog::refresh() {
  using State = MergeModel::State;
  const State state = model_.state();
  source_->setText(model_.folder().isEmpty()
                       ? tr("What the other project holds comes into this one; the other one is "
                            "only read. Nothing changes before you merge.")
                       : model_.folder());
  choose_->setEnabled(state != State::Entering);
  summary_->setText(model_.summary());
  notes_->setText(model_.notes());
  notes_->setVisible(!model_.notes().isEmpty());
  const void* conflicts = model_.conflicts().empty() ? nullptr : model_.conflicts().data();
  const bool other_ones = filled_ != conflicts;
  filled_ = conflicts;
  const bool shown = conflicts && state != State::Done;
  table_->setVisible(shown);
  settling_->setVisible(shown);
  bar_->setVisible(model_.isBusy());
  bar_->setRange(0, model_.fraction() > 0 ? 1000 : 0);  // how long a comparison takes is not known
  bar_->setValue(qRound(1000 * model_.fraction()));
  cancel_->setText(state == State::Done       ? tr("Close")
                   : state == State::Entering ? tr("Stop")
                                              : tr("Cancel"));
  const int unsettled = model_.unsettled();
  enter_->setText(unsettled > 0 ? tr("%n conflict(s) to settle", nullptr, unsettled)
                                : tr("Merge project"));
  enter_->setEnabled(model_.canEnter());
  enter_->setVisible(state != State::Done);
  if (other_ones) fill();
  showDecisions();
}

}  // namespace ostraka::ui
