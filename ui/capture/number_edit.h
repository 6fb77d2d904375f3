#pragma once
#include <QWidget>

class QLabel;
class QLineEdit;

namespace ostraka::ui {

class SherdNumbers;

/// One sherd after another gets its number: Return keeps it and goes on, the arrow keys keep it and
/// go back and forth, as does whoever leaves the field; only Esc takes it back.
class NumberEdit final : public QWidget {
  Q_OBJECT

 public:
  explicit NumberEdit(SherdNumbers* numbers, QWidget* parent = nullptr);
  int sherd() const { return sherd_; }

 public slots:
  /// And be ready to type; a number that is refused is looked at first.
  void choose(int sherd);
  /// What stands in the field; false when it is refused, with the reason beside it.
  bool keepTyped();

 signals:
  void chosen(int sherd);
  void finished();  ///< the last one was given

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showSherd(int sherd);
  void keep();
  bool give();

  SherdNumbers* numbers_;
  QLabel *label_, *note_;
  QLineEdit* edit_;
  int sherd_ = 0;
};

}  // namespace ostraka::ui
