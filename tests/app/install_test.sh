#!/bin/sh
# What is installed starts from where it lies, and the desktop finds it: install_test.sh BUILD_FOLDER VERSION
set -eu
prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT
cmake --install "$1" --prefix "$prefix" >/dev/null
[ "$("$prefix/bin/posecoach" --version)" = "posecoach $2" ]
"$prefix/bin/posecoach-fetch-models" --help >/dev/null
entry=$prefix/share/applications/virtual-pose-coach.desktop
program=$(sed -n 's/^Exec=//p' "$entry")
icon=$(sed -n 's/^Icon=//p' "$entry")
[ -x "$prefix/bin/$program" ]
[ -f "$prefix/share/icons/hicolor/scalable/apps/$icon.svg" ]
desktop-file-validate "$entry"
