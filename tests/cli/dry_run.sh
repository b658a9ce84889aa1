#!/usr/bin/env bash
# --dry-run says what would be written and writes nothing.
source "$(dirname "$0")/lib.sh"
scene box.toml 5
run 0 render box.toml --dry-run
says out "box: 5 frames of 64x48, 0 kept"
says out "out/box/frame_0005.png"
absent out
run 0 render box.toml --dry-run --json --shard 1/2 --size 8x8
says out '"files":["out/box/frame_0002.png","out/box/frame_0004.png"]'
says out '"width":8,"height":8'
says out '"schema":"flatray.render/1"'
absent out
run 0 render box.toml -f 1..3
run 0 render box.toml --dry-run --resume
says out "2 frames of 64x48, 3 kept"
(($(ls out/box/*.png | wc -l) == 3)) || fail "a dry run wrote"
# A frame of a sequence has its number, and so have several of what has one.
run 0 render box.toml --dry-run --json -f 3
says out '"files":["out/box/frame_0003.png"]'
scene still.toml 1
run 0 render still.toml --dry-run --json -f 2..3
says out '"files":["out/still/frame_0002.png","out/still/frame_0003.png"]'
run 0 render still.toml --dry-run --json
says out '"files":["out/still.png"]'
finish
