#pragma once

class QTableView;

namespace ostraka::ui {

/// Keeps the first column of the table in sight while the others are scrolled below it: a second
/// view of the same model and selection lies over it then.
void freezeFirstColumn(QTableView& table);

}  // namespace ostraka::ui
