#pragma once
#include <QWidget>

class QSpinBox;

namespace ostraka::ui {

/// How many sherds a person has counted onto the plate; nobody has to.
class CountEdit final : public QWidget {
  Q_OBJECT

 public:
  explicit CountEdit(QWidget* parent = nullptr);
  void setCount(int sherds);
  void takeKeys();  ///< digits go here, until Return, or Space, which is the next thing as ever

 signals:
  void counted(int sherds);  ///< 0: not counted
  void entered();            ///< Return: the person is done

 private:
  QSpinBox* number_;
};

}  // namespace ostraka::ui
