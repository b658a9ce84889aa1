#!/usr/bin/env bash
# Runs at once and one after another in one folder: no record is lost, nothing is mixed without a word, verify tells what is
# not as recorded.
source "$(dirname "$0")/lib.sh"
scene box.toml 24
run 0 render box.toml -o 'whole/f_####.png' --quiet
run 0 verify whole
says out "24 records, all as recorded"

# Four ranges at once: each frame has its record.
for _ in 1 2 3; do
  rm -rf four
  for range in 1..6 7..12 13..18 19..24; do "$flatray" render box.toml -o 'four/f_####.png' -f $range --quiet & done
  wait
  same whole four "four ranges at once"
  same_manifest whole four "four ranges at once"
done

# A second pattern and one cropped frame leave the records of the first; the crop is told, by verify, too.
run 0 render box.toml -o 'four/g_#.png' -f 1..3 --seed 7 --quiet
run 0 render box.toml -o 'four/f_####.png' --resume
says err "0 frames written, 24 kept"
run 0 render box.toml -o 'four/f_####.png' -f 2 --crop 0,0,10,10
says err "four/f_####.png: warning: 23 frames are of another scene or setting, as f_0001.png of 64x48, seed 0"
run 1 verify four
says out "four/f_####.png: frames are of 2 scenes or settings"
run 0 render box.toml -o 'four/f_####.png' --resume
says err "1 frame written, 23 kept"
run 0 verify four --json
grep -q '"records":27' out.txt || fail "not 27 records: $(cat out.txt)"

# Where nothing is to be done nothing is written.
before=$(find four -printf '%p %i %T@\n' | sort)
run 0 render box.toml -o 'four/f_####.png' --resume
[[ $(find four -printf '%p %i %T@\n' | sort) == "$before" ]] || fail "--resume with nothing to do wrote something"
chmod a-w four
if ((EUID != 0)); then
  run 0 render box.toml -o 'four/f_####.png' --resume
  run 6 render box.toml -o 'four/f_####.png' --seed 9
  says err "four/f_0001.png: error: cannot write: "
elif unshare -m true 2> /dev/null; then
  read_only='mount --bind four four && mount -o remount,ro,bind four && exec "$0" render box.toml -o four/f_####.png --resume --quiet'
  unshare -m sh -c "$read_only" "$flatray" || fail "--resume with nothing to do in a read-only folder"
  unshare -m sh -c "$read_only --seed 9" "$flatray" 2> err.txt && fail "wrote into a read-only folder"
  says err "four/f_0001.png: error: cannot write: "
fi
chmod u+w four

# Another seed, size or scene where a run is at work: refused, with what differs; --force ends the other.
# It must not come to its end before others come: a ray that is reflected often makes a minute of it, in memory too.
scene long.toml 40000 '[[chamber]]' 'shape = { box = { min = [0, 0], max = [16, 12] } }' \
  '[[ray]]' 'at = [9, 5]' 'direction = [1, 0.3]' 'bounces = 3000'
at_work() {
  "$flatray" render long.toml -o 'long/f_####.png' --seed 1 -j 1 2> first.txt &
  first=$!
  for _ in {1..500}; do [[ -s long/manifest.jsonl ]] && break; sleep 0.02; done
}
at_work
run 6 render long.toml -o 'long/f_####.png' -f 1..3 --seed 2
says err "long/f_####.png: error: another run is at work on it: its seed is 1, not 2"
run 6 render long.toml -o 'long/f_####.png' -f 3 --size 32x24 --resume
says err 'its size is "64x48", not "32x24"'
run 0 render long.toml -o 'long/g_####.png' -f 1..3 --seed 2
run 0 render long.toml -o 'long/f_####.png' -f 1..3 --seed 1
run 0 render long.toml -o 'long/f_####.png' -f 1..4000:400 --seed 2 --force --quiet
wait $first
code=$?
((code == 6)) || fail "a run whose claim was taken ended with exit code $code"
grep -q "another run goes on here" first.txt || fail "it did not say why"
run 1 verify long
(($(grep -c 'long/' out.txt) == 1)) || fail "more than the mixture: $(cat out.txt)"

# A killed run leaves what the next one clears away; its claim holds nobody up.
rm -rf long
at_work
kill -9 $first
wait $first 2> /dev/null
run 1 verify long
says out "was left by a run that was killed"
run 0 render long.toml -o 'long/f_####.png' -f 1..5 --seed 2 --quiet
[[ -z $(find long -name '.*') ]] || fail "left: $(find long -name '.*')"

# Whatever is planted: told, and neither followed nor waited for.
tampered() {  # tampered TEXT: verify says so, and --resume gives the bytes
  run 1 verify four
  says out "$1"
  run 0 render box.toml -o 'four/f_####.png' --resume --quiet
  same_frames
  run 0 verify four
}
same_frames() { for file in whole/*.png; do cmp -s "$file" "four/${file##*/}" || fail "${file##*/} differs"; done; }
rm four/f_0003.png
tampered "four/f_0003.png: is missing"
truncate -s -1 four/f_0004.png
tampered "four/f_0004.png: differs from its record"
mv four/f_0004.png elsewhere.png && ln -s ../elsewhere.png four/f_0004.png
run 1 verify four
says out "four/f_0004.png: is a link"
rm four/f_0004.png && mv elsewhere.png four/f_0004.png
sed -i '/f_0005/d' four/manifest.jsonl
tampered "four/f_0005.png: has no record"
truncate -s -20 four/manifest.jsonl
tampered "four/manifest.jsonl: ends within a line"
echo '{"frame":' >> four/manifest.jsonl
rm four/f_0006.png
tampered "is no record"
cp four/f_0007.png '.copy'
mv .copy "four/.f_0007.png.0123456789abcdef.part"
rm four/f_0008.png
tampered "was left by a run that was killed"
for plant in 'ln -s ../whole/f_0001.png' mkfifo; do
  for file in f_0001.png manifest.jsonl; do
    mv "four/$file" kept
    $plant "four/$file"
    timeout 20 "$flatray" verify four > /dev/null 2>&1
    (($? == 1)) || fail "verify, $plant $file"
    timeout 20 "$flatray" render box.toml -o 'four/f_####.png' --resume > out.txt 2> err.txt
    (($? == 6)) || fail "--resume, $plant $file"
    says err "four/$file: error: is "
    rm "four/$file"
    mv kept "four/$file"
  done
done
same_frames
# The number of the frame is told from others in a name, and is of any width.
for version in 1 2; do run 0 render box.toml -o "named/####_v$version.png" -f 1..3 --seed $version --quiet; done
run 0 verify named
cp named/0001_v1.png named/0009_v1.png
run 1 verify named
says out "named/0009_v1.png: has no record"
scene wide.toml 10002
run 0 render wide.toml -o 'wide/f_####.png' -f 9998..9999 --seed 1 --quiet
run 0 render wide.toml -o 'wide/f_####.png' -f 10000..10002 --seed 2 --quiet
run 1 verify wide
says out "frames are of 2 scenes or settings"

run 3 verify .
says err 'holds no records'
run 3 verify nowhere
says err 'nowhere: error: is not there'
run 3 verify box.toml
says err 'is no folder'

# Several runs, killed and tampered with, as tools/check-shared-folder does a hundred times.
"$root/tools/check-shared-folder" box.toml "$flatray" 2 || fail "schedules"
finish
