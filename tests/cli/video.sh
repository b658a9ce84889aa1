#!/usr/bin/env bash
# needs: pictures/y4m pictures/mp4 shapes/box
# All frames in one file: whole or not there, the same whatever draws it, on standard output as in a file; by ffmpeg, which a
# script stands for here, and its failures.
source "$(dirname "$0")/lib.sh"
scene box.toml 30

# A header, and each frame as a line and three planes.
run 0 render box.toml -o box.y4m --quiet
[[ $(head -1 box.y4m) == "YUV4MPEG2 W64 H48 F24:1 Ip A1:1 C444 XCOLORRANGE=LIMITED" ]] || fail "header: $(head -1 box.y4m)"
header=$(head -1 box.y4m | wc -c)
(($(stat -c %s box.y4m) == header + 30 * (6 + 3 * 64 * 48))) || fail "size: $(stat -c %s box.y4m)"
# A frame is that of the picture alone: the box is at another place in each.
run 0 render box.toml -f 17 -o one.y4m --quiet
tail -c $((3 * 64 * 48)) one.y4m > one.frame
tail -c +$((header + 16 * (6 + 3 * 64 * 48) + 7)) box.y4m | head -c $((3 * 64 * 48)) | cmp -s - one.frame || fail "frame 17 differs"
for jobs in 1 2 3 7; do
  run 0 render box.toml -o again.y4m -j $jobs --quiet
  cmp -s box.y4m again.y4m || fail "-j $jobs: other bytes"
done
run 0 render box.toml -o - --format y4m -j 2
cmp -s box.y4m out.txt || fail "standard output has other bytes"
run 0 render box.toml -f 1..3 --format y4m --quiet
exists out/box.y4m
run 0 render box.toml -o box.y4m --json
says out '"frame":30'
run 0 render box.toml -o box.y4m --dry-run
[[ $(grep -c y4m out.txt) == 1 ]] || fail "--dry-run names the file $(grep -c y4m out.txt) times"
scene still.toml 30
sed -i 's/^velocity.*//; s/^angular.*//' still.toml
run 0 render still.toml -o still.y4m --quiet
(($(stat -c %s still.y4m) == header + 30 * (6 + 3 * 64 * 48))) || fail "a still video has $(stat -c %s still.y4m) bytes"

# What makes no sense of one file.
refused() {  # refused TEXT ARGS...
  local text=$1
  shift
  run 2 "$@"
  says err "$text"
  absent x.y4m x.mp4 x_0001.y4m
}
refused "does not go with a .y4m" render box.toml -o x.y4m --resume
refused "does not go with a .y4m" render box.toml -o x.y4m --shard 0/2
refused "a .y4m holds all frames" render box.toml -o 'x_####.y4m'
refused "a .mp4 is made by ffmpeg" render box.toml -o - --format mp4
refused "or say --format y4m" render box.toml -o -
refused "standard output is taken" render box.toml -o - --format y4m --json

# Standard output that takes nothing.
"$flatray" render box.toml -o - --format y4m > /dev/full 2> err.txt
[[ $? == 6 ]] || fail "a full disk: another exit code"
says err "standard output: error: cannot write: No space left on device"
"$flatray" render box.toml -o - --format y4m 2> err.txt | head -c 100 > head.txt
[[ ${PIPESTATUS[0]} == 6 ]] || fail "a closed pipe: exit code ${PIPESTATUS[0]}"
says err "the program that reads it has ended"
env --default-signal=PIPE "$flatray" render box.toml -f 1 -o - --format hdr --size 1000x1000 2> err.txt | head -c 100 > head.txt
[[ ${PIPESTATUS[0]} == 6 ]] || fail "a closed pipe behind one picture: exit code ${PIPESTATUS[0]}"
"$flatray" render box.toml -f 1 -o - > /dev/full 2> err.txt
[[ $? == 6 ]] || fail "a full disk: another exit code"
says err "standard output: error: cannot write: No space left on device"

# Whether the stand-in of ffmpeg.pid runs: one that ended stays, dead, where the first process of a container waits for
# none.
runs() {
  local pid state
  pid=$(cat ffmpeg.pid) || return 1
  state=$(sed 's/.*) //; s/ .*//' "/proc/$pid/stat" 2> /dev/null) && [[ -n $state && $state != Z ]]
}

