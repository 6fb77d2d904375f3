#include "ui/jobs/sentence.h"

#include <QCoreApplication>

namespace ostraka::ui {
namespace {

// Of the core's fixed sentences those that reach a person while the hands are full: devices, disk,
// catalogue. They are looked up by themselves; others stay as the core says them.
[[maybe_unused]] constexpr const char* kKnown[] = {
    QT_TRANSLATE_NOOP("ostraka::Error", "Stopped on request."),
    QT_TRANSLATE_NOOP("ostraka::Error", "The camera is not plugged in."),
    QT_TRANSLATE_NOOP("ostraka::Error", "The camera is not plugged in or not switched on."),
    QT_TRANSLATE_NOOP(
        "ostraka::Error",
        "The camera does not answer; is it asleep? Switch its automatic power-off off."),
    QT_TRANSLATE_NOOP("ostraka::Error", "The camera stays busy; switch it off and on."),
    QT_TRANSLATE_NOOP("ostraka::Error", "The line to the camera is broken; look at its cable."),
    QT_TRANSLATE_NOOP("ostraka::Error",
                      "The camera is held by another program, often the desktop's file manager; "
                      "'ostraka devices' names it."),
    QT_TRANSLATE_NOOP(
        "ostraka::Error",
        "The camera cannot be opened; may this user use it? Look at 'ostraka devices'."),
    QT_TRANSLATE_NOOP("ostraka::Error",
                      "No photograph came from the camera; is it focused and set to manual?"),
    QT_TRANSLATE_NOOP("ostraka::Error", "The camera does not stop to deliver photographs."),
    QT_TRANSLATE_NOOP("ostraka::Error", "This camera shows no live picture."),
    QT_TRANSLATE_NOOP("ostraka::Error", "The turntable does not reach its angle; is it blocked?"),
    QT_TRANSLATE_NOOP("ostraka::Error", "The turntable was paused at its own button."),
    QT_TRANSLATE_NOOP("ostraka::Error", "The table's position is not known: home it, or align it."),
    QT_TRANSLATE_NOOP("ostraka::Error", "The turntable does not answer in the network."),
    QT_TRANSLATE_NOOP("ostraka::Error",
                      "The controller restarted; the table's position is not known."),
    QT_TRANSLATE_NOOP("ostraka::Error",
                      "A reply of the turntable was lost and it cannot tell where it stands: home "
                      "it, or align it."),
    QT_TRANSLATE_NOOP("ostraka::Error",
                      "The turntable does not answer like a GRBL controller: is it switched on, "
                      "and is it of this type?"),
    QT_TRANSLATE_NOOP(
        "ostraka::Error",
        "The turntable does not answer like a ComXim: is it switched on, and is it of this type?"),
    QT_TRANSLATE_NOOP("ostraka::Error", "USB does not work on this computer."),
    QT_TRANSLATE_NOOP("ostraka::Error", "The disk is full; free some space and shoot on."),
    QT_TRANSLATE_NOOP("ostraka::Error",
                      "The disk is full; free some space and start the same command again."),
    QT_TRANSLATE_NOOP("ostraka::Error",
                      "The disk is full; make room, then try again. Nothing was lost."),
    QT_TRANSLATE_NOOP("ostraka::Error",
                      "Another program keeps the catalogue busy; close it, then try again."),
    QT_TRANSLATE_NOOP("ostraka::Error",
                      "The image is cut off before its end; copy it from the camera again."),
};

}  // namespace

QString wordsOf(const std::string& what) {
  return QCoreApplication::translate("ostraka::Error", what.c_str());
}

QString sentenceOf(const Error& error) {
  return error.where.empty() ? wordsOf(error.what)
                             : QStringLiteral("%1: %2").arg(QString::fromStdString(error.where),
                                                            wordsOf(error.what));
}

}  // namespace ostraka::ui
