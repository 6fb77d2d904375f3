#pragma once
#include <QLineEdit>
#include <QTableView>
#include <QtTest>

#include "../named.h"
#include "sample_project.h"
#include "ui/catalogue/catalogue_screen.h"
#include "ui/viewport/sherd_view.h"

namespace ostraka::ui {

/// The catalogue's screen in a window, with 40 sherds.
class CatalogueWindow : public QObject {
 public:
  static void initMain() { prepareOpenGl(); }

 protected:
  template <class T>
  T* child(const char* name) {
    return named<T>(*screen_, name);
  }
  QTableView* table() { return child<QTableView>("sherds"); }
  void filter(const QString& line) {
    auto* edit = child<QLineEdit>("filter");
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, line);
    QTest::keyClick(edit, Qt::Key_Return);
  }
  void choose(int row) {
    QTest::mouseClick(table()->viewport(), Qt::LeftButton, {},
                      table()->visualRect(table()->model()->index(row, 0)).center());
  }
  void open() {
    sample_ = std::make_unique<SampleProject>(40);
    screen_ = std::make_unique<CatalogueScreen>();
    reserveOpenGl(*screen_);
    screen_->resize(1280, 720);
    screen_->openProject(sample_->session());
    activate(*screen_);
  }
  void close() {
    screen_.reset();
    sample_.reset();
  }

  std::unique_ptr<SampleProject> sample_;
  std::unique_ptr<CatalogueScreen> screen_;
};

}  // namespace ostraka::ui
