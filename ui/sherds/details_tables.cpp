// What is only read in the details of a sherd: its measurements, history and files.
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "catalogue/files.h"
#include "catalogue/history.h"
#include "catalogue/places.h"
#include "sherds/measurements.h"
#include "store/values.h"
#include "ui/look/look.h"
#include "ui/sherds/field_words.h"
#include "ui/sherds/sherd_details.h"

namespace ostraka::ui {
namespace {

constexpr int kMostRows = 12;
constexpr int kLeastLetters = 8;  // in a line of the last column

// What the column has no room for goes on in the next line.
class WholeText final : public QStyledItemDelegate {
 public:
  explicit WholeText(QTreeWidget& tree) : QStyledItemDelegate(&tree), tree_(tree) {}
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QStyleOptionViewItem in_column = option;
    in_column.rect = {0, 0, tree_.columnWidth(index.column()), 1};
    return QStyledItemDelegate::sizeHint(in_column, index);
  }

 private:
  const QTreeWidget& tree_;
};

// As high as its rows, so that only the page scrolls.
void fitHeight(QTreeWidget* tree) {
  int high = tree->header()->sizeHint().height() + 2 * tree->frameWidth() + 2;
  for (int row = 0; row < std::min(tree->topLevelItemCount(), kMostRows); ++row)
    high += tree->sizeHintForRow(row);
  if (tree->header()->length() > tree->viewport()->width())
    high += tree->horizontalScrollBar()->sizeHint().height();
  tree->setFixedHeight(high);
}

QTreeWidget* table(const QStringList& columns, const QString& name, QWidget* parent) {
  auto* tree = new QTreeWidget(parent);
  tree->setHeaderLabels(columns);
  tree->setRootIsDecorated(false);
  tree->setAccessibleName(name);
  tree->setSelectionMode(QAbstractItemView::NoSelection);
  tree->setWordWrap(true);
  tree->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  const int last = static_cast<int>(columns.size()) - 1;
  tree->header()->setSectionResizeMode(last, QHeaderView::Stretch);
  tree->header()->setMinimumSectionSize(tree->fontMetrics().averageCharWidth() * kLeastLetters);
  tree->setItemDelegateForColumn(last, new WholeText(*tree));
  QObject::connect(tree->header(), &QHeaderView::sectionResized, tree, [tree, last](int column) {
    if (column != last) return;
    tree->doItemsLayout();
    fitHeight(tree);
  });
  return tree;
}

QString fileKind(const std::string& role) {
  if (role == "photo") return SherdDetails::tr("photograph");
  if (role == "mask") return SherdDetails::tr("mask");
  if (role == "scan") return SherdDetails::tr("scan");
  if (role == "model") return SherdDetails::tr("model");
  if (role == "preview") return SherdDetails::tr("picture");
  if (role == "drawing") return SherdDetails::tr("drawing");
  if (role == "report") return SherdDetails::tr("report");
  if (role == "scale") return SherdDetails::tr("scale");
  return QString::fromStdString(role);
}

QString fileState(records::FileState state) {
  return state == records::FileState::Missing   ? SherdDetails::tr("missing")
         : state == records::FileState::Changed ? SherdDetails::tr("changed")
                                                : SherdDetails::tr("present");
}

}  // namespace

void SherdDetails::addTables(QVBoxLayout& column) {
  QWidget* page = column.parentWidget();
  measures_ = table({tr("measure"), tr("value"), tr("from")}, tr("Measurements"), page);
  history_ = table({tr("when"), tr("who"), tr("what")}, tr("History"), page);
  files_ = table({tr("file"), tr("kind"), tr("state")}, tr("Files"), page);
  const auto add = [&](const QString& text, QTreeWidget* shown) {
    auto* label = new QLabel(text, page);
    label->setFont(scaledFont(*this, Look::kSection, true));
    column.addWidget(label);
    column.addWidget(shown);
  };
  add(tr("Measured"), measures_);
  add(tr("History"), history_);
  add(tr("Files"), files_);
}

void SherdDetails::showTables(const catalogue::Catalogue& catalogue,
                              const std::filesystem::path& project,
                              const records::SherdRecord& sherd) {
  showMeasures(catalogue, sherd);
  showHistory(catalogue);
  showFiles(catalogue, project);
}

void SherdDetails::clearTables() {
  for (QTreeWidget* tree : {measures_, history_, files_}) {
    tree->clear();
    fitHeight(tree);
  }
}

void SherdDetails::showMeasures(const catalogue::Catalogue& catalogue,
                                const records::SherdRecord& sherd) {
  measures_->clear();
  const auto add = [this](const QString& kind, const QString& value, const QString& from) {
    auto* item = new QTreeWidgetItem(measures_, {kind, value, from});
    item->setFont(1, tabularFont(font()));
    item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    return item;
  };
  if (const auto all = sherds::Measurements(catalogue).of(sherd_))
    for (const records::Measurement& m : *all) {
      const auto computed = sherd.replaced.find(m.kind);
      auto* item =
          add(measureLabel(m.kind), measuredText(m),
              sherd.doubtful.contains(m.kind) ? tr("%1; in doubt").arg(methodLabel(m.method))
                                              : methodLabel(m.method));
      if (computed == sherd.replaced.end()) continue;
      item->setIcon(0, icon("measure"));
      add({}, measureText(computed->second, m.unit),
          tr("computed; replaced by the measured value"));
    }
  fitHeight(measures_);
}

void SherdDetails::showHistory(const catalogue::Catalogue& catalogue) {
  history_->clear();
  QHash<qint64, QString> people;
  if (const auto persons = catalogue::People(catalogue).all())
    for (const records::PersonRecord& person : *persons)
      people.insert(person.row.value, QString::fromStdString(person.initials));
  if (const auto all = catalogue::History(catalogue).of(sherd_))
    for (const records::HistoryEntry& entry : *all) {
      const std::string unit = records::unitOf(entry.field);
      const auto shown = [&](const std::string& value) {
        const Result<double> number = store::parsedNumber(value);
        return number && !unit.empty() ? enteredText(*number, unit)
                                       : words_.shown(entry.field, value);
      };
      const QString old_value = shown(entry.old_value), new_value = shown(entry.new_value);
      const QString label = measureLabel(entry.field);
      const QString what =
          entry.field.empty() ? tr("added")
          : old_value.isEmpty()
              ? tr("%1: %2").arg(label, new_value)
              : tr("%1: %2 → %3")
                    .arg(label, old_value, new_value.isEmpty() ? tr("nothing") : new_value);
      auto* item = new QTreeWidgetItem(
          history_, {when(entry.at_ms), people.value(entry.by.value, tr("program")), what});
      // The reason, or the file of an import.
      const QString why = QString::fromStdString(entry.why);
      item->setToolTip(2, why);
    }
  fitHeight(history_);
}

void SherdDetails::showFiles(const catalogue::Catalogue& catalogue,
                             const std::filesystem::path& project) {
  files_->clear();
  if (const auto all = catalogue::Files(catalogue).of(sherd_))
    for (const records::FileRecord& file : *all) {
      std::error_code code;
      const bool there = std::filesystem::exists(project / file.path, code);
      auto* item = new QTreeWidgetItem(
          files_,
          {QString::fromStdString(std::filesystem::path(file.path).filename().string()),
           fileKind(file.role), fileState(there ? file.state : records::FileState::Missing)});
      item->setToolTip(0, QString::fromStdString(file.path));
    }
  fitHeight(files_);
}

}  // namespace ostraka::ui
