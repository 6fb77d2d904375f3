#pragma once
#include <QKeySequence>
#include <QString>

class QAction;
class QPushButton;
class QWidget;

namespace ostraka::ui {

/// What a page can do: its key holds wherever the focus is within the page.
/// icon_name: may be empty.
QAction* addPageAct(QWidget* page, const QString& name, const QString& icon_name,
                    const QString& text, const QKeySequence& key);

/// A button with a picture, as high as the lines to type into beside it.
QPushButton* iconButton(QWidget* parent, const QString& name, const QString& icon_name,
                        const QString& text);

}  // namespace ostraka::ui
