#pragma once
#include <QWidget>

#include "sherds/filter.h"

class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTimer;

namespace ostraka::ui {

/// Which sherds are shown: words and conditions typed, each condition as a chip that goes at a
/// click, and how many sherds fit.
class FilterLine final : public QWidget {
  Q_OBJECT

 public:
  explicit FilterLine(QWidget* parent = nullptr);
  void addButton(QPushButton* button);  ///< beside the line
  QString text() const;
  void setText(const QString& line);  ///< and asks for it at once
  void clear();                       ///< asks nobody
  void takeKeys();                    ///< all of it chosen, to be typed over
  void showConditions(const sherds::Filter& filter);
  void showCount(int sherds);

 signals:
  void wanted(const QString& line);

 private:
  void ask();

  QLineEdit* line_;
  QTimer* typing_;
  QHBoxLayout *row_, *chips_;
  QLabel* count_;
};

}  // namespace ostraka::ui
