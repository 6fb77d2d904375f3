#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences CoreSentences::ofCapture() {
  static constexpr const char* kAll[] = {
      QT_TR_NOOP("The camera is not plugged in."),
      QT_TR_NOOP("The camera is not plugged in or not switched on."),
      QT_TR_NOOP("The camera does not answer and may be asleep. Turn off its automatic power-off."),
      QT_TR_NOOP("The camera stays busy; switch it off and on."),
      QT_TR_NOOP("The connection to the camera failed; check its cable."),
      QT_TR_NOOP("Another program uses the camera, often the desktop's file manager; 'ostraka "
                 "devices' names it."),
      QT_TR_NOOP(
          "The camera cannot be opened; check this user's permissions with 'ostraka devices'."),
      QT_TR_NOOP("The camera sent no photograph; check that it is focused and set to manual."),
      QT_TR_NOOP("The camera does not stop sending photographs."),
      QT_TR_NOOP("This camera has no live view."),
      QT_TR_NOOP("The turntable does not reach its angle; check that nothing blocks it."),
      QT_TR_NOOP("The turntable was paused with its own button."),
      QT_TR_NOOP("The turntable's position is unknown: home it or align it."),
      QT_TR_NOOP("The turntable does not answer on the network."),
      QT_TR_NOOP("The controller restarted; the turntable's position is unknown."),
      QT_TR_NOOP("A reply from the turntable was lost, and it cannot report its position: home it "
                 "or align it."),
      QT_TR_NOOP("The turntable does not answer like a GRBL controller; check that it is switched "
                 "on and of this type."),
      QT_TR_NOOP("The turntable does not answer like a ComXim; check that it is switched on and of "
                 "this type."),
      QT_TR_NOOP("USB does not work on this computer."),
      QT_TR_NOOP("The disk is full; free some space, then continue shooting."),
      QT_TR_NOOP("The angle is not a number."),
      QT_TR_NOOP("This program is not installed."),
      QT_TR_NOOP("The picture cannot be decoded."),
      QT_TR_NOOP("This cannot be written (%1); choose another folder for the batch or check its "
                 "permissions."),
      QT_TR_NOOP("A file with this name already exists and is not overwritten; choose another "
                 "batch name."),
      QT_TR_NOOP(
          "This batch started on another plate; continue with that plate or start a new batch."),
      QT_TR_NOOP("This batch started with %1 cameras and %2 positions, not with %3 and %4; choose "
                 "another folder."),
      QT_TR_NOOP("The photograph has changed since it was taken; restore the original or choose "
                 "another folder for the batch."),
      QT_TR_NOOP(
          "This photograph does not belong to this batch; choose another folder for the batch."),
      QT_TR_NOOP("Camera %1 delivers raw files only; set its image format to JPEG, or to both."),
      QT_TR_NOOP("%1 is %2, but the rig specifies %3"),
      QT_TR_NOOP("%1 is %2, but the first photograph used %3"),
      QT_TR_NOOP("The turntable did not reach its zero."),
      QT_TR_NOOP("The turntable did not answer."),
      QT_TR_NOOP("The turntable does not report its position."),
      QT_TR_NOOP("The turntable rejected a command (error %1): wrong turntable type or bad cable."),
      QT_TR_NOOP("The turntable's speed must be greater than 0."),
      QT_TR_NOOP("The connection to the turntable failed (%1)."),
      QT_TR_NOOP("it is not open"),
      QT_TR_NOOP("it accepts no more data"),
      QT_TR_NOOP("it was closed at the other end"),
      QT_TR_NOOP("You have no permission to use this serial port; install Ostraka's udev rules or "
                 "join the group dialout, then log in again."),
      QT_TR_NOOP("Another program uses the serial port; close that program."),
      QT_TR_NOOP("The serial port does not exist; check that the turntable is plugged in and "
                 "switched on."),
      QT_TR_NOOP("Not a serial port."),
      QT_TR_NOOP("The serial port does not accept its settings."),
      QT_TR_NOOP("The turntable's address is unknown on this network."),
      QT_TR_NOOP("A serial port does not support %1 baud; common rates are 9600 and 115200."),
      QT_TR_NOOP("A network address looks like 192.168.0.7:23."),
      QT_TR_NOOP("The desktop does not release the camera: it is still in use by %1; close its "
                 "file window and try again."),
      QT_TR_NOOP("A watched folder has no setting %1; set it on the camera."),
      QT_TR_NOOP("A watched folder has no live view."),
      QT_TR_NOOP("No new photograph arrived within %1 seconds; check that the camera's software "
                 "writes into this folder."),
      QT_TR_NOOP("The watched folder cannot be read (%1)."),
      QT_TR_NOOP("Two photographs arrived for one shot, %1 and %2; use one folder per camera and "
                 "one photograph per position."),
      QT_TR_NOOP("The camera with this serial number is not plugged in; found: %1."),
      QT_TR_NOOP("The camera does not offer %1 for %2; it is set to %3."),
      QT_TR_NOOP("The camera keeps %1 at %2 instead of %3; check its mode dial."),
      QT_TR_NOOP("The camera has no setting %1."),
      QT_TR_NOOP("The camera reports: %1."),
      QT_TR_NOOP("The turntable has no zero switch."),
      QT_TR_NOOP("It did not answer while homing."),
      QT_TR_NOOP("It did not unlock."),
      QT_TR_NOOP("It did not answer the shutter command."),
      QT_TR_NOOP("The turntable does not answer."),
      QT_TR_NOOP("The turntable does not stop moving."),
      QT_TR_NOOP("The turntable does not accept its zero."),
      QT_TR_NOOP("The controller reset its count; the turntable's position is unknown."),
      QT_TR_NOOP("The turntable does not move."),
      QT_TR_NOOP("The turntable did not arrive in time; it was stopped."),
      QT_TR_NOOP("The shutter output must be M8, M7, M3 or M62 Pn."),
      QT_TR_NOOP("The turntable was stopped while moving and lost its position: align the zero "
                 "mark (ALARM:%1)."),
      QT_TR_NOOP("The turntable's controller reports a turn beyond its travel: switch $20 off "
                 "(ALARM:%1)."),
      QT_TR_NOOP("Homing failed: check the zero switch and its cable (ALARM:%1)."),
      QT_TR_NOOP("The turntable's controller raised an alarm (ALARM:%1)."),
      QT_TR_NOOP("The controller does not understand the command: wrong controller type or bad "
                 "cable (error:%1)."),
      QT_TR_NOOP("The turntable has no zero switch (error:%1)."),
      QT_TR_NOOP("The turntable is still moving (error:%1)."),
      QT_TR_NOOP("The turntable is locked: home it or unlock it (error:%1)."),
      QT_TR_NOOP("The turntable's controller rejected a command (error:%1)."),
      QT_TR_NOOP("Turn the turntable counter-clockwise to %1 degrees, then take your hand away."),
      QT_TR_NOOP("Not an Ostraka photograph list; choose another folder for the batch."),
      QT_TR_NOOP(
          "The turntable driver %1 is unknown; available: grbl, comxim1, comxim2, text, hand."),
      QT_TR_NOOP("The camera driver %1 is unknown; available: folder, gphoto2, uvc."),
      QT_TR_NOOP("The rig names no devices; 'ostraka devices' lists what is plugged in and how to "
                 "enter it in the rig."),
      QT_TR_NOOP("The rig names no camera."),
      QT_TR_NOOP("settle_s and speed_deg_s must be positive."),
      QT_TR_NOOP("The section 'devices' cannot be read; compare it with docs/devices.md."),
      QT_TR_NOOP("The number of positions must be between 3 and 99."),
      QT_TR_NOOP("The rig has no camera or no turntable."),
      QT_TR_NOOP(
          "There is no shot %1 to retake: this side has positions 1 to %2 and cameras A to %3."),
      QT_TR_NOOP("Camera %1 of this batch was %2, but the connected one is %3; continue with the "
                 "original cameras or choose another folder."),
      QT_TR_NOOP(
          "The turntable's position is unknown: turn its zero mark to the front and set zero."),
      QT_TR_NOOP("Camera %1, position %2 failed %3 times: %4."),
      QT_TR_NOOP("Camera %1 delivers only earlier or broken photographs; switch it off and on."),
      QT_TR_NOOP("The turntable does not answer as a %1; check its type."),
      QT_TR_NOOP("Marlin controller"),
      QT_TR_NOOP("text controller"),
      QT_TR_NOOP("This turntable has no zero switch: align it by eye."),
      QT_TR_NOOP("The turntable rejects the command: %1."),
      QT_TR_NOOP("The turntable is at %1 degrees instead of %2."),
      QT_TR_NOOP("The turntable's dialect: 'move' must contain {target} or {by}."),
      QT_TR_NOOP("The turntable's dialect: 'accepted' must describe its answer."),
      QT_TR_NOOP("The turntable's dialect: 'query' and 'position' must be given together."),
      QT_TR_NOOP("The turntable's dialect: 'reply_s' must be greater than 0."),
      QT_TR_NOOP("The turntable's dialect: '%1' is not a regular expression."),
      QT_TR_NOOP("The turntable's dialect: 'position' needs a group for the angle."),
      QT_TR_NOOP("The turntable's 'dialect' must be \"marlin\" or an object with its commands."),
      QT_TR_NOOP("The turntable is not plugged in."),
      QT_TR_NOOP("The turntable was unplugged."),
      QT_TR_NOOP("The turntable's USB connection failed (%1); plug it in again."),
      QT_TR_NOOP("You have no permission to use this USB device; install "
                 "packaging/udev/70-ostraka.rules and plug it in again."),
      QT_TR_NOOP("Another program uses the turntable; close that program."),
      QT_TR_NOOP("The turntable cannot be opened (%1)."),
      QT_TR_NOOP("This USB device is not a serial controller (CDC-ACM)."),
      QT_TR_NOOP("The turntable with this serial number is not plugged in."),
      QT_TR_NOOP("A USB turntable is named by vendor and product, for example usb:1209:0001."),
      QT_TR_NOOP("The video camera cannot be opened; check that it is plugged in and that no other "
                 "program uses it."),
      QT_TR_NOOP("The video camera cannot be opened."),
      QT_TR_NOOP("A video camera has exposure (0.1 ms), focus, white_balance (K) and gain, as "
                 "numbers; not %1 %2."),
      QT_TR_NOOP("The camera keeps %1 at %2 instead of %3."),
      QT_TR_NOOP("It is not open."),
      QT_TR_NOOP("The video camera no longer delivers pictures."),
      QT_TR_NOOP("The video camera took no picture."),
      QT_TR_NOOP(
          "The video camera delivers pictures of %1x%2 pixels instead of the configured size."),
      QT_TR_NOOP("The video camera must be named."),
      QT_TR_NOOP("the file is truncated or not a picture"),
      QT_TR_NOOP("the markers show an angle other than this position's"),
      QT_TR_NOOP("the picture's size differs from that of the camera's other pictures"),
      QT_TR_NOOP("too few markers are visible to identify the position: check that nothing covers "
                 "them and that the picture is sharp"),
      QT_TR_NOOP("the camera delivered an earlier photograph again"),
      QT_TR_NOOP("too few markers of the plate are visible: check that nothing covers them"),
      QT_TR_NOOP(
          "the picture is blurred: check that the turntable is still and the focus is unchanged"),
      QT_TR_NOOP("the sherds are too dark: add light or increase the exposure time"),
      QT_TR_NOOP("the sherds are overexposed: reduce the exposure time"),
      QT_TR_NOOP("a sherd is cut off by the picture's edge: move it or the camera"),
      QT_TR_NOOP("the camera's settings have changed: restore them"),
      QT_TR_NOOP("%1: restore it"),
  };
  return kAll;
}

}  // namespace ostraka::ui
