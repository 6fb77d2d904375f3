#pragma once
#include <QAction>
#include <QKeySequence>
#include <QPushButton>
#include <QString>

#include <utility>

class QFileDialog;

namespace ostraka::ui {

/// What a page can do: its key holds wherever the focus is within the page.
/// icon_name: may be empty.
QAction* addPageAct(QWidget* page, const QString& name, const QString& icon_name,
                    const QString& text, const QKeySequence& key);

/// With what follows it: a receiver and its slot, as for QObject::connect.
template <class Receiver, class Slot>
QAction* addPageAct(QWidget* page, const QString& name, const QString& icon_name,
                    const QString& text, const QKeySequence& key, Receiver* receiver, Slot slot) {
  QAction* action = addPageAct(page, name, icon_name, text, key);
  QObject::connect(action, &QAction::triggered, receiver, std::move(slot));
  return action;
}

/// A key as the window names it, the same everywhere: "Ctrl+P", "Enter".
QString keyText(const QKeySequence& key);

/// Asks for a file of these kinds, or without any for a folder; where: opened first.
/// Its fileSelected follows.
QFileDialog* askForFile(QWidget* parent, const QString& title, const QString& where,
                        const QString& kinds);
/// A button with a picture.
QPushButton* iconButton(QWidget* parent, const QString& name, const QString& icon_name,
                        const QString& text);

/// With what a click does.
template <class Receiver, class Slot>
QPushButton* iconButton(QWidget* parent, const QString& name, const QString& icon_name,
                        const QString& text, Receiver* receiver, Slot slot) {
  QPushButton* button = iconButton(parent, name, icon_name, text);
  QObject::connect(button, &QPushButton::clicked, receiver, std::move(slot));
  return button;
}

}  // namespace ostraka::ui
