#include "ui/import/path_drop.h"

#include <QDropEvent>
#include <QMimeData>
#include <QUrl>
#include <QWidget>

namespace ostraka::ui {
namespace {

QStringList pathsOf(const QMimeData* data) {
  QStringList paths;
  for (const QUrl& url : data->urls())
    if (url.isLocalFile()) paths << url.toLocalFile();
  return paths;
}

}  // namespace

PathDrop::PathDrop(QWidget* page) : QObject(page), page_(page) {
  page->installEventFilter(this);
}

bool PathDrop::eventFilter(QObject* watched, QEvent* event) {
  if (!page_->acceptDrops()) return false;
  if (event->type() == QEvent::DragEnter || event->type() == QEvent::DragMove) {
    auto* drag = static_cast<QDragMoveEvent*>(event);
    if (pathsOf(drag->mimeData()).isEmpty()) return false;
    drag->acceptProposedAction();
    return true;
  }
  if (event->type() == QEvent::Drop) {
    auto* drop = static_cast<QDropEvent*>(event);
    drop->acceptProposedAction();
    emit dropped(pathsOf(drop->mimeData()));
    return true;
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace ostraka::ui
