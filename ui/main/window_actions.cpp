#include "ui/main/window_actions.h"

#include <QAction>
#include <QLayout>
#include <QToolButton>
#include <QUndoGroup>

#include "ui/frame/lines.h"
#include "ui/frame/sidebar.h"
#include "ui/look/look.h"
#include "ui/main/main_window.h"

namespace ostraka::ui {
namespace {

QAction* addAct(MainWindow& window, const QString& name, const QString& icon_name,
                const QString& text, const QKeySequence& key) {
  auto* action = new QAction(icon(icon_name), text, &window);
  action->setObjectName(name);
  action->setShortcut(key);
  window.addAction(action);
  return action;
}

}  // namespace

void addWindowActions(MainWindow& window, QUndoGroup& undo_group, Sidebar& sidebar,
                      HeaderLine& header) {
  QAction* undo = addAct(window, QStringLiteral("undo"), QStringLiteral("undo"),
                         MainWindow::tr("Undo"), QKeySequence::Undo);
  QAction* redo = addAct(window, QStringLiteral("redo"), QStringLiteral("redo"),
                         MainWindow::tr("Redo"), QKeySequence::Redo);
  undo->setEnabled(false);
  redo->setEnabled(false);
  QObject::connect(undo, &QAction::triggered, &undo_group, &QUndoGroup::undo);
  QObject::connect(redo, &QAction::triggered, &undo_group, &QUndoGroup::redo);
  QObject::connect(&undo_group, &QUndoGroup::canUndoChanged, undo, &QAction::setEnabled);
  QObject::connect(&undo_group, &QUndoGroup::canRedoChanged, redo, &QAction::setEnabled);
  QObject::connect(&undo_group, &QUndoGroup::undoTextChanged, undo, [undo](const QString& what) {
    undo->setText(what.isEmpty() ? MainWindow::tr("Undo") : MainWindow::tr("Undo: %1").arg(what));
  });
  QObject::connect(&undo_group, &QUndoGroup::redoTextChanged, redo, [redo](const QString& what) {
    redo->setText(what.isEmpty() ? MainWindow::tr("Redo") : MainWindow::tr("Redo: %1").arg(what));
  });
  for (QAction* action : {undo, redo}) {
    auto* button = new QToolButton(&header);
    button->setDefaultAction(action);
    button->setObjectName(action->objectName() + QStringLiteral("Button"));
    button->setToolButtonStyle(action == undo ? Qt::ToolButtonTextBesideIcon
                                              : Qt::ToolButtonIconOnly);
    button->setAutoRaise(true);
    header.layout()->addWidget(button);
  }
  QObject::connect(addAct(window, QStringLiteral("manual"), QStringLiteral("help"),
                          MainWindow::tr("Manual"), QKeySequence(Qt::Key_F1)),
                   &QAction::triggered, &window, &MainWindow::showManual);
  QObject::connect(addAct(window, QStringLiteral("shortcuts"), QStringLiteral("keys"),
                          MainWindow::tr("All keys"), QKeySequence(Qt::CTRL | Qt::Key_K)),
                   &QAction::triggered, &window, &MainWindow::showShortcuts);
  QObject::connect(addAct(window, QStringLiteral("closeProject"), QStringLiteral("folder"),
                          MainWindow::tr("Other projects"), QKeySequence(Qt::CTRL | Qt::Key_W)),
                   &QAction::triggered, &window, &MainWindow::leaveProject);
  QObject::connect(sidebar.addFoot(QStringLiteral("folder"), MainWindow::tr("Projects"), {}),
                   &QAction::triggered, &window, &MainWindow::leaveProject);
  QAction* settings = sidebar.addFoot(QStringLiteral("settings"), MainWindow::tr("Settings"),
                                      QKeySequence(Qt::CTRL | Qt::Key_Comma));
  window.addAction(settings);  // its key works without a project too
  QObject::connect(settings, &QAction::triggered, &window, &MainWindow::showSettings);
  QObject::connect(sidebar.addFoot(QStringLiteral("help"), MainWindow::tr("Help"), {}),
                   &QAction::triggered, &window, &MainWindow::showManual);
  QObject::connect(addAct(window, QStringLiteral("leavePage"), QStringLiteral("previous"),
                          MainWindow::tr("Back to work"), QKeySequence(Qt::ALT | Qt::Key_Left)),
                   &QAction::triggered, &window, &MainWindow::leaveSidePage);
}

}  // namespace ostraka::ui
