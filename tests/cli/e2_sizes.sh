#!/usr/bin/env bash
# One pixel, and pictures of one row or one column.
source "$(dirname "$0")/lib.sh"
scene box.toml 1
for size in 1x1 100000x1 1x100000; do
  run 0 render box.toml --size $size -o $size.png
  [[ $(size_of $size.png) == "$size" ]] || fail "$size became $(size_of $size.png)"
done

# The largest is announced, not drawn here.
run 0 render box.toml --size 16384x16384 --dry-run
says out "1 frame of 16384x16384"
run 0 explain box.toml --size 16384x16384
says out "memory"
absent out
finish
