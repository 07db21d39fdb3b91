# What every test that drives the real window needs; source it with PROGRAM and FOLDER as the arguments. A display and a
# home of their own, the log, and the hands: press, tabs, wait_for, shot. Exit 77 means skipped, with the reason on
# standard output.
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
# Pose networks that scripts/fetch-models put into the user's own folder are still found.
if [ -z "${POSECOACH_MODELS:-}" ]; then
  models=${XDG_DATA_HOME:-$HOME/.local/share}/virtual-pose-coach/models
  [ -d "$models" ] && export POSECOACH_MODELS=$models
fi
export XDG_CONFIG_HOME=$home/config XDG_STATE_HOME=$home/state XDG_CACHE_HOME=$home/cache XDG_DATA_HOME=$home/data
export POSECOACH_LIBRARY=$home/films/swings
mkdir "$home/films"
# Nothing may be written here.
export HOME=$home/nobody
mkdir "$HOME"

log=$pictures/$(basename "$0" .sh).log
: > "$log"

also_shown=/dev/null  # a file that a failure shows beside the log

# A picture of the step; and no step has a socket of a network.
shot() {
  import -window root "$pictures/$1.png" 2> /dev/null
  local inode
  for inode in $(find "/proc/$window_program/fd" -lname "socket:*" -printf "%l\n" 2> /dev/null | tr -cd "0-9\n"); do
    if grep -qs " $inode " "/proc/$window_program/net/tcp" "/proc/$window_program/net/tcp6" \
      "/proc/$window_program/net/udp" "/proc/$window_program/net/udp6" "/proc/$window_program/net/raw"; then
      echo "FAILED: a network socket at step $1"
      exit 1
    fi
  done
}
fail() {
  echo "FAILED: $*"
  shot "$(basename "$0" .sh)_failed"
  cat "$log" "$also_shown"
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
press() { xdotool key --clearmodifiers "$@"; sleep 0.6; }
# tabs COUNT: so many places further.
tabs() { for _ in $(seq "$1"); do xdotool key --clearmodifiers Tab; sleep 0.25; done; sleep 0.4; }
is_shown() { xdotool search --name "Virtual Pose Coach"; }
# More than half of the live picture's upper part is the simulated student's blue sky.
has_picture() { [ "$(import -window root -crop 300x60+500+60 -resize 1x1! -depth 8 rgb:- | od -An -v -tx1 | tr -d " " | cut -c5-6)" \> "90" ]; }
# The window is there, has the keyboard, and the mouse is out of the way: nothing is pressed with it.
take_window() {
  wait_for 60 "window" is_shown
  xdotool search --name "Virtual Pose Coach" windowfocus 2> /dev/null
  xdotool mousemove 1279 719
}
# At its user's wish, and without an error.
quit_window() {
  press ctrl+q
  for _ in $(seq 100); do kill -0 "$window_program" 2> /dev/null || break; sleep 0.1; done
  kill -0 "$window_program" 2> /dev/null && fail "the program does not quit"
  wait "$window_program"
  local status=$?
  window_program=
  [ "$status" -eq 0 ] || fail "exit code $status"
  [ -z "$(find "$HOME" -type f)" ] || fail "files outside the XDG folders: $(find "$HOME" -type f)"
}
