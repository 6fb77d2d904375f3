#include "ui/frame/screen.h"

namespace ostraka::ui {

Screen::Screen(const QString& title, const QString& icon_name, QWidget* parent)
    : QWidget(parent), title_(title), icon_name_(icon_name) {}

}  // namespace ostraka::ui
