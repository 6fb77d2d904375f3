#pragma once
#include <QWidget>
#include <functional>

#include "ui/import/place_text.h"

class QLabel;
class QLineEdit;

namespace ostraka::ui {

/// The bag that the sherds come from: typed, or scanned from its label by a code reader that types.
class PlaceEdit final : public QWidget {
  Q_OBJECT

 public:
  explicit PlaceEdit(QWidget* parent = nullptr);
  /// How texts are understood; without one as readPlaceText does.
  void setReader(std::function<std::optional<PlaceText>(const QString&)> reader);
  /// What of a place is new and would be made: it is said beside the field. Esc while the
  /// cursor is in the field brings back the text of before.
  void setNews(std::function<QString(const PlaceText&)> news);
  /// Of the project, for the example in the empty field; empty: there is none yet.
  void setSite(const QString& code);
  /// A bag by the text of a label's code, as the reader understands it.
  std::optional<PlaceText> read(const QString& code) const { return reader_(code); }
  void setText(const QString& text);
  QString text() const;
  void setCompact(bool compact);
  void choose();                          ///< all of it, to be typed anew
  PlaceText place() const;                ///< empty when nothing or nonsense is typed
  QLabel* note() const { return note_; }  ///< what to know about it; a line of its own
  bool isUsable() const;                  ///< a place, or nothing at all
  void follow();                          ///< what is known has changed

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 signals:
  void edited();
  void entered();  ///< Return: the person is done
  void settled();  ///< Return, or the cursor is elsewhere

 private:
  QString noteWords();

  std::function<std::optional<PlaceText>(const QString&)> reader_ = readPlaceText;
  std::function<QString(const PlaceText&)> news_;
  QString known_;  ///< the text before anything new was typed
  QLineEdit* edit_;
  QLabel* note_;
};

}  // namespace ostraka::ui
