#include "ui/catalogue/compare_window.h"

#include <QAction>
#include <QCheckBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSplitter>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "records/sherd_comparison.h"
#include "sherds/measurements.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "ui/catalogue/model_pane.h"
#include "ui/frame/project_session.h"
#include "ui/look/look.h"
#include "ui/sherds/field_words.h"
#include "ui/viewport/linked_views.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/page_acts.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/screen_room.h"
#include "ui/widgets/tool_row.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

using records::Agreement;

enum Column { kField, kFirst, kSecond, kDifference, kColumns };

/// A row of the table.
struct Compared {
  QString label;
  std::array<QString, 2> values;
  Agreement agreement = Agreement::Same;
  QString difference;
};

QString agreementWords(Agreement agreement) {
  switch (agreement) {
    case Agreement::OneBlank:
      return CompareWindow::tr("only one entered");
    case Agreement::Differs:
      return CompareWindow::tr("differs");
    case Agreement::WithinUncertainty:
    case Agreement::Same:
      break;
  }
  return {};
}

QString differenceWords(Agreement agreement, double difference, const std::string& unit) {
  if (agreement == Agreement::Same) return {};
  const QString by =
      (difference > 0 ? QStringLiteral("+") : QString()) + measureText(difference, unit);
  return agreement == Agreement::Differs ? CompareWindow::tr("differs: %1").arg(by)
                                         : CompareWindow::tr("%1, within the uncertainty").arg(by);
}

// Of the field's kind; null: nobody measured it.
const records::Measurement* measured(const std::vector<records::Measurement>& all,
                                     const std::string& field) {
  for (const records::Measurement& m : all)
    if (field == m.kind || field == m.kind + "_" + m.unit) return &m;
  return nullptr;
}

Compared comparedMeasure(const std::array<records::SherdRecord, 2>& sherds,
                         const std::array<std::vector<records::Measurement>, 2>& measurements,
                         const std::string& field) {
  std::array<const records::Measurement*, 2> found{};
  Compared row;
  for (std::size_t i = 0; i < 2; ++i) {
    found[i] = measured(measurements[i], field);
    if (found[i] == nullptr) continue;
    row.values[i] = measuredText(*found[i]);
    if (isDoubtful(sherds[i], field)) row.values[i] = CompareWindow::tr("%1 ?").arg(row.values[i]);
  }
  if (found[0] != nullptr && found[1] != nullptr) {
    row.agreement = compareMeasurements(*found[0], *found[1]);
    row.difference =
        differenceWords(row.agreement, found[1]->value - found[0]->value, found[0]->unit);
  } else if (found[0] != nullptr || found[1] != nullptr) {
    row.agreement = Agreement::OneBlank;
    row.difference = agreementWords(row.agreement);
  }
  return row;
}

Compared comparedText(const std::array<records::SherdRecord, 2>& sherds, const std::string& field,
                      records::FieldKind kind, const TermWords& words) {
  Compared row;
  for (std::size_t i = 0; i < 2; ++i) row.values[i] = fieldText(sherds[i], field, words);
  row.agreement =
      compareTexts(kind, sherds::textOf(sherds[0], field), sherds::textOf(sherds[1], field));
  row.difference = agreementWords(row.agreement);
  return row;
}

// All that is known of one of them at least, but for what is each sherd's own.
std::vector<Compared> compared(const catalogue::Catalogue& catalogue,
                               std::array<records::SherdRecord, 2> sherds, const TermWords& words) {
  std::array<std::vector<records::Measurement>, 2> measurements;
  for (std::size_t i = 0; i < 2; ++i) {
    if (const auto all = sherds::Measurements(catalogue).of(sherds[i].row)) measurements[i] = *all;
    // That they join each other is said above the table.
    std::erase(sherds[i].join_numbers,
               sherds[1 - i].number.empty() ? sherds[1 - i].id : sherds[1 - i].number);
  }
  std::vector<Compared> rows;
  const auto add = [&](const std::string& field, Compared row) {
    row.label = fieldLabel(field);
    if (!row.values[0].isEmpty() || !row.values[1].isEmpty()) rows.push_back(std::move(row));
  };
  for (const records::SherdField& field : sherds::sherdFields()) {
    const std::string name = field.name;
    if (name == "number" || name == "uuid") continue;
    add(name, field.kind == records::FieldKind::Number
                  ? comparedMeasure(sherds, measurements, name)
                  : comparedText(sherds, name, field.kind, words));
  }
  if (const auto custom = sherds::Sherds(catalogue).customFields())
    for (const std::string& field : *custom)
      add(field, comparedText(sherds, field, records::FieldKind::Text, words));
  return rows;
}

}  // namespace

CompareWindow::CompareWindow(ProjectSession& session, QWidget* parent)
    : QDialog(parent, Qt::Window), session_(session) {
  setObjectName("compare");
  setWindowTitle(tr("Compare sherds"));
  setAttribute(Qt::WA_DeleteOnClose);
  views_ = new LinkedViews(this);
  buildLayout();
  reserveOpenGl(*this);
  for (const auto changed : {&ProjectSession::sherdsChanged, &ProjectSession::othersWrote,
                             &ProjectSession::vocabulariesChanged})
    connect(&session, changed, this, &CompareWindow::refresh);
  connect(&session, &ProjectSession::batchChanged, this, &CompareWindow::refresh);
  resize(
      fittedToScreen(*this, {fontMetrics().averageCharWidth() * 140, fontMetrics().height() * 42}));
}

void CompareWindow::buildLayout() {
  QSplitter* split =
      filled(new QSplitter(Qt::Vertical, this), {{buildModels(), 3}, {buildFields(), 2}});
  split->setChildrenCollapsible(false);
  filled(pageColumn(this), {{split, 1}});
}

