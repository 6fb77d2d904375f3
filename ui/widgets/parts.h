#pragma once
#include <QBoxLayout>
#include <QLabel>
#include <QSplitter>
#include <QString>

#include <initializer_list>
#include <utility>

#include "ui/look/look.h"

namespace ostraka::ui {

/// What a widget is called: by the manual and tests, and by screen readers where its own words do
/// not say it.
struct Names {
  Names(QString object_name, QString spoken = {})
      : object(std::move(object_name)), accessible(std::move(spoken)) {}
  Names(const char* object_name, QString spoken = {})
      : Names(QString::fromLatin1(object_name), std::move(spoken)) {}

  QString object, accessible;
};

/// A new widget with its names: named<QLineEdit>({"target", tr("New folder")}, this).
template <class Widget, class... Arguments>
Widget* named(const Names& names, Arguments&&... arguments) {
  auto* widget = new Widget(std::forward<Arguments>(arguments)...);
  widget->setObjectName(names.object);
  if (!names.accessible.isEmpty()) widget->setAccessibleName(names.accessible);
  return widget;
}

/// What stands in a row or a column: a widget or a layout, with its share of the room that is left,
/// or that room alone.
struct Part {
  Part(QWidget* shown, int of_room = 0, Qt::Alignment at = {})
      : widget(shown), share(of_room), where(at) {}
  Part(QLayout* inner, int of_room = 0) : layout(inner), share(of_room) {}
  static Part room(int of_room = 0) { return {static_cast<QWidget*>(nullptr), of_room}; }

  QWidget* widget = nullptr;
  QLayout* layout = nullptr;
  int share = 0;
  Qt::Alignment where = {};
};

/// The row or column with these parts at its end, in their order.
template <class Box>
Box* filled(Box* box, std::initializer_list<Part> parts) {
  for (const Part& part : parts)
    if (part.widget != nullptr)
      box->addWidget(part.widget, part.share, part.where);
    else if (part.layout != nullptr)
      box->addLayout(part.layout, part.share);
    else
      box->addStretch(part.share);
  return box;
}

/// With these widgets, which share its room.
inline QSplitter* filled(QSplitter* split, std::initializer_list<Part> parts) {
  for (const Part& part : parts) {
    split->addWidget(part.widget);
    split->setStretchFactor(split->count() - 1, part.share);
  }
  return split;
}

/// The column of a whole page, with a page's margins.
inline QVBoxLayout* pageColumn(QWidget* page) {
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(Look::kGroup, Look::kGap, Look::kGroup, Look::kGap);
  return column;
}

/// The label of a field, beside it; a key in its words leads there.
inline QLabel* labelFor(QWidget* field, const QString& words) {
  auto* label = new QLabel(words, field->parentWidget());
  label->setBuddy(field);
  return label;
}

}  // namespace ostraka::ui
