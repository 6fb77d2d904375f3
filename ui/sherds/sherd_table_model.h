#pragma once
#include <QAbstractTableModel>
#include <QCache>
#include <QHash>
#include <QIcon>
#include <filesystem>
#include <vector>

#include "catalogue/catalogue.h"
#include "records/sherd.h"
#include "sherds/filter.h"
#include "ui/frame/term_words.h"

namespace ostraka::ui {

class JobRunner;
class Thumbnails;

/// The table of the catalogue: rows are ids, records come a page at a time when they are shown,
/// pictures from a worker. 100,000 rows open in far less than a second.
class SherdTableModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  static constexpr int kPage = 128;

  explicit SherdTableModel(QObject* parent = nullptr);

  /// Nothing of the catalogue is kept after setCatalogue(nullptr).
  void setCatalogue(const catalogue::Catalogue* catalogue, const std::filesystem::path& project,
                    JobRunner* jobs);
  /// Empty when it was understood, else the sentence; no rows are shown then.
  QString setFilter(const QString& line);
  const sherds::Filter& filter() const { return filter_; }
  /// Asks the catalogue again.
  void reload();
  void readVocabularies();  ///< words that are shown in the cells
  /// These sherds changed: their cells are drawn anew, the order stays until reload().
  void refresh(const std::vector<store::SherdRow>& rows);

  const std::vector<store::SherdRow>& rows() const { return rows_; }
  store::SherdRow sherdAt(int row) const;
  int rowOf(store::SherdRow sherd) const;
  int pagesRead() const { return pages_read_; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  void sort(int column, Qt::SortOrder order) override;

 signals:
  void failed(const QString& sentence);

 private:
  const records::SherdRecord* record(int row) const;
  QIcon picture(const records::SherdRecord& sherd) const;

  const catalogue::Catalogue* catalogue_ = nullptr;
  std::filesystem::path project_;
  Thumbnails* pictures_ = nullptr;  ///< goes with the project
  TermWords words_;
  sherds::Filter filter_;
  bool understood_ = true;  ///< the latest line
  records::SherdOrder order_;
  std::vector<std::string> fields_;
  std::vector<store::SherdRow> rows_;
  mutable QHash<qint64, int> row_of_;
  mutable QCache<int, std::vector<records::SherdRecord>> pages_{40};
  mutable int pages_read_ = 0;
};

}  // namespace ostraka::ui
