#include "ui/tables/column_table.h"

#include <QComboBox>
#include <QHeaderView>
#include <algorithm>

#include "tables/column_names.h"
#include "ui/look/look.h"
#include "ui/sherds/field_words.h"
#include "ui/widgets/parts.h"

namespace ostraka::ui {
namespace {

QString customField(const tables::ColumnChoice& choice) {
  return QStringLiteral("extra.") +
         QString::fromStdString(choice.isOwn() ? choice.field.substr(6) : choice.column);
}

QString whyOf(const tables::ColumnChoice& choice) {
  if (choice.field.empty() && choice.by != tables::ChosenBy::Person)
    return ColumnTable::tr("says nothing about the sherd");
  if (choice.isOnlyShown()) return ColumnTable::tr("only shown, never read");
  if (choice.unit_guessed) return ColumnTable::tr("unit guessed from the values; check it");
  switch (choice.by) {
    case tables::ChosenBy::Name:
      return ColumnTable::tr("proposed by its heading");
    case tables::ChosenBy::Earlier:
      return ColumnTable::tr("as in the last table with these columns");
    case tables::ChosenBy::Person:
      return ColumnTable::tr("chosen by you");
    case tables::ChosenBy::Nobody:
      break;
  }
  return ColumnTable::tr("no field of this name; kept as a custom field");
}

bool wantsACheck(const tables::ColumnChoice& choice) {
  return choice.unit_guessed || choice.by == tables::ChosenBy::Nobody;
}

}  // namespace

ColumnTable::ColumnTable(ImportModel& model, QWidget* parent)
    : QTableWidget(0, 5, parent), model_(model) {
  setObjectName("importColumns");
  setAccessibleName(tr("Columns of the table"));
  setHorizontalHeaderLabels({tr("column"), tr("field"), tr("unit"), tr("first values"), tr("why")});
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setSelectionMode(QAbstractItemView::NoSelection);
  setTabKeyNavigation(false);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(targetSize(*this) * 3 / 4);
  horizontalHeader()->setStretchLastSection(true);
}

int ColumnTable::toCheck(const tables::TableMapping& mapping) {
  return static_cast<int>(
      std::count_if(mapping.columns.begin(), mapping.columns.end(), wantsACheck));
}

void ColumnTable::fill() {
  setRowCount(0);
  if (!model_.report()) return;
  const tables::TableMapping& mapping = model_.report()->mapping;
  setRowCount(static_cast<int>(mapping.columns.size()));
  for (int row = 0; row < rowCount(); ++row) {
    const tables::ColumnChoice& choice = mapping.columns[static_cast<std::size_t>(row)];
    QStringList samples;
    for (const std::string& sample : choice.samples)
      samples << QString::fromStdString(sample).left(24);
    setItem(row, 0, new QTableWidgetItem(QString::fromStdString(choice.column)));
    setCellWidget(row, 1, fieldBox(row, choice, mapping.of_contexts));
    if (tables::unitsOf(choice.field).size() > 1) setCellWidget(row, 2, unitBox(row, choice));
    setItem(row, 3, new QTableWidgetItem(samples.join(QStringLiteral("; "))));
    auto* why = new QTableWidgetItem(whyOf(choice));
    if (wantsACheck(choice)) why->setIcon(icon("warning"));
    setItem(row, 4, why);
  }
  resizeColumnsToContents();
}

QWidget* ColumnTable::fieldBox(int row, const tables::ColumnChoice& choice, bool of_contexts) {
  auto* box =
      named<QComboBox>({QStringLiteral("columnField%1").arg(row),
                        tr("Field of the column %1").arg(QString::fromStdString(choice.column))},
                       this);
  box->addItem(tr("skip"), QString());
  box->addItem(tr("custom field: %1").arg(customField(choice).mid(6)), customField(choice));
  std::vector<std::string> fields = tables::fieldsOfTables(of_contexts);
  if (of_contexts) fields.insert(fields.begin(), "number");  // then it is a table of sherds
  for (const std::string& field : fields)
    box->addItem(fieldLabel(field), QString::fromStdString(field));
  if (box->findData(QString::fromStdString(choice.field)) < 0)
    box->addItem(QString::fromStdString(choice.field), QString::fromStdString(choice.field));
  box->setCurrentIndex(box->findData(QString::fromStdString(choice.field)));
  connect(box, &QComboBox::activated, &model_,
          [this, row, box](int at) { model_.setColumn(row, box->itemData(at).toString(), {}); });
  return box;
}

QWidget* ColumnTable::unitBox(int row, const tables::ColumnChoice& choice) {
  auto* box =
      named<QComboBox>({QStringLiteral("columnUnit%1").arg(row),
                        tr("Unit of the column %1").arg(QString::fromStdString(choice.column))},
                       this);
  for (const std::string& unit : tables::unitsOf(choice.field))
    box->addItem(unit == "share" ? tr("share of 1") : QString::fromStdString(unit),
                 QString::fromStdString(unit));
  box->setCurrentIndex(box->findData(QString::fromStdString(choice.unit)));
  connect(box, &QComboBox::activated, &model_,
          [this, row, box, field = QString::fromStdString(choice.field)](int at) {
            model_.setColumn(row, field, box->itemData(at).toString());
          });
  return box;
}

}  // namespace ostraka::ui
