#include "ui/frame/screen.h"

#include <QPushButton>

#include "ui/widgets/message_panel.h"

namespace ostraka::ui {

Screen::Screen(const QString& title, const QString& icon_name, QWidget* parent)
    : QWidget(parent), title_(title), icon_name_(icon_name) {}

QPushButton* Screen::offerCapture(EmptyState& empty, const QString& object_name) {
  QPushButton* act = empty.addAct(tr("Capture a batch"), object_name);
  connect(act, &QPushButton::clicked, this,
          [this] { emit wantsScreen(QStringLiteral("capture"), {}); });
  return act;
}

}  // namespace ostraka::ui
