#!/bin/bash
# Two cameras in the real window: another mode, another camera, one pulled out and plugged in again, all
# without a restart. Usage:
#   camera_change.sh PROGRAM FOLDER
# FOLDER gets a screenshot of each step. Exit 77 means skipped, with the reason on standard output.
set -u
. "$(dirname "$0")/driving.sh"

"$program" "$home" > "$log" 2>&1 &
window_program=$!
also_shown=$home/cameras
does() { grep -qx "$1" "$home/cameras"; }

take_window
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

quit_window
echo "modes and cameras were changed without a restart; screenshots are in $pictures"
