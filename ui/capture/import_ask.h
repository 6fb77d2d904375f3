#pragma once
#include <QWidget>

#include "ui/capture/import_batch.h"
#include "ui/capture/place_text.h"

class QLabel;
class QPushButton;

namespace ostraka::ui {

class PlaceEdit;

/// Asks where the sherds of a folder come from before it is imported; without a bag they get no
/// numbers, and no context but by hand.
class ImportAsk final : public QWidget {
  Q_OBJECT

 public:
  explicit ImportAsk(QWidget* parent = nullptr);
  PlaceEdit* place() const { return place_; }
  /// Until confirmed() or left().
  void ask(const QString& folder, ImportKind kind);
  void leave();

 signals:
  void asked();  ///< this is the one field for a bag now
  void confirmed(const QString& folder, ostraka::ui::ImportKind kind,
                 const ostraka::ui::PlaceText& place);
  void left();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void confirm();

  QString folder_;
  ImportKind kind_ = ImportKind::Photographs;
  QLabel* words_;
  PlaceEdit* place_;
  QPushButton* import_;
};

}  // namespace ostraka::ui
