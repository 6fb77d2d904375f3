#!/bin/sh
# Runs a test of the window on a virtual screen with a window manager, as a person's desktop has one:
# without a manager no window ever becomes active. Software rendering, so that no graphics card counts.
set -eu
export XDG_RUNTIME_DIR="${XDG_RUNTIME_DIR:-$(mktemp -d)}"
export LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb
# The first run computes a whole batch; on a busy machine Qt's five minutes are too few for that.
export QTEST_FUNCTION_TIMEOUT=1500000
# shellcheck disable=SC2016  # the inner shell is to put them in
exec xvfb-run -a -s "-screen 0 1280x800x24 +extension GLX" sh -c 'openbox & manager=$!
  "$@"; status=$?
  kill $manager 2>/dev/null
  exit $status' sh "$@"
