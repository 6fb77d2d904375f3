#pragma once
#include <QLineEdit>
#include <QTableView>
#include <QtTest>

#include "sample_project.h"
#include "ui/catalogue/catalogue_station.h"
#include "ui/viewport/sherd_view.h"

namespace ostraka::ui {

/// The catalogue's station in a window, with 40 sherds.
class CatalogueWindow : public QObject {
 protected:
  template <class T>
  T* child(const char* name) {
    T* found = station_->findChild<T*>(name);
    if (!found) qFatal("no %s", name);
    return found;
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
    station_ = std::make_unique<CatalogueStation>();
    reserveOpenGl(*station_);
    station_->resize(1280, 720);
    station_->openProject(sample_->session());
    station_->show();
    station_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(station_.get()));
  }
  void close() {
    station_.reset();
    sample_.reset();
  }

  std::unique_ptr<SampleProject> sample_;
  std::unique_ptr<CatalogueStation> station_;
};

}  // namespace ostraka::ui
