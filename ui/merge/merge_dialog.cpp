#include "ui/merge/merge_dialog.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
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
  renumber_ = addPageAct(this, "mergeNumber", "label", tr("New number"), Qt::Key_3, this, [this] {
    settle(offered(merge::Take::One) ? merge::Take::One : merge::Take::Number);
  });
  undo_ = addPageAct(this, "mergeUndo", "undo", tr("Undo"), QKeySequence::Undo, &model_,
                     &MergeModel::undo);
  auto* label = new QLabel(tr("New number:"), settling_);
  new_number_ = named<QLineEdit>(
      {"mergeNewNumber", tr("New number of the record that does not keep it")}, settling_);
  new_number_->setMinimumWidth(fontMetrics().averageCharWidth() * 24);
  label->setBuddy(new_number_);
  keep_ = actButton(settling_, this_);
  number_ = actButton(settling_, renumber_);
  rest_ = iconButton(settling_, "mergeRest", "check", tr("All open ones: this project"), &model_,
                     &MergeModel::settleRestForThis);
  auto* first = filled(new QHBoxLayout, {keep_, Part::room(), rest_});
  auto* second = filled(new QHBoxLayout,
                        {actButton(settling_, other_), Part::room(), actButton(settling_, undo_)});
  auto* third = filled(new QHBoxLayout, {number_, Part::room(), label, new_number_});
  filled(bareLayout<QVBoxLayout>(settling_), {first, second, third});
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
  numbers_ = named<QPlainTextEdit>({"mergeNewNumbers", tr("Sherds with a new number")}, this);
  numbers_->setReadOnly(true);
  numbers_->setTabChangesFocus(true);
  copy_ = iconButton(this, "mergeCopy", "table", tr("Copy list"), this,
                     [this] { QApplication::clipboard()->setText(numbers_->toPlainText()); });
  bar_ = new QProgressBar(this);
  bar_->setAccessibleName(tr("Progress of the merge"));
  cancel_ = iconButton(this, "mergeCancel", "cancel", {}, this, &MergeDialog::leave);
  enter_ = new BigButton("mergeEnter", {}, this);
  connect(enter_, &QPushButton::clicked, &model_, &MergeModel::enter);
  auto* first = filled(new QHBoxLayout, {choose_, {source_, 1}});
  auto* last = filled(new QHBoxLayout, {copy_, Part::room(), cancel_, enter_});
  filled(new QVBoxLayout(this), {first,
                                 summary_,
                                 notes_,
                                 {table_, 1},
                                 buildSettling(),
                                 {numbers_, 1},
                                 bar_,
                                 Part::room(),
                                 last});
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

bool MergeDialog::offered(merge::Take take) const {
  const std::vector<int> rows = selected();
  return model_.state() == MergeModel::State::Settling &&
         std::any_of(rows.begin(), rows.end(), [&](int row) {
           return model_.conflicts()[static_cast<std::size_t>(row)].offers(take);
         });
}

const merge::Conflict* MergeDialog::twoSherds() const {
  const std::vector<int> rows = selected();
  if (rows.size() != 1) return nullptr;
  const merge::Conflict& one = model_.conflicts()[static_cast<std::size_t>(rows.front())];
  return one.isOfTwoSherds() ? &one : nullptr;
}

void MergeDialog::settle(merge::Take take) {
  const std::vector<int> rows = selected();
  const std::string number = new_number_->text().trimmed().toStdString();
  if (rows.empty()) return;
  if (take == merge::Take::Number && number.empty()) return new_number_->setFocus();
  // What is proposed is known by the model, for either sherd.
  const bool typed = twoSherds() != nullptr && new_number_->isModified();
  const bool called = take == merge::Take::Number || (typed && take != merge::Take::One);
  model_.settle(rows, {take, called ? number : std::string()});
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

// What the keys do to those selected; of two sherds with one number, to both of them.
void MergeDialog::showChoices() {
  const merge::Conflict* one = twoSherds();
  const std::vector<int> rows = selected();
  const bool sherds = !rows.empty() && std::all_of(rows.begin(), rows.end(), [this](int row) {
    return model_.conflicts()[static_cast<std::size_t>(row)].isOfTwoSherds();
  });
  const auto gets = [&](const std::string& number, const QString& named, const QString& unnamed) {
    return one && !number.empty() ? named.arg(QString::fromStdString(number)) : unnamed;
  };
  this_->setText(
      !sherds
          ? tr("This project")
          : gets(one ? one->new_b : std::string(),
                 tr("Two sherds: this project's keeps the number, the other's gets %1"),
                 tr("Two sherds: this project's keeps the number, the other's gets a new one")));
  other_->setText(
      !sherds
          ? tr("Other project")
          : gets(one ? one->new_a : std::string(),
                 tr("Two sherds: the other's keeps the number, this project's gets %1"),
                 tr("Two sherds: the other's keeps the number, this project's gets a new one")));
  const bool can_be_one = offered(merge::Take::One);
  renumber_->setText(can_be_one ? tr("One sherd: both records become one") : tr("New number"));
  this_->setEnabled(offered(merge::Take::A));
  other_->setEnabled(offered(merge::Take::B));
  renumber_->setEnabled(can_be_one || offered(merge::Take::Number));
  new_number_->setEnabled(one != nullptr || offered(merge::Take::Number));
  new_number_->setText(one ? QString::fromStdString(one->new_b) : QString());
  (one ? keep_ : number_)->setDefault(true);  // Return behind a typed number
}

QString MergeDialog::decisionWords(const merge::Conflict& conflict) const {
  const merge::Choice* choice = model_.choiceOf(conflict);
  const auto number = [](const std::string& text) { return QString::fromStdString(text); };
  if (!choice)
    return conflict.new_b.empty() ? tr("Open")
                                  : tr("Open; new number: %1").arg(number(conflict.new_b));
  if (choice->take == merge::Take::One) return tr("One sherd");
  if (choice->take == merge::Take::Number) return tr("New number %1").arg(number(choice->number));
  const bool a = choice->take == merge::Take::A;
  if (choice->number.empty()) return a ? tr("This project") : tr("Other project");
  return (a ? tr("This project; the other sherd: %1") : tr("Other project; this sherd: %1"))
      .arg(number(choice->number));
}

void MergeDialog::showDecisions() {
  const auto& conflicts = model_.conflicts();
  showChoices();
  undo_->setEnabled(model_.canUndo());
  rest_->setEnabled(model_.state() == MergeModel::State::Settling && model_.unsettled() > 0);
  for (int row = 0; row < table_->rowCount(); ++row) {
    const merge::Conflict& conflict = conflicts[static_cast<std::size_t>(row)];
    const merge::Choice* choice = model_.choiceOf(conflict);
    const auto takes = [&](merge::Take take) { return choice && choice->take == take; };
    table_->item(row, kThis)->setIcon(takes(merge::Take::A) ? icon("check") : QIcon());
    table_->item(row, kOther)->setIcon(takes(merge::Take::B) ? icon("check") : QIcon());
    QTableWidgetItem* decision = table_->item(row, kDecision);
    decision->setIcon(choice ? icon("check") : icon("question"));
    decision->setText(decisionWords(conflict));
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
  const QStringList renumbered = state == State::Done ? model_.newNumbers() : QStringList();
  numbers_->setPlainText(renumbered.join('\n'));
  numbers_->setVisible(!renumbered.isEmpty());
  copy_->setVisible(!renumbered.isEmpty());
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
