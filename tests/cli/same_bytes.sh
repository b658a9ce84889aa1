#!/usr/bin/env bash
# The same bytes for any number of threads, any shards, one frame alone, any order of options.
source "$(dirname "$0")/lib.sh"
scene box.toml 13
run 0 render box.toml -o 'one/f_####.png' -j 1
run 0 render -o 'two/f_####.png' --quiet -j 2 box.toml
same one two "-j 2"
same_manifest one two "-j 2"
for i in 2 0 1; do run 0 render box.toml --shard $i/3 -o 'shards/f_####.png'; done
same one shards "shards"
same_manifest one shards "shards"
exists shards/manifest.{0,1,2}-of-3.jsonl
(($(ls shards/*.png | wc -l) == 13)) || fail "shards made $(ls shards/*.png | wc -l) frames"

# What shards made need not be made again by a run of all, nor by other shards; what is not whole is.
rm shards/f_0004.png
run 0 render box.toml --resume -o 'shards/f_####.png' --json
[[ $(grep -c '"pixels"' out.txt) == 1 ]] || fail "resumed after shards: $(grep -c '"pixels"' out.txt) made, not 1"
[[ $(sort shards/manifest.jsonl) == "$(sort one/manifest.jsonl)" ]] || fail "the manifest of all is not that of the whole run"
same one shards "resumed after shards"

run 0 render box.toml -f 7 -o 'alone/f_####.png'
cmp -s alone/f_0007.png one/f_0007.png || fail "frame 7 alone differs"
run 0 render box.toml -f 7 -o - > /dev/null
"$flatray" render box.toml -f 7 -o - | cmp -s - one/f_0007.png || fail "standard output differs"
run 0 render box.toml -o 'keep/f_####.png' --keep-all
same one keep "--keep-all"
cat box.toml | "$flatray" render - -o 'stdin/f_####.png' --quiet 2> err.txt || fail "scene from standard input"
same one stdin "scene from standard input"
for isa in $("$flatray" list isas | awk '{ print $1 }'); do
  FLATRAY_ISA=$isa run 0 render box.toml -o "$isa/f_####.png"
  same one "$isa" "FLATRAY_ISA=$isa"
done

# A scene of one frame shows more of them where they are asked for, each as when asked for alone.
run 0 render box.toml -D frames=1 -f 1..13 -o 'asked/f_####.png'
same one asked "frames beyond the scene's last"
run 0 render box.toml -D frames=1 -f 7 -o 'asked_alone/f_####.png'
cmp -s asked_alone/f_0007.png one/f_0007.png || fail "frame 7 alone of a scene of one frame differs"

# A crop is a part of the whole: its pixels, not its bytes; cut into quarters it has as many rows and columns.
run 0 render box.toml -f 7 --crop 10,20,40,48 -o crop.png
[[ $(size_of crop.png) == 30x28 ]] || fail "crop of $(size_of crop.png)"

# A scene in which nothing moves: every frame is the same file.
printf 'flatray = 1\nframes = 5\nfilm = { size = [20, 10] }\n' > still.toml
run 0 render still.toml -o 'still/f_#.png'
(($(sha256sum still/*.png | cut -d' ' -f1 | sort -u | wc -l) == 1)) || fail "still frames differ"
(($(wc -l < still/manifest.jsonl) == 5)) || fail "still frames lack their lines"
finish