# fake SCRIPT: what runs as ffmpeg from here on; it knows the file by its last argument.
mkdir bin
system=$PATH
fake() {
  printf '#!/bin/bash\nfor file; do :; done\n%s\n' "$1" > bin/ffmpeg
  chmod +x bin/ffmpeg
  PATH=$work/bin:$system
}
nothing_left() { [[ -z $(find . -name '*.mp4' -o -name '.*.part') ]] || fail "$1: left $(find . -name '*.mp4' -o -name '.*.part')"; }
fake 'cat > "$file"'
run 0 render box.toml -o box.mp4 --quiet
cmp -s box.y4m box.mp4 || fail "ffmpeg is fed other bytes"
rm box.mp4
fake 'head -c 1000 > "$file"; echo hello; echo "Unknown encoder" >&2; exit 3'
run 6 render box.toml -o box.mp4
says err "box.mp4: error: ffmpeg ended with exit code 3"
says err "it said: Unknown encoder"
nothing_left "a failure"
fake 'cat > "$file"; exit 1'
run 6 render box.toml -o box.mp4
says err "ffmpeg ended with exit code 1"
nothing_left "a failure at the end"
fake 'kill -9 $$'
run 6 render box.toml -o box.mp4
says err "ffmpeg was ended by signal 9"
nothing_left "a crash"
fake 'exec 0<&-; exit 0'
run 6 render box.toml --size 640x480 -o box.mp4
says err "has read but a part"
nothing_left "too early an end"
# Of another kind, and so kept.
cp box.toml kept.mp4
run 6 render box.toml -o kept.mp4
cmp -s box.toml kept.mp4 || fail "a text was replaced"
rm kept.mp4

# Ctrl-C: while ffmpeg takes its time nothing stays, and no ffmpeg either.
fake 'echo $$ > ffmpeg.pid; cat > "$file"; exec sleep 60'
env --default-signal=INT "$flatray" render box.toml -o box.mp4 2> err.txt &
pid=$!
for _ in {1..200}; do
  [[ -s ffmpeg.pid ]] && break
  sleep 0.02
done
sleep 0.5
kill -INT $pid
wait $pid
code=$?
((code == 130)) || fail "SIGINT: exit code $code"
says err "interrupted, 0 of 30 frames written"
nothing_left "SIGINT"
runs && fail "ffmpeg still runs"
fake 'echo $$ > ffmpeg.pid; head -c 100000 > "$file"; sleep 0.2; cat >> "$file"'
scene long.toml 100000
env --default-signal=INT "$flatray" render long.toml -o box.mp4 -j 2 2> err.txt &
pid=$!
sleep 1
kill -INT $pid
wait $pid
code=$?
((code == 130)) || fail "SIGINT: exit code $code"
says err "interrupted, 0 of 100000 frames written"
grep -q resume err.txt && fail "--resume does not go on: $(cat err.txt)"
nothing_left "SIGINT while drawing"
runs && fail "ffmpeg still runs"

# Where it is not installed.

# It ends well and has written nothing, or says that it could not: so it is on a full disk.
fake 'cat > /dev/null'
run 6 render box.toml -f 1..3 -o full.mp4
says err "it wrote nothing"
fake 'cat > "$file"; echo "No space left on device" >&2'
run 6 render box.toml -f 1..3 -o full.mp4
says err "it said: No space left on device"
nothing_left "on a full disk"
# One that never reads does not outlive a forced end.
fake 'echo $$ > ffmpeg.pid; exec sleep 600'
timeout -s INT 1 "$flatray" render box.toml -f 1..3 --size 2000x2000 -o never.mp4 2> /dev/null && fail "was not stopped"
for ((i = 0; i < 50; i++)); do runs || break; sleep 0.1; done
runs && fail "ffmpeg that never reads still runs"
run 0 render box.toml -f 1..3 -o frames.apng --quiet
run 4 compare frames.apng frames.apng
says err "is an animated PNG of 3 frames"

# Started with signals of children ignored, or without the three standard files, as some daemons do.
fake 'cat > "$file"'
env --ignore-signal=CHLD "$flatray" render box.toml -f 1..3 -o child.mp4 -q --force || fail "a child's end is not heard"
timeout 60 "$flatray" render box.toml -f 1..3 -o closed.mp4 <&- >&- 2>&- || fail "without standard files"
cmp -s child.mp4 closed.mp4 || fail "standard files are written into the video"
rm child.mp4 closed.mp4
rm bin/ffmpeg
for tool in bash cat grep sed find head mktemp; do ln -sf "$(PATH=$system command -v $tool)" bin/$tool; done
PATH=$work/bin
run 5 render box.toml -o box.mp4
PATH=$system
says err "ffmpeg cannot be started: No such file or directory"
says err "apt install ffmpeg"
nothing_left "without ffmpeg"

# verify has nothing to say of videos.
run 0 render box.toml -f 1..2 -o 'frames/####.png' --quiet
run 0 render box.toml -o frames/0003.y4m --quiet
run 0 verify frames
finish
