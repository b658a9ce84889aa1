#!/usr/bin/env bash
# Flags win over FLATRAY_*, which wins over the scene.
source "$(dirname "$0")/lib.sh"
scene box.toml 1
run 0 render box.toml -o scene.png
[[ $(size_of scene.png) == 64x48 ]] || fail "scene: $(size_of scene.png)"
FLATRAY_SIZE=32x24 run 0 render box.toml -o env.png
[[ $(size_of env.png) == 32x24 ]] || fail "environment: $(size_of env.png)"
FLATRAY_SIZE=32x24 run 0 render box.toml -o flag.png --size 16x12
[[ $(size_of flag.png) == 16x12 ]] || fail "flag: $(size_of flag.png)"
FLATRAY_SIZE=0x4 run 2 render box.toml -o bad.png
says err "FLATRAY_SIZE: error: width 0"
FLATRAY_QUIET=1 run 0 render box.toml -o quiet.png
silent err
FLATRAY_QUIET=0 run 0 render box.toml -o loud.png
says err "1 frame written"
FLATRAY_QUIET=perhaps run 2 render box.toml -o bad.png
says err "neither yes nor no"

# No decimal comma, whatever the locale; no colours, no bar without a terminal.
env LC_ALL=de_DE.UTF-8 "$flatray" render box.toml -o de.png --quiet || fail "another locale"
cmp -s de.png scene.png || fail "the locale changed the picture"
scene long.toml 8
run 0 render long.toml --progress always
says err "100 %, 8 of 8 frames"
grep -q $'[\r\033]' err.txt && fail "a bar or colours without a terminal"
run 0 render long.toml
(($(wc -l < err.txt) == 1)) || fail "progress without a terminal"
finish
