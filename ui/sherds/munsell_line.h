#pragma once
#include <QWidget>

#include "colour/munsell_proposals.h"

class QLabel;
class QPushButton;

namespace ostraka::records {
struct SherdRecord;
}

namespace ostraka::ui {

/// Under a Munsell field: the colour that the photographs propose for it, how far it is from
/// theirs, and whether a colour chart measured it. Nothing is entered before a person takes it
/// over.
class MunsellLine final : public QWidget {
  Q_OBJECT

 public:
  /// field: munsell_out, munsell_in or munsell_core.
  MunsellLine(const std::string& field, QWidget* parent);

  /// False, and empty: there is nothing to say. What the sherd has already cannot be taken over
  /// again. Where its model proposes nothing and no field has a colour, the last line says why.
  bool offer(const colour::MunsellProposals& proposals, const records::SherdRecord& sherd);
  /// Keeps its place while it is not known yet what is proposed for another sherd.
  void clear();

 signals:
  void takenOver(const QString& notation);

 private:
  std::string field_;
  QString notation_;
  QLabel* text_;
  QPushButton* take_over_;
};

}  // namespace ostraka::ui
