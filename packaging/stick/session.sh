#!/bin/sh
# What the person at the stick sees: the window, and behind it the projects, printers and the switch.
kernel_option() { sed -n "s/.*ostraka\.$1=\([^ ]*\).*/\1/p" /proc/cmdline; }
LANG=$(kernel_option language).UTF-8
export LANG
layout=$(kernel_option keyboard)
setxkbmap -layout "${layout:-us}" -option grp:alt_shift_toggle
xset s off -dpms  # a long day of photographs is no reason to turn the screen off

if ! mountpoint -q /projects; then
  xterm -fa Monospace -fs 14 -e sh -c 'echo "The space for projects on this stick could not be opened."
    echo "What you save now is lost when the computer is switched off."
    echo; systemctl status --no-pager ostraka-projects; read -r answer' &
fi
lxpolkit &
pcmanfm --desktop &
(cd /projects && exec ostraka) &
exec openbox
