#!/usr/bin/env bash
# Killed at any moment, a full disk, a folder that cannot be written, two runs at once: every file with a final name is
# whole, and the resumed sequence is that of an unbroken run.
source "$(dirname "$0")/lib.sh"
scene box.toml 60
run 0 render box.toml -o 'whole/f_####.png' --quiet

# Killed at ten moments; .ci/run nightly has a thousand.
"$root/tools/check-crash-safety" box.toml "$flatray" 10 || fail "killed"

# Disk full: the limit is on a file's size, in blocks of 1024 bytes. Nothing with a final name is broken.
scene large.toml 4 'stroke = { width = 0.01, colour = "#000000" }'
(
  ulimit -f 1
  "$flatray" render large.toml --size 3000x2000 -o 'full/f_####.png' > out.txt 2> err.txt
  echo $? > code.txt
)
[[ $(cat code.txt) == 6 ]] || fail "full disk: exit code $(cat code.txt)"
says err "cannot write"
absent full/f_0001.png
[[ -z $(find full -name '.*.part') ]] || fail "a temporary file stayed"

# A disk that is full for the user root as well, where one can be had: what fits is whole, and with room the rest follows.
mkdir disk
if mount -t tmpfs -o size=96k tmpfs disk 2> /dev/null; then
  run 0 render large.toml --size 400x300 -o 'fits/f_####.png' --quiet
  head -c 200000 /dev/zero > disk/filling 2> /dev/null
  truncate -s -12288 disk/filling  # three pages of memory: less than four pictures and a manifest
  run 6 render large.toml --size 400x300 -o 'disk/f_####.png' --quiet
  says err "No space left on device"
  for file in disk/*.png; do
    [[ ! -e $file ]] || cmp -s "$file" "fits/${file##*/}" || fail "not whole on a full disk: $file"
  done
  [[ -z $(find disk -name '.*.part') ]] || fail "a temporary file stayed on a full disk"
  rm disk/filling
  mount -o remount,size=4m disk
  run 0 render large.toml --size 400x300 -o 'disk/f_####.png' --resume --quiet
  same fits disk "resumed with room"
  same_manifest fits disk "resumed with room"
  umount disk
else
  echo "no tmpfs can be mounted here: a full disk is tried by file size only"
fi

# Folders that cannot be.
run 6 render box.toml -o 'box.toml/f_####.png'
run 6 render box.toml -o '/proc/flatray/f_####.png'
says err "cannot"
if ((EUID != 0)); then
  mkdir read_only
  chmod a-w read_only
  run 6 render box.toml -o 'read_only/f_####.png'
  says err "Permission denied"
fi

# Two runs into one folder.
"$flatray" render box.toml -o 'both/f_####.png' --quiet &
"$flatray" render box.toml -o 'both/f_####.png' --quiet
wait
same whole both "two runs at once"
finish
