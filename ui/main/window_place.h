#pragma once
class QByteArray;
class QWidget;

namespace ostraka::ui {

/// Places a window before it is shown: as it was (QWidget::saveGeometry), or in a usual size; in
/// both cases within the screen that there is now.
void placeWindow(QWidget& window, const QByteArray& geometry);

}  // namespace ostraka::ui
