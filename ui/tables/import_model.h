#pragma once
#include <QObject>
#include <QPointer>
#include <QStringList>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tables/import_table.h"
#include "ui/jobs/job.h"

namespace ostraka::ui {

class ProjectSession;

/// A table (CSV) or an export folder that is to be read into the project: what each row would do,
/// why others are refused, then entered whole or not at all. What is entered is the table that was
/// looked at, whatever becomes of its file meanwhile. Runs without a display.
class ImportModel final : public QObject {
  Q_OBJECT

 public:
  enum class State { Choosing, Looking, Ready, Entering, Done };
  struct Row {
    int line = 0;
    tables::RowFate fate = tables::RowFate::Same;
    QStringList values;     ///< "grey → black" where a value that is there becomes another
    std::set<int> changed;  ///< of them, which
    QString refusal;        ///< and what else becomes another, of which the table has no column
  };

  explicit ImportModel(QObject* parent = nullptr) : QObject(parent) {}
  void openProject(ProjectSession* session);  ///< nullptr closes it

  State state() const { return state_; }
  const QString& source() const { return source_; }
  bool makesPlaces() const { return make_places_; }
  bool isOfContexts() const;  ///< a table without numbers of sherds
  /// A file or a folder; what it would do is found out at once, on a copy of the catalogue.
  void setSource(const QString& path);
  void setMakesPlaces(bool make);
  /// Which field and unit the table's column belongs to; an empty unit is proposed.
  void setColumn(int column, const QString& field, const QString& unit);
  /// Of a row that asks about a measurement: a person says that it enters all the same.
  void setConfirmed(int line, bool confirmed);
  void confirmAll();
  bool isConfirmed(int line) const { return confirmed_.contains(line); }
  bool asks() const;     ///< rows wait for a confirmation, also after the others entered
  int entering() const;  ///< rows that would enter

  const QStringList& columns() const { return columns_; }
  const std::vector<Row>& rows() const {
    return rows_;
  }  ///< the first thousand; refused ones first, then those that ask, then those that change
  const std::optional<tables::ImportReport>& report() const { return report_; }
  QString summary() const;  ///< "3 new, 2 changed, 10 as they are, 1 refused."
  QString problem() const { return problem_; }
  QStringList warnings() const;
  double fraction() const { return job_ ? job_->progress().fraction : 0; }

  bool canEnter() const;
  void enter();
  void cancel();
  /// The rows that did not enter (tables::refusedRowsCsv); the file that was written. A name
  /// without the ending of a table gets .csv.
  Result<QString> saveRefusals(const QString& file) const;

 signals:
  void changed();
  void entered(const QString& source, const ostraka::tables::ImportReport& report);

 private:
  struct Look;
  tables::ImportOptions options() const;
  void look();
  void took(const Look& look);
  void settleRows();

  ProjectSession* session_ = nullptr;
  State state_ = State::Choosing;
  QString source_, problem_;
  std::shared_ptr<const std::string> bytes_;  // of the table that was looked at: these are entered
  bool make_places_ = false;
  std::vector<tables::ColumnChoice> chosen_;
  std::set<int> confirmed_;
  QStringList columns_;
  std::vector<Row> rows_;
  std::optional<tables::ImportReport> report_;
  QPointer<JobHandle> job_;
};

}  // namespace ostraka::ui
