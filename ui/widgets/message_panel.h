#pragma once
#include <QFrame>

#include "base/result.h"
#include "ui/look/state_colours.h"
#include "ui/words/sentence.h"

class QAbstractButton;
class QLabel;
class QPushButton;

namespace ostraka::ui {

class BigButton;

/// What went wrong, to which thing, and one act that mends it, or what else a person should know;
/// in place, never modal. Large enough to be read from across the room. Only errors look like
/// errors.
class MessagePanel final : public QFrame {
  Q_OBJECT

 public:
  MessagePanel(const QString& name, QWidget* parent);  ///< hidden until there is something to say

  /// act: the text of the button, with its key; empty hides the button.
  void showError(const Error& error, const QString& act = {}, const QString& key = {});
  /// Sure: what went well; Ask: what a person decides or minds; Busy: what goes on, and the act is
  /// not what to do next.
  void showWords(State state, const QString& headline, const QString& words,
                 const QString& act = {}, const QString& key = {});
  /// A second, smaller act; empty hides it.
  void setSecondAct(const QString& act);
  /// Beside a page's own primary button: outlined.
  void setBesidePrimary();
  QAbstractButton* act() const;  ///< null while it is hidden
  void setCompact(bool compact);
  QString headline() const;
  QString words() const;

 signals:
  void acted();
  void actedSecond();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void lay();

  QLabel* picture_;
  QLabel* headline_;
  QLabel* words_;
  BigButton* act_;
  QPushButton* second_;
  State state_ = State::Failed;
  bool compact_ = false, beside_primary_ = false;
};

/// A screen without contents says what to do first: a picture, a sentence, one button or several.
class EmptyState : public QWidget {
  Q_OBJECT

 public:
  EmptyState(const QString& icon_name, const QString& headline, const QString& words,
             QWidget* parent = nullptr);
  void setHeadline(const QString& headline);
  void setWords(const QString& words);
  /// The first is the big one.
  QPushButton* addAct(const QString& text, const QString& object_name);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void lay();

  QLabel *picture_, *headline_, *words_;
  QString icon_name_;
  QLayout* acts_;
};

}  // namespace ostraka::ui
