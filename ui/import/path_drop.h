#pragma once
#include <QObject>
#include <QStringList>

class QWidget;

namespace ostraka::ui {

/// Folders and files that are dropped onto a page, while the page accepts drops.
class PathDrop final : public QObject {
  Q_OBJECT

 public:
  explicit PathDrop(QWidget* page);

 signals:
  void dropped(const QStringList& paths);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* page_;
};

}  // namespace ostraka::ui
