#include "ui/widgets/page_acts.h"

#include <QAction>
#include <QCoreApplication>
#include <QFileDialog>
#include <QPushButton>

#include "ui/look/look.h"

namespace ostraka::ui {

QAction* addPageAct(QWidget* page, const QString& name, const QString& icon_name,
                    const QString& text, const QKeySequence& key) {
  auto* action = new QAction(text, page);
  if (!icon_name.isEmpty()) action->setIcon(icon(icon_name));
  action->setObjectName(name);
  action->setShortcut(key);
  action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  page->addAction(action);
  return action;
}

// The large key has two names; Qt's for the one that programs act on is not on German keyboards.
QString keyText(const QKeySequence& key) {
  return key == QKeySequence(Qt::Key_Return) || key == QKeySequence(Qt::Key_Enter)
             ? QCoreApplication::translate("ostraka::ui", "Enter")
             : key.toString(QKeySequence::NativeText);
}

QFileDialog* askForFile(QWidget* parent, const QString& title, const QString& where,
                        const QString& kinds) {
  auto* dialog = new QFileDialog(parent, title, where, kinds);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(kinds.isEmpty() ? QFileDialog::Directory : QFileDialog::ExistingFile);
  dialog->setOption(QFileDialog::ShowDirsOnly, kinds.isEmpty());
  dialog->open();
  return dialog;
}

QPushButton* iconButton(QWidget* parent, const QString& name, const QString& icon_name,
                        const QString& text) {
  auto* button = new QPushButton(icon(icon_name), text, parent);
  button->setObjectName(name);
  return button;
}

}  // namespace ostraka::ui
