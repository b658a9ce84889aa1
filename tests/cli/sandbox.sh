#!/usr/bin/env bash
# needs: formats/obj
# --sandbox: the kernel refuses what the command line does not name, also behind a link that --root is asked to allow.
source "$(dirname "$0")/lib.sh"
scene scene.toml 2
"$flatray" check scene.toml --sandbox > /dev/null 2> err.txt
case $? in
  5) grep -q 'it needs Landlock' err.txt && exit 77 ;;  # no such kernel: all there is to say is said
esac
mkdir -p in outside
mv scene.toml in
printf 'v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n' > outside/shape.obj
run 0 render in/scene.toml --sandbox -o out/####.png --quiet
run 0 render in/scene.toml -o plain/####.png --quiet
same out plain "in the sandbox"
run 0 render in/scene.toml --sandbox -o out/####.png --resume
says err "0 frames written, 2 kept"
run 0 render in/scene.toml --sandbox -f 1 -o - --quiet
cmp -s out.txt out/0001.png || fail "standard output differs"
run 0 convert in/scene.toml new/scene.toml --sandbox
exists new/scene.toml
run 0 compare out plain --sandbox --diff diff
run 0 experiment coverage "$root/scenes/chamber/hall.toml" --sandbox -o measured
run 0 orbit "$root/scenes/chamber/hall.toml" --sandbox

# A query names one file: the folder beside it is not there for it.
echo '{"op":"clip","polygon":[[0,0],[1,0],[0,1]],"origin":[-1,0.25],"direction":[1,0]}' > outside/questions
run 0 query outside/questions --sandbox
# Without the sandbox --root / lets the scene read all; in it, what the user gave away by --root stays open, and no more.
printf 'flatray = 1\n[[entity]]\nshape = { import = { file = "../outside/shape.obj" } }\n' > in/reads.toml
(cd in && run 0 check reads.toml --root / && exit "$failures") || fail "--root / refuses"
(cd in && run 0 check reads.toml --root / --sandbox && exit "$failures") || fail "--root / is not open in the sandbox"
# A place for output that is not named is made, and no other can be written.
ln -s "$work/outside" out/linked
run 6 render in/scene.toml --sandbox -o 'out/{scene}/../linked/####.png' --quiet
absent outside/0001.png
# What writes nothing makes no folder.
run 3 verify none --sandbox
says err 'none: error: is not there'
run 0 render in/scene.toml --sandbox --dry-run -o none/a/####.png
run 3 render in/none.toml --sandbox -o none/b/####.png
run 2 golden check --root none --sandbox
absent none
FLATRAY_SANDBOX=1 run 0 check in/scene.toml
finish
