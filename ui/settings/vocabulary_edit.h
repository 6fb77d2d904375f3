#pragma once
#include <QHash>
#include <QPointer>
#include <QWidget>
#include <vector>

#include "records/sherd.h"

class QComboBox;
class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace ostraka::ui {

class ProjectSession;

/// Part of the settings: the words that the open project describes its sherds with, a vocabulary at
/// a time, one word a line.
class VocabularyEdit final : public QWidget {
  Q_OBJECT

 public:
  explicit VocabularyEdit(QWidget* parent = nullptr);
  /// Hidden without a project.
  void setSession(ProjectSession* session);

 private:
  void buildLayout();
  void showTerms();
  void keepDraft();
  void save();
  std::vector<records::Term> written() const;

  QPointer<ProjectSession> session_;
  QString shown_;                    ///< the vocabulary that is shown
  std::vector<records::Term> held_;  ///< its words in the catalogue
  QHash<QString, QString> drafts_;   ///< of each vocabulary, as typed and not saved yet
  QComboBox* which_;
  QPlainTextEdit* terms_;
  QLabel* told_;
  QPushButton* save_;
};

}  // namespace ostraka::ui
