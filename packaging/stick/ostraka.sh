#!/bin/sh
# Ostraka on the stick: the window's settings lie with the projects and outlive the session.
if mountpoint -q /projects; then
  export XDG_CONFIG_HOME=/projects/.settings
  mkdir -p "$XDG_CONFIG_HOME"
  echo 'XDG_DOCUMENTS_DIR="/projects"' > "$XDG_CONFIG_HOME/user-dirs.dirs"
fi
exec PROGRAM "$@"
