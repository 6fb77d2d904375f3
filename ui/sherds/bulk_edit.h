#pragma once
#include <QPointer>
#include <QWidget>
#include <set>
#include <vector>

#include "catalogue/catalogue.h"
#include "catalogue/label_codes.h"
#include "records/sherd.h"
#include "ui/frame/term_words.h"
#include "ui/jobs/job.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace ostraka::ui {

class ProjectSession;

/// The same field of many sherds, with a preview of what changes and what is refused.
class BulkEdit final : public QWidget {
  Q_OBJECT

 public:
  explicit BulkEdit(QWidget* parent = nullptr);
  /// session: nullptr when no project is open. The preview comes from a worker.
  void setSherds(ProjectSession* session, std::vector<store::SherdRow> sherds);
  void preview();  ///< the same sherds, what is typed stays: rows of the catalogue changed
  const std::vector<store::SherdRow>& sherds() const { return sherds_; }
  /// What comes with the changes that the preview showed.
  QString note() const { return note_; }
  /// While many are being changed: how far it is; below 0: nothing is going on.
  void showProgress(double fraction);

 signals:
  /// The changes that the preview showed without a refusal.
  void wanted(const std::vector<records::FieldChange>& changes);
  void numbersWanted();
  void comparisonWanted();  ///< of exactly two
  void stopWanted();

 private:
  void buildLayout();
  struct Preview;
  void showPreview(const Preview& preview);
  void makeBags();
  void offerTerms();

  ProjectSession* session_ = nullptr;
  QPointer<JobHandle> previewing_;
  std::vector<store::SherdRow> sherds_;
  std::vector<records::FieldChange> good_;
  QString note_;
  QLabel* heading_ = nullptr;
  QComboBox* field_ = nullptr;
  TermWords words_;
  QLineEdit* value_ = nullptr;
  QCheckBox* replace_ = nullptr;  ///< a person confirms what is asked of measurements
  QPushButton* make_bags_ = nullptr;
  std::set<catalogue::BagPlace> lacking_;  ///< that sherds would leave theirs for none
  QLabel* summary_ = nullptr;
  QTableWidget* table_ = nullptr;
  QPushButton* apply_ = nullptr;
  QPushButton* numbers_ = nullptr;
  QPushButton* compare_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QPushButton* stop_ = nullptr;
};

}  // namespace ostraka::ui
