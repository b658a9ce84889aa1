#!/usr/bin/env bash
# What was rendered from another scene, or otherwise, is not kept.
source "$(dirname "$0")/lib.sh"
scene box.toml 6
run 0 render box.toml -o 'out/f_####.png'
stamp() { stat -c %Y.%i out/f_0003.png; }

before=$(stamp)
run 0 render box.toml -o 'out/f_####.png' --resume
[[ $(stamp) == "$before" ]] || fail "the same scene was rendered again"
says err "6 kept"

changed() {  # changed WHAT ARGS...
  local what=$1
  shift
  before=$(stamp)
  run 0 render "$@" -o 'out/f_####.png' --resume
  [[ $(stamp) != "$before" ]] || fail "stale frames were kept: $what"
}
changed "another size" box.toml --size 32x24
changed "another seed" box.toml --seed 5
changed "an override" box.toml -D 'film.background="#000000"'
changed "a crop" box.toml --crop 0,0,10,10
sed -i 's/c0392b/c0392c/' box.toml
changed "another colour" box.toml
run 0 render box.toml -o 'fresh/f_####.png'
same out fresh "after the changes"
same_manifest out fresh "after the changes"

# A frame that is not what its record says is made again.
truncate -s -1 out/f_0002.png
echo garbage > out/f_0003.png
rm out/f_0004.png
cp out/f_0006.png out/f_0005.png
run 0 render box.toml -o 'out/f_####.png' --resume
says err "4 frames written, 2 kept"
same out fresh "damaged and resumed"

# A torn last line of the manifest, and garbage in it, cost at most their frames.
truncate -s -30 out/manifest.jsonl
echo '{"frame":' >> out/manifest.jsonl
run 0 render box.toml -o 'out/f_####.png' --resume
says err "1 frame written, 5 kept"
same_manifest out fresh "torn manifest"
(($(wc -l < out/timings.jsonl) == 6)) || fail "timings of $(wc -l < out/timings.jsonl) frames, not of 6"

printf '{"frame":' >> out/manifest.jsonl
run 0 render box.toml -o 'out/f_####.png' --resume
says err "0 frames written, 6 kept"
same_manifest out fresh "torn manifest with nothing to draw"

# Timings stay where their frames do.
rm out/f_0004.png
run 0 render box.toml -o 'out/f_####.png' --resume
(($(wc -l < out/timings.jsonl) == 6)) || fail "a resumed render forgot timings"
run 0 render box.toml --size 32x24 -f 1,2 -o 'out/f_####.png'
(($(wc -l < out/timings.jsonl) == 6)) || fail "timings of frames that stay were dropped"
(($(grep -c '"seed"' out/manifest.jsonl) == 6)) || fail "records of frames that stay were dropped"

# A pattern without a folder.
run 0 render box.toml -o 'f_####.png' -f 1..3
run 0 render box.toml -o 'f_####.png' --resume
says err "3 frames written, 3 kept"
finish
