#pragma once
#include <QKeySequence>
#include <QString>

class QAction;
class QFileDialog;
class QPushButton;
class QWidget;

namespace ostraka::ui {

/// What a page can do: its key holds wherever the focus is within the page.
/// icon_name: may be empty.
QAction* addPageAct(QWidget* page, const QString& name, const QString& icon_name,
                    const QString& text, const QKeySequence& key);

/// Asks for a file of these kinds, or without any for a folder; where: opened first.
/// Its fileSelected follows.
QFileDialog* askForFile(QWidget* parent, const QString& title, const QString& where,
                        const QString& kinds);
/// A button with a picture.
QPushButton* iconButton(QWidget* parent, const QString& name, const QString& icon_name,
                        const QString& text);

}  // namespace ostraka::ui
