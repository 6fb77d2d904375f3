#pragma once
#include <QWidget>

class QLabel;
class QLineEdit;

namespace ostraka::ui {

class SherdNumbers;

/// One sherd after another gets its number: Return keeps it and goes on, the arrow keys go back and
/// forth.
class NumberEdit final : public QWidget {
  Q_OBJECT

 public:
  explicit NumberEdit(SherdNumbers* numbers, QWidget* parent = nullptr);
  int sherd() const { return sherd_; }

 public slots:
  void choose(int sherd);  ///< and be ready to type

 signals:
  void chosen(int sherd);
  void finished();  ///< the last one was given

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showSherd(int sherd);
  void keep();

  SherdNumbers* numbers_;
  QLabel *label_, *note_;
  QLineEdit* edit_;
  int sherd_ = 0;
};

}  // namespace ostraka::ui
