#pragma once
#include <QWidget>

class QLabel;
class QProgressBar;

namespace ostraka::ui {

class BatchImporter;

/// How far an import is, and the way to stop it; there only while one runs.
class ImportLine final : public QWidget {
  Q_OBJECT

 public:
  explicit ImportLine(BatchImporter* importer, QWidget* parent = nullptr);

 private:
  void showProgress(double fraction);

  QLabel* words_;
  QProgressBar* bar_;
};

}  // namespace ostraka::ui
