#!/bin/bash
# Two cameras in the real window: another mode, another camera, one pulled out and plugged in again, all
# without a restart. Usage:
#   camera_change.sh PROGRAM FOLDER
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
if [ -z "${POSECOACH_MODELS:-}" ]; then
  models=${XDG_DATA_HOME:-$HOME/.local/share}/virtual-pose-coach/models
  [ -d "$models" ] && export POSECOACH_MODELS=$models
fi
export XDG_CONFIG_HOME=$home/config XDG_STATE_HOME=$home/state XDG_CACHE_HOME=$home/cache XDG_DATA_HOME=$home/data
export POSECOACH_LIBRARY=$home/swings

log=$pictures/cameras.log
"$program" "$home" > "$log" 2>&1 &
window_program=$!

shot() { import -window root "$pictures/$1.png" 2> /dev/null; }
fail() {
  echo "FAILED: $*"
  shot cameras_failed
  cat "$home/cameras" "$log"
  exit 1
}
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
press() { xdotool key --clearmodifiers "$@"; sleep 0.6; }
tabs() { for _ in $(seq "$1"); do xdotool key --clearmodifiers Tab; sleep 0.25; done; sleep 0.4; }
does() { grep -qx "$1" "$home/cameras"; }
# The simulated student's blue sky.
has_picture() { [ "$(import -window root -crop 300x60+500+60 -resize 1x1! -depth 8 rgb:- | od -An -v -tx1 | tr -d " " | cut -c5-6)" \> "90" ]; }

wait_for 60 "window" is_shown
xdotool search --name "Virtual Pose Coach" windowfocus 2> /dev/null
xdotool mousemove 1279 719
wait_for 60 "first camera" does "front 1280x720 MJPG"
wait_for 60 "picture" has_picture
shot cameras_1_live

click() { xdotool mousemove "$1" "$2"; sleep 0.4; xdotool click 1; sleep 0.4; }
# choose WHAT X Y...: presses the places one after the other until the cameras do that.
choose() {
  local what=$1 tries
  shift
  for tries in 1 2 3 4 5; do
    local places=("$@")
    while [ ${#places[@]} -gt 0 ]; do
      click "${places[0]}" "${places[1]}"
      places=("${places[@]:2}")
      sleep 1
    done
    for _ in $(seq 25); do does "$what" && return 0; sleep 0.2; done
    press Escape
  done
  fail "the cameras do not: $what"
}

# Set-up: the cameras are the rows of a list, the modes of the chosen one a list that unfolds below it.
press ctrl+4; sleep 2; shot cameras_2_set_up
choose "front 640x480 MJPG" 640 320 340 452
press ctrl+1; sleep 2; wait_for 60 "picture in another mode" has_picture
shot cameras_3_other_mode
press ctrl+4; sleep 2
choose "side 640x360 YUYV" 300 197
does "front not used" || fail "the first camera is still held"
press ctrl+1; sleep 2; wait_for 60 "picture of the other camera" has_picture
shot cameras_4_other_camera
press ctrl+4; sleep 2
choose "front 1280x720 MJPG" 300 141
press ctrl+1; sleep 2; wait_for 60 "picture of the first camera" has_picture

# Pulled out while it is used: said on the screen; plugged in at another place it is there again by itself.
touch "$home/unplugged"
wait_for 20 "unplugged camera" does "front gone"
sleep 2; shot cameras_5_gone
# Its message lies dark over the bright grass.
has_message() { [ "$(import -window root -crop 20x10+480+440 -resize 1x1! -depth 8 rgb:- | od -An -v -tx1 | tr -d " " | cut -c3-4)" \< "40" ]; }
has_no_message() { ! has_message; }
wait_for 20 "message over the picture" has_message
rm "$home/unplugged"
wait_for 60 "camera that is used again" does "front 1280x720 MJPG"
wait_for 60 "picture after it was plugged in" has_no_message
shot cameras_6_back

press ctrl+q
for _ in $(seq 100); do kill -0 "$window_program" 2> /dev/null || break; sleep 0.1; done
kill -0 "$window_program" 2> /dev/null && fail "the program does not quit"
wait "$window_program"
status=$?
window_program=
[ "$status" -eq 0 ] || fail "exit code $status"
echo "modes and cameras were changed without a restart; screenshots are in $pictures"
