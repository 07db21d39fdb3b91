#!/bin/bash
# The window as a user drives it: on a display of its own, by keyboard only. Usage:
#   window_end_to_end.sh PROGRAM FOLDER
# FOLDER gets a screenshot of each step. Exit 77 means skipped, with the reason on standard output.
set -u
. "$(dirname "$0")/driving.sh"

"$program" simulate --motion swing -o "$home/films/film.mp4" > "$log" 2>&1 || { cat "$log"; exit 1; }
start() {
  "$program" live --source simulated:swing >> "$log" 2>&1 &
  window_program=$!
}
start

swings() { find "$POSECOACH_LIBRARY" -path "*/Trash" -prune -o -path "*/.unfinished" -prune -o -name swing.json -print 2> /dev/null | wc -l; }
has_swings() { [ "$(swings)" -ge "$1" ]; }
settings=$XDG_CONFIG_HOME/virtual-pose-coach/settings.json
# The file of that name of the one kept swing.
of_swing() { find "$POSECOACH_LIBRARY" -path "*/Trash" -prune -o -path "*/.unfinished" -prune -o -name "$1" -print 2> /dev/null | head -1; }
has_words() { grep -q "$2" "$(of_swing "$1")"; }
has_no_words() { [ -n "$(of_swing "$1")" ] && ! grep -q "$2" "$(of_swing "$1")"; }

take_window
wait_for 60 "picture" has_picture
shot 01_live

# The sheet of keys, and another second key for it: the last place of the sheet is "Change keys".
press F1; sleep 1; shot 02_keys
press shift+Tab; press Return; shot 03_change_keys
tabs 3; press Return; press F2
has_key() { grep -q '"keys": "F1 F2"' "$settings"; }
wait_for 20 "changed key in the settings" has_key
press Escape; press F2; shot 04_keys_changed; press Escape

press ctrl+4; shot 05_set_up

# A film is imported: the button is the ninth place, the film the second entry of the dialog, a second Enter takes it.
press ctrl+3
tabs 9; press Return; sleep 1; shot 06_import
press Down; press Return; press Return
wait_for 240 "imported swing" has_swings 1
wait_for 240 "answer to it" has_words analysis.json '"events"'
sleep 3; shot 07_imported
# Two places on is its card; opened from its files: the play button is there, bright.
is_review() { [ "$(import -window root -crop 12x4+184+446 -resize 1x1! -depth 8 rgb:- | od -An -v -tx1 | tr -d " " | cut -c5-6)" \> "d0" ]; }
tabs 2; press Return
wait_for 120 "opened swing" is_review
shot 08_opened
press 1; press Right; press Right; press period; shot 09_stepped
press d; press e; press ctrl+plus; shot 10_from_the_side
press ctrl+0; press x; press x; sleep 1; shot 10_film_alone
press x; press z; press space; sleep 1; press space

# A position put in its place by hand is stored beside the film and analysed anew; taken back, it is as found.
press 4; press ctrl+shift+Right
wait_for 60 "moved position" has_words marks.json '"top"'
wait_for 20 "new analysis" has_words analysis.json "moved by hand"
sleep 1; shot 11_moved
press ctrl+z
wait_for 60 "position as it was found" has_no_words marks.json '"top"'
wait_for 20 "the first analysis" has_no_words analysis.json "moved by hand"
# A line and a key picture.
press n; press Left; press Return
for _ in 1 2 3 4 5 6; do xdotool key Down; sleep 0.1; done
press Return; press Insert
wait_for 60 "stored line" has_words marks.json '"line"'
sleep 1; shot 12_drawn
# The films on disk are as they were recorded.
"$program" library verify > "$pictures/verify.log" 2>&1 || fail "the library is not as it was stored"

# Export: its list is the sixth place, the report its third entry.
tabs 6; press Return; shot 13_export
press Down; press Down; press Return
has_report() { ls "$POSECOACH_LIBRARY"/Exports/*.html; }
wait_for 120 "exported report" has_report
shot 14_exported
# Hands-free: the swing is found, answered, kept, and reviewed at a key.
press ctrl+1
press h; sleep 1; shot 15_armed
wait_for 240 "kept swing" has_swings 2
sleep 1; shot 16_answer
press Return; sleep 3; shot 17_review
# Beside the imported one, which is the last in the library.
press F8; press Right; press Right
xdotool key Return; sleep 6; shot 17_side_by_side
press F9; sleep 1; shot 17_in_one
press ctrl+1; press Escape; press h

# Another coach: below the rail, the camera and the person.
press ctrl+4
tabs 19; shot 18_coach_ringed
press Return
has_coach() { grep -rq '"bundled:putt"' "$XDG_DATA_HOME"/virtual-pose-coach/people; }
wait_for 20 "chosen coach" has_coach
shot 19_coach

# Killed while it records: the next start offers what is left, and Enter keeps it.
press ctrl+1; press r
is_filming() { [ "$(stat -c %s "$POSECOACH_LIBRARY"/.unfinished/swing_*/film.mkv 2> /dev/null || echo 0)" -gt 100000 ]; }
wait_for 60 "recording" is_filming
shot 20_recording
before=$(swings)
kill -KILL "$window_program"
wait "$window_program" 2> /dev/null
start
take_window
sleep 4; shot 21_left_over
[ "$(swings)" -eq "$before" ] || fail "what was left over was kept without being asked for"
is_recovered() { xdotool key Return; [ "$(swings)" -gt "$before" ]; }
wait_for 60 "recovered recording" is_recovered
sleep 1; shot 22_recovered
press ctrl+3; sleep 1; shot 23_library

quit_window
echo "the whole loop was driven by keyboard; screenshots are in $pictures"
