#pragma once
#include <QString>
#include <QWidget>

class QAbstractButton;

namespace ostraka::ui {

class ProjectSession;

/// One screen of the sidebar: Capture, Queue, Review, Map, Catalogue, Export. The frame makes each
/// once, shows it, and hands it the project that was opened.
class Screen : public QWidget {
  Q_OBJECT

 public:
  /// title: one word in the sidebar, translated. icon_name: a picture of resources/icons and a page
  /// of the manual, which F1 opens: "capture".
  Screen(const QString& title, const QString& icon_name, QWidget* parent);

  const QString& title() const { return title_; }
  const QString& iconName() const { return icon_name_; }
  /// A project was opened or another one took its place. The session outlives what is shown of it
  /// until the next call.
  virtual void openProject(ProjectSession& session) = 0;
  /// The project closes: let go of the session. Called before openProject of another one, too.
  virtual void closeProject() = 0;

  /// How many things on this screen want a person; the sidebar shows it when above 0.
  virtual int waiting() const { return 0; }
  /// The same in words for screen readers: "5 pairs need your eye".
  virtual QString waitingText() const { return {}; }
  /// The screen comes to the front (true) or leaves it: a live picture may rest.
  virtual void setInFront(bool /*in_front*/) {}

  /// The one filled button: what to do next. Null where there is nothing to do yet.
  virtual QAbstractButton* primary() const { return nullptr; }
  /// A window below Look::kCompactBelow: no captions, one line where there were several.
  virtual void setCompact(bool /*compact*/) {}

  /// Of which batch or bag the screen is, for the line at the head; empty: of the whole project.
  virtual QString whereWords() const { return {}; }

  /// What would be lost if the project were closed now, a sentence; empty: nothing.
  virtual QString losesByClosing() const { return {}; }

  /// What is chosen here, for the screen that comes next, as its showItem takes it; of a screen
  /// that shows one batch kPlate with its number.
  static constexpr QLatin1String kPlate{"plate:", 6};
  virtual QString chosen() const { return {}; }
  /// What was chosen on the screen that the person comes from.
  virtual void takeChosen(const QString& /*what*/) {}

 signals:
  void waitingChanged();
  void whereChanged();
  /// It does something long of its own: for the line at the foot. fraction < 0: no more.
  void working(const QString& words, double fraction);
  /// One sentence for the line at the foot, e.g. what was just done.
  void said(const QString& sentence);
  /// Another screen should show this: "review", batch number. The frame switches and passes it on.
  /// "settings", "numbering": the settings, at how sherds are numbered.
  void wantsScreen(const QString& icon_name, const QString& what);

 public slots:
  /// What wantsScreen of another screen asked for: a batch number or a sherd's.
  virtual void showItem(const QString& /*what*/) {}

 private:
  QString title_, icon_name_;
};

}  // namespace ostraka::ui
