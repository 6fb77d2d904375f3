#include "ui/sherds/sherd_table_model.h"

#include <QFont>
#include <QTimer>

#include "records/sherd.h"
#include "sherds/sherds.h"
#include "ui/look/look.h"
#include "ui/sherds/field_words.h"
#include "ui/widgets/thumbnails.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {
namespace {

constexpr QSize kPicture(240, 240);

}  // namespace

SherdTableModel::SherdTableModel(QObject* parent)
    : QAbstractTableModel(parent), fields_{"number",   "context",   "bag",      "part",
                                           "ware",     "length_mm", "width_mm", "thickness_mean_mm",
                                           "weight_g", "state",     "batch"} {}

void SherdTableModel::setCatalogue(const catalogue::Catalogue* catalogue,
                                   const std::filesystem::path& project, JobRunner* jobs) {
  delete pictures_;
  pictures_ = jobs == nullptr ? nullptr : new Thumbnails(*jobs, this);
  if (pictures_ != nullptr) {
    auto* arrived = new QTimer(pictures_);  // those that come together are drawn together
    arrived->setSingleShot(true);
    connect(pictures_, &Thumbnails::ready, arrived, qOverload<>(&QTimer::start));
    connect(arrived, &QTimer::timeout, this, [this] {
      if (rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, 0), {Qt::DecorationRole});
    });
  }
  catalogue_ = catalogue;
  project_ = project;
  filter_ = {};
  understood_ = true;
  readVocabularies();
  reload();
}

void SherdTableModel::readVocabularies() {
  words_ = {};
  if (catalogue_ != nullptr) words_.read(*catalogue_);
  if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

QString SherdTableModel::setFilter(const QString& line) {
  const Result<sherds::Filter> filter = sherds::parseFilter(withFieldNames(line).toStdString());
  understood_ = filter.has_value();
  if (filter) filter_ = *filter;
  reload();
  return filter ? QString() : sentenceOf(filter.error());
}

void SherdTableModel::reload() {
  std::vector<store::SherdRow> rows;
  if (catalogue_ && understood_) {
    Result<std::vector<store::SherdRow>> found = sherds::Sherds(*catalogue_).rows(filter_, order_);
    if (!found) {
      emit failed(sentenceOf(found.error()));
      return;
    }
    rows = std::move(*found);
  }
  beginResetModel();
  rows_ = std::move(rows);
  row_of_.clear();
  pages_.clear();
  endResetModel();
}

void SherdTableModel::refresh(const std::vector<store::SherdRow>& sherds) {
  if (sherds.size() > static_cast<std::size_t>(kPage) && !rows_.empty()) {
    pages_.clear();
    emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    return;
  }
  int first = static_cast<int>(rows_.size()), last = -1;
  for (const store::SherdRow& sherd : sherds) {
    const int row = rowOf(sherd);
    if (row < 0) continue;
    pages_.remove(row / kPage);
    first = std::min(first, row);
    last = std::max(last, row);
  }
  if (last >= 0) emit dataChanged(index(first, 0), index(last, columnCount() - 1));
}

store::SherdRow SherdTableModel::sherdAt(int row) const {
  return row >= 0 && row < static_cast<int>(rows_.size()) ? rows_[static_cast<std::size_t>(row)]
                                                          : store::SherdRow{};
}

int SherdTableModel::rowOf(store::SherdRow sherd) const {
  if (row_of_.isEmpty())
    for (std::size_t i = 0; i < rows_.size(); ++i)
      row_of_.insert(rows_[i].value, static_cast<int>(i));
  return row_of_.value(sherd.value, -1);
}

int SherdTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int SherdTableModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(fields_.size());
}

const records::SherdRecord* SherdTableModel::record(int row) const {
  const int page = row / kPage;
  if (!pages_.contains(page)) {
    const auto begin = static_cast<std::size_t>(page * kPage);
    const std::size_t count = std::min<std::size_t>(kPage, rows_.size() - begin);
    Result<std::vector<records::SherdRecord>> read =
        sherds::Sherds(*catalogue_).of(std::span(rows_).subspan(begin, count));
    ++pages_read_;
    if (!read) return nullptr;
    pages_.insert(page, new std::vector<records::SherdRecord>(std::move(*read)));
  }
  return &(*pages_.object(page))[static_cast<std::size_t>(row % kPage)];
}

QIcon SherdTableModel::picture(const records::SherdRecord& sherd) const {
  QPixmap picture;
  if (pictures_ != nullptr && !sherd.preview_path.empty())
    picture =
        pictures_->get(QString::fromStdString((project_ / sherd.preview_path).string()), kPicture);
  if (picture.isNull()) return icon("sherd");
  QIcon shown(picture);
  shown.addPixmap(picture, QIcon::Selected);  // clay keeps its colour in a chosen row
  return shown;
}

QVariant SherdTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount() || !catalogue_) return {};
  const std::string& field = fields_[static_cast<std::size_t>(index.column())];
  if (role == Qt::TextAlignmentRole)
    return QVariant(Qt::AlignVCenter | (isNumber(field) ? Qt::AlignRight : Qt::AlignLeft));
  if (role != Qt::DisplayRole && role != Qt::DecorationRole && role != Qt::ToolTipRole &&
      role != Qt::AccessibleTextRole && role != Qt::FontRole)
    return {};
  if (role == Qt::DecorationRole && index.column() != 0 && !isNumber(field)) return {};
  const records::SherdRecord* sherd = record(index.row());
  if (!sherd) return {};
  const double* computed = computedBeside(*sherd, field);
  if (role == Qt::DecorationRole && index.column() != 0)
    return computed == nullptr
               ? QVariant()
               : QVariant(icon("measure").pixmap(Look::kIcon, Look::kIcon));  // beside the figure
  if (role == Qt::FontRole) {
    QFont font;
    if (isNumber(field)) return tabularFont(font);
    if (index.column() != 0 || sherd->state == records::SherdState::Numbered) return {};
    font.setItalic(sherd->state == records::SherdState::Draft);
    font.setStrikeOut(sherd->state == records::SherdState::Void);
    return font;
  }
  if (role == Qt::DecorationRole) return picture(*sherd);
  const QString text = fieldText(*sherd, field, words_);
  const bool doubtful = isDoubtful(*sherd, field);
  if (computed != nullptr && role == Qt::ToolTipRole)
    return tr("%1: measured by hand; the computed value is kept beside it.").arg(text);
  if (computed != nullptr && role == Qt::AccessibleTextRole)
    return tr("%1: %2, measured by hand").arg(fieldLabel(field), text);
  if (role == Qt::ToolTipRole && doubtful)
    return tr("%1: the scale of batch %2 is in doubt; its report says why and what to do.")
        .arg(text, QString::fromStdString(sherd->batch_number));
  if (role == Qt::AccessibleTextRole && doubtful)
    return tr("%1: %2, in doubt").arg(fieldLabel(field), text);
  if (role == Qt::AccessibleTextRole)
    return tr("%1: %2").arg(fieldLabel(field), text.isEmpty() ? tr("not recorded") : text);
  if (field == "number") return sherdName(*sherd);
  return text;
}

QVariant SherdTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section >= columnCount()) return {};
  if (role == Qt::DisplayRole) return fieldLabel(fields_[static_cast<std::size_t>(section)]);
  return {};
}

void SherdTableModel::sort(int column, Qt::SortOrder order) {
  if (column < 0 || column >= columnCount()) return;
  order_ = {fields_[static_cast<std::size_t>(column)], order == Qt::DescendingOrder};
  reload();
}

}  // namespace ostraka::ui
