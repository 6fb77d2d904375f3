#pragma once
#include <QPointer>
#include <filesystem>

#include "ui/frame/screen.h"

class QComboBox;
class QLabel;

namespace ostraka::ui {

/// A screen of one batch, of those whose pairs are there: which it is, and what there is to say.
class PlateScreen : public Screen {
  Q_OBJECT

 public:
  QString chosen() const override;
  QString whereWords() const override;
  /// The batch of the screen before is the one that is wanted here.
  void takeChosen(const QString& what) override;

 protected:
  PlateScreen(const QString& title, const QString& icon_name, QWidget* parent);
  virtual void showBatch(const QString& batch) = 0;
  QStringList reviewable() const;  ///< the newest first
  std::filesystem::path outputOf(const QString& batch) const;
  void say(const QString& sentence);

  QPointer<ProjectSession> session_;
  QString batch_;
  QComboBox* batches_;
  QLabel* message_;
};

}  // namespace ostraka::ui
