#pragma once
#include <QWidget>
#include <functional>

#include "ui/look/state_colours.h"
#include "ui/main/new_project.h"
#include "ui/settings/window_settings.h"

class QLabel;
class QLineEdit;
class QListWidget;

namespace ostraka::ui {

class BigButton;
class MessagePanel;
class Thumbnails;

/// Before a project is open: the recent ones, photographs that a project is made for, a new one,
/// one from elsewhere, the virtual rig. Folders are dropped onto it, too.
class StartScreen final : public QWidget {
  Q_OBJECT

 public:
  explicit StartScreen(Thumbnails* thumbnails, QWidget* parent = nullptr);
  /// projects: by folder. One whose folder is gone stays, to be found again.
  void setRecent(const QStringList& folders, const QMap<QString, RecentProject>& projects);
  /// Of a damaged catalogue it offers the repair, of an archive that it is restored.
  void showError(const Error& error);
  /// project: may be opened now; empty: not.
  void tell(State state, const QString& headline, const QString& words, const QString& project);
  /// Until something else is told: how far the restoring of a project into this folder is.
  void showRestoring(const QString& folder, const QString& words);
  NewProject* fresh() const { return fresh_; }
  /// Makes a project for these photographs: what nobody typed of it is proposed by their folder.
  void makeFor(const QStringList& photographs);

 signals:
  void opened(const QString& folder);                      ///< to be opened
  void found(const QString& lost, const QString& folder);  ///< of a project that was moved
  void repairWanted(const QString& folder);                ///< of its damaged catalogue
  void restoreWanted(const QString& archive, const QString& folder);
  void restoreCancelled();
  void virtualRigWanted();
  /// These are to be imported into a project of their own; or one of them is a project.
  void photographsChosen(const QStringList& paths);
  void settingsWanted();
  void manualWanted();
  void made(const std::shared_ptr<ostraka::upkeep::Project>& project);

 private:
  QWidget* buildRecent();
  QWidget* buildNew();
  void showNumbering();
  void follow();
  void chooseFolder();
  void choosePhotographs();
  void chooseProject();
  void findLost(const QString& folder);
  void chooseArchive();
  void choosePlaceFor(const QString& archive);
  void make();
  void act();
  void openChosen();

  Thumbnails* thumbnails_;
  NewProject* fresh_;
  QListWidget* recent_;
  QLabel *no_recent_, *example_, *refusal_;
  QLineEdit *name_, *site_, *folder_, *numbering_;
  BigButton *make_, *photographs_, *open_;
  MessagePanel* message_;
  std::function<void()> then_;  ///< what the button of the message does besides hiding it
};

}  // namespace ostraka::ui
