#pragma once

class QUndoGroup;

namespace ostraka::ui {

class HeaderLine;
class MainWindow;
class Sidebar;

/// What is done by a key wherever one is: undo and redo, also as buttons of the header, the manual,
/// the settings, the way to other projects and back to work.
void addWindowActions(MainWindow& window, QUndoGroup& undo_group, Sidebar& sidebar,
                      HeaderLine& header);

}  // namespace ostraka::ui
