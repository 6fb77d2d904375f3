#pragma once
#include <QWidget>
#include <vector>

#include "ui/import/import_batch.h"
#include "ui/import/place_text.h"
#include "ui/import/side_labels.h"

class QLabel;

namespace ostraka::ui {

class BigButton;
class MessagePanel;
class PlaceEdit;
class SidesView;

/// Shows what is to be imported and takes the bag that it comes from; without one the sherds get no
/// numbers, and no context but by hand.
class ImportAsk final : public QWidget {
  Q_OBJECT

 public:
  explicit ImportAsk(QWidget* parent = nullptr);
  PlaceEdit* place() const { return place_; }
  SidesView* sides() const { return sides_; }
  BigButton* import() const { return import_; }
  bool isAsking() const { return !isHidden(); }
  /// Until confirmed() or left().
  void ask(const QString& folder, ImportKind kind);
  /// The same of photographs by hand, whose sides are confirmed, too.
  void askSides(const SidesPlan& plan);
  /// Codes in photographs of askSides: the bag that their labels name stands in the field, unless a
  /// person has typed one.
  void takeCodes(std::vector<capture::PhotographCodes> seen);
  /// As it was confirmed last: that could not be imported.
  void askAgain();
  void leave();

 signals:
  void asked();  ///< this is the one field for a bag now
  void placeEdited();
  void confirmed(const QString& folder, ostraka::ui::ImportKind kind,
                 const ostraka::ui::PlaceText& place,
                 const std::optional<ostraka::ui::ImportSides>& sides);
  void left();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void open(const QString& folder, ImportKind kind);
  void confirm();
  bool isReady() const;
  bool areSidesDecided() const;
  void follow();
  SideLabels labels() const;
  void followLabels();

  QString folder_;
  ImportKind kind_ = ImportKind::Photographs;
  QLabel* words_;
  SidesView* sides_;
  PlaceEdit* place_;
  QLabel* labels_;             ///< what labels in the photographs say
  MessagePanel* label_doubt_;  ///< what they say against it
  std::vector<capture::PhotographCodes> codes_;
  QLabel* reason_;  ///< why it cannot be imported yet
  BigButton* import_;
};

}  // namespace ostraka::ui
