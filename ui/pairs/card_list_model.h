#pragma once
#include <QAbstractListModel>
#include <QHash>
#include <QString>
#include <vector>

#include "ui/pairs/review_rows.h"
#include "ui/pairs/reviewed_batch.h"

namespace ostraka::ui {

/// The cards of the batch under review as rows of a list.
class CardListModel final : public QAbstractListModel {
  Q_OBJECT

 public:
  explicit CardListModel(const ReviewedBatch& batch, QObject* parent = nullptr);  ///< outlives it

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

  const ReviewRow& at(int row) const { return rows_.at(static_cast<std::size_t>(row)); }
  QImage picture(batch::Side side, int scan) const;                  ///< in small; null: none yet
  QString number(int front) const { return numbers_.value(front); }  ///< in the catalogue, or empty
  int rowOf(int front) const;                                        ///< -1: none
  int rowOfLoneBack(int back) const;                                 ///< -1: a front holds it
  int rowAbout(const Trial& trial) const;

  void clear();   ///< before the batch becomes another one
  void update();  ///< after a decision; what is selected follows its row
  void setPictures(ScanPictures pictures);
  void setNumbers(const QHash<int, QString>& numbers);  ///< of the sherds, by front

 private:
  void tellAllChanged();

  const ReviewedBatch& batch_;
  std::vector<ReviewRow> rows_;
  QHash<int, QString> numbers_;
  ScanPictures pictures_;
};

}  // namespace ostraka::ui
