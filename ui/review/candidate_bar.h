#pragma once
#include <QWidget>

class QToolButton;

namespace ostraka::ui {

class FlowRow;
class CardInHand;
class PairReview;

/// One large button for each candidate, numbered as the keys, and any other back in a menu.
class CandidateBar final : public QWidget {
  Q_OBJECT

 public:
  explicit CandidateBar(PairReview& review, QWidget* parent = nullptr);
  void setCompact(bool compact);  ///< fewer, so that they stand in one row
  /// The menu of all other backs, to be put where there is room.
  QToolButton* others() const { return others_; }

 protected:
  void changeEvent(QEvent* event) override;  ///< marks follow the theme

 private:
  void rebuild();
  void mark();
  void write(int i);
  void fillOthers();

  PairReview& review_;
  CardInHand& hand_;
  FlowRow* row_ = nullptr;
  QList<QToolButton*> buttons_;
  QToolButton* others_ = nullptr;
  int most_;
};

}  // namespace ostraka::ui
