#pragma once
#include <QFrame>

class QLabel;
class QProgressBar;
class QAction;
class QDateTime;

namespace ostraka::ui {

/// The line at the head: where we are, the rig in words, how many batches still fit on the disk.
class HeaderLine final : public QFrame {
  Q_OBJECT

 public:
  explicit HeaderLine(QWidget* parent = nullptr);
  void setWhere(const QString& words);
  void setRig(const QString& words, bool ready);
  /// batches < 0: not known. Few of them are said with a warning.
  void setRoom(int batches);
  void setCompact(bool compact);

 private:
  QLabel* where_;
  QLabel* rig_;
  QLabel* room_;
};

/// The line at the foot: what the computer does now, always; with Pause and Log. Sentences of the
/// screens stay there for a while.
class FooterLine final : public QFrame {
  Q_OBJECT

 public:
  explicit FooterLine(QAction* pause, QAction* log, QWidget* parent = nullptr);
  /// fraction < 0: nothing is being computed.
  void setWork(const QString& words, double fraction);
  void say(const QString& sentence);
  void setCompact(bool compact);

 private:
  QLabel* work_;
  QProgressBar* bar_;
  QLabel* said_;
};

/// "2026-11-23 14:05": in every language the same, and never a day for a month.
QString momentWords(const QDateTime& moment);

/// "about 10 min left", "less than a minute left", "about 1.5 h left"; empty when not known.
QString timeLeftWords(double seconds);

}  // namespace ostraka::ui