// The panes lie in one row of a grid: of one height, they have one scale.
QWidget* CompareWindow::buildModels() {
  auto* models = new QWidget(this);
  auto* grid = bareLayout<QGridLayout>(models);
  grid->setRowStretch(2, 1);
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    Side& side = sides_[i];
    const int column = static_cast<int>(i);
    side.name = named<ElidedLabel>(i == 0 ? "firstName" : "secondName", models);
    side.name->setFont(scaledFont(*this, Look::kSection, true));
    side.why_no_model = wrappedLabel(models, i == 0 ? "firstWhy" : "secondWhy");
    side.model = new ModelPane(models);
    side.model->setObjectName(i == 0 ? "firstModel" : "secondModel");
    side.model->hideActs();
    connect(side.model, &ModelPane::settled, this, [this, i] { settle(i); });
    grid->setColumnStretch(column, 1);
    grid->addWidget(side.name, 0, column);
    grid->addWidget(side.why_no_model, 1, column);
    grid->addWidget(side.model, 2, column);
  }
  return models;
}

QWidget* CompareWindow::buildFields() {
  auto* below = new QWidget(this);
  together_ = named<QCheckBox>("turnTogether", tr("Turn &together"), below);
  together_->setToolTip(
      tr("Off: each sherd is turned alone, until both lie alike. The scale stays the same."));
  together_->setChecked(true);
  connect(together_, &QCheckBox::toggled, views_, &LinkedViews::setTogether);
  section_ = addPageAct(this, "compareSection", "section", tr("Section"), Qt::Key_S);
  section_->setCheckable(true);
  connect(section_, &QAction::toggled, views_, &LinkedViews::setSection);
  QAction* reset = addPageAct(this, "compareReset", "again", tr("From above"), Qt::Key_A, views_,
                              &LinkedViews::reset);
  auto* tools = new ToolRow(below);
  tools->addWidget(together_);
  tools->addGroup({}, {section_, reset});
  summary_ = wrappedLabel(below, "compareSummary");
  fields_ = named<QTableWidget>({"comparedFields", tr("Fields and measurements of both sherds")}, 0,
                                kColumns, below);
  fields_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  fields_->setSelectionBehavior(QAbstractItemView::SelectRows);
  fields_->setTabKeyNavigation(false);
  fields_->verticalHeader()->hide();
  fields_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  fields_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  for (const int values : {kFirst, kSecond})
    fields_->horizontalHeader()->setSectionResizeMode(values, QHeaderView::Stretch);
  filled(bareLayout<QVBoxLayout>(below), {tools, summary_, {fields_, 1}});
  return below;
}

void CompareWindow::showSherds(store::SherdRow first, store::SherdRow second) {
  sides_[0].sherd = first;
  sides_[1].sherd = second;
  refresh();
}

void CompareWindow::refresh() {
  const catalogue::Catalogue& catalogue = session_.project().catalogue();
  words_.read(catalogue);
  std::array<records::SherdRecord, 2> sherds;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const auto sherd = sherds::Sherds(catalogue).get(sides_[i].sherd);
    if (!sherd) {  // it is not there any more
      close();
      return;
    }
    sherds[i] = *sherd;
  }
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    sides_[i].name->setText(sherdName(sherds[i]));
    sides_[i].model->setAccessibleName(
        tr("Model of %1; the arrow keys turn it").arg(sherdName(sherds[i])));
    sides_[i].model->showSherd(session_.jobs(), session_.folder(), sherds[i]);
    sayWhyNoModel(i);
  }
  showFields(sherds);
}

// A model that has just come is looked at as the other one is.
void CompareWindow::settle(std::size_t side) {
  sayWhyNoModel(side);
  ModelPane& pane = *sides_[side].model;
  pane.setFocusPolicy(pane.showsModel() ? Qt::StrongFocus : Qt::NoFocus);
  if (!pane.showsModel()) return;
  views_->setView(side, pane.modelView());
  section_->setChecked(false);
  views_->reset();
}

void CompareWindow::sayWhyNoModel(std::size_t side) {
  const QString& why = sides_[side].model->whyNoModel();
  sides_[side].why_no_model->setText(why);
  sides_[side].why_no_model->setVisible(!why.isEmpty());
}

void CompareWindow::showFields(const std::array<records::SherdRecord, 2>& sherds) {
  const std::vector<Compared> rows = compared(session_.project().catalogue(), sherds, words_);
  fields_->setHorizontalHeaderLabels(
      {tr("field"), sherdName(sherds[0]), sherdName(sherds[1]), tr("difference")});
  fields_->setRowCount(static_cast<int>(rows.size()));
  int differing = 0;
  for (int row = 0; row < fields_->rowCount(); ++row) {
    const Compared& shown = rows[static_cast<std::size_t>(row)];
    const bool differs = shown.agreement == Agreement::Differs;
    differing += differs;
    const QString texts[] = {shown.label, shown.values[0], shown.values[1], shown.difference};
    for (int column = 0; column < kColumns; ++column) {
      auto* item = new QTableWidgetItem(texts[column]);
      QFont letters = tabularFont(font());
      letters.setBold(differs);
      item->setFont(letters);
      if (column == kDifference && differs) item->setIcon(icon("distance"));
      fields_->setItem(row, column, item);
    }
  }
  const auto& joins = sherds[0].joins;
  QStringList said{tr("%n field(s) differ.", nullptr, differing)};
  if (std::find(joins.begin(), joins.end(), sherds[1].row) != joins.end())
    said << tr("The two are recorded as joining.");
  summary_->setText(said.join(QLatin1Char(' ')));
}

}  // namespace ostraka::ui
