#include "ui/pairs/card_list_model.h"

#include <algorithm>

namespace ostraka::ui {

CardListModel::CardListModel(const ReviewedBatch& batch, QObject* parent)
    : QAbstractListModel(parent), batch_(batch) {}

int CardListModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant CardListModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount() || !batch_.isOpen()) return {};
  const ReviewRow& row = at(index.row());
  if (role == Qt::DisplayRole) return rowName(row, batch_.table());
  if (role == Qt::ToolTipRole) return batch_.wordsOf(row);
  if (role == Qt::AccessibleTextRole)
    return tr("%1, %2. %3").arg(rowName(row, batch_.table()), rowWord(row), batch_.wordsOf(row));
  return {};
}

QImage CardListModel::picture(batch::Side side, int scan) const {
  const auto found = pictures_.find({side, scan});
  return found == pictures_.end() ? QImage() : found->second;
}

int CardListModel::rowOf(int front) const {
  for (int row = 0; row < rowCount(); ++row)
    if (front >= 0 && at(row).front == front) return row;
  return -1;
}

int CardListModel::rowOfLoneBack(int back) const {
  for (int row = 0; row < rowCount(); ++row)
    if (at(row).isLoneBack() && at(row).back == back) return row;
  return -1;
}

int CardListModel::rowAbout(const Trial& trial) const {
  return trial.front >= 0 ? rowOf(trial.front) : rowOfLoneBack(trial.back);
}

void CardListModel::clear() {
  beginResetModel();
  rows_.clear();
  pictures_.clear();
  endResetModel();
}

void CardListModel::update() {
  std::vector<ReviewRow> rows = batch_.rows();
  if (rows.size() != rows_.size()) {  // a back became somebody's, or nobody's
    beginResetModel();
    rows_ = std::move(rows);
    return endResetModel();
  }
  emit layoutAboutToBeChanged();
  const QModelIndexList before = persistentIndexList();
  QModelIndexList after;
  for (const QModelIndex& i : before) {
    const ReviewRow& was = at(i.row());
    const auto now = std::ranges::find_if(
        rows, [&](const ReviewRow& row) { return row.isAbout(was.front, was.back); });
    after.append(now == rows.end() ? QModelIndex() : index(static_cast<int>(now - rows.begin())));
  }
  rows_ = std::move(rows);
  changePersistentIndexList(before, after);
  emit layoutChanged();
  tellAllChanged();
}

void CardListModel::setPictures(ScanPictures pictures) {
  pictures_ = std::move(pictures);
  tellAllChanged();
}

void CardListModel::setNumbers(const QHash<int, QString>& numbers) {
  if (numbers == numbers_) return;
  emit layoutAboutToBeChanged();  // a card with a number is higher
  numbers_ = numbers;
  emit layoutChanged();
}

void CardListModel::tellAllChanged() {
  if (rowCount() > 0) emit dataChanged(index(0), index(rowCount() - 1));
}

}  // namespace ostraka::ui
