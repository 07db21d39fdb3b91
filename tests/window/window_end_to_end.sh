#!/bin/bash
# The window as a user drives it: on a display of its own, with keys and a mouse. Usage:
#   window_end_to_end.sh PROGRAM FOLDER
# FOLDER gets a screenshot of each step. Exit 77 means skipped, with the reason on standard output.
set -u
program=$1
pictures=$2

for tool in Xvfb xdotool import; do
  command -v "$tool" > /dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done

mkdir -p "$pictures"
home=$(mktemp -d)
xvfb=
window_program=
clean_up() {
  [ -n "$window_program" ] && kill "$window_program" 2> /dev/null
  [ -n "$xvfb" ] && kill "$xvfb" 2> /dev/null
  rm -rf "$home"
}
trap clean_up EXIT

Xvfb -displayfd 3 -screen 0 1280x720x24 -nolisten tcp 3> "$home/display" 2> /dev/null &
xvfb=$!
for _ in $(seq 100); do [ -s "$home/display" ] && break; sleep 0.1; done
[ -s "$home/display" ] || { echo "skipped: Xvfb does not start"; exit 77; }
export DISPLAY=:$(cat "$home/display")
export XDG_CONFIG_HOME=$home/config XDG_STATE_HOME=$home/state XDG_CACHE_HOME=$home/cache
# Pose networks that scripts/fetch-models put into the user's own folder are still found.
if [ -z "${POSECOACH_MODELS:-}" ]; then
  models=${XDG_DATA_HOME:-$HOME/.local/share}/virtual-pose-coach/models
  [ -d "$models" ] && export POSECOACH_MODELS=$models
fi
export XDG_DATA_HOME=$home/data POSECOACH_LIBRARY=$home/swings

log=$pictures/program.log
"$program" live --source simulated:swing > "$log" 2>&1 &
window_program=$!

fail() {
  echo "FAILED: $*"
  shot failed
  cat "$log"
  exit 1
}
shot() { import -window root "$pictures/$1.png" 2> /dev/null; }
# wait_for SECONDS WHAT COMMAND...: until the command succeeds.
wait_for() {
  local seconds=$1 what=$2
  shift 2
  for _ in $(seq $((seconds * 5))); do
    "$@" > /dev/null 2>&1 && return 0
    if ! kill -0 "$window_program" 2> /dev/null; then
      grep -q "network\|model" "$log" && { echo "skipped: $(tail -1 "$log")"; exit 77; }
      fail "the program ended while waiting for $what"
    fi
    sleep 0.2
  done
  fail "no $what within $seconds s"
}
is_shown() { xdotool search --name "Virtual Pose Coach"; }
# More than half of the live picture's upper part is the simulated student's blue sky.
has_picture() { [ "$(import -window root -crop 300x60+500+60 -resize 1x1! -depth 8 rgb:- | od -An -v -tx1 | tr -d " " | cut -c5-6)" \> "90" ]; }
swings() { find "$POSECOACH_LIBRARY" -path "*/Trash" -prune -o -name swing.json -print 2> /dev/null | wc -l; }
has_swing() { [ "$(swings)" -ge 1 ]; }
press() { xdotool key --clearmodifiers "$@"; sleep 0.6; }

wait_for 60 "window" is_shown
xdotool search --name "Virtual Pose Coach" windowfocus 2> /dev/null
xdotool mousemove 640 400
wait_for 60 "picture" has_picture
shot 01_live

press F1; shot 02_keys; press Escape
press ctrl+4; shot 03_set_up
press ctrl+1
press h; sleep 1; shot 04_armed
wait_for 240 "kept swing" has_swing
sleep 1; shot 05_answer
press Return; sleep 2
shot 06_review
press Right; press Right; press period; shot 07_stepped
press d; shot 08_from_the_side
press space; sleep 1; press space
# No further swings while this one is looked at.
press ctrl+1; press Escape; press h; press ctrl+3; sleep 1; shot 09_library
# The kept swing, opened from its files: the play button is there again, bright.
press Right; press Return
is_review() { [ "$(import -window root -crop 12x4+184+446 -resize 1x1! -depth 8 rgb:- | od -An -v -tx1 | tr -d " " | cut -c5-6)" \> "d0" ]; }
wait_for 120 "opened swing" is_review
shot 10_opened
# Export: the report page, by the mouse.
xdotool mousemove 1206 30 click 1; sleep 1; shot 11_export
xdotool mousemove 1180 130 click 1
has_report() { ls "$POSECOACH_LIBRARY"/Exports/*.html; }
wait_for 120 "exported report" has_report
shot 12_exported
# Another coach.
press ctrl+4; sleep 1
xdotool mousemove 960 197 click 1; sleep 1; shot 13_coach
press ctrl+q
for _ in $(seq 100); do kill -0 "$window_program" 2> /dev/null || break; sleep 0.1; done
kill -0 "$window_program" 2> /dev/null && fail "the program does not quit"
wait "$window_program"
status=$?
window_program=
[ "$status" -eq 0 ] || fail "exit code $status"
echo "the whole loop was driven; screenshots are in $pictures"
