#!/usr/bin/env bash
# needs: shapes/box shapes/circle lamps/point formats/toml passes/light
# A refused --resume leaves the folder byte for byte as it was: every refusal there is.
source "$(dirname "$0")/lib.sh"
scene box.toml 4
cat > lamp.toml << 'END'
flatray = 1
frames = 3
film = { size = [16, 12], world = [[-4, -3], [4, 3]] }
[[lamp]]
source = { point = {} }
velocity = [1, 0]
END
sed 's/12\], world/13], world/' lamp.toml > other.toml
cat > jam.toml << 'END'
flatray = 1
fps = 1
frames = 9
film = { size = [64, 48] }
collisions = { response = "bounce" }
[[entity]]
shape = { box = { min = [0, 0], max = [1, 1] } }
[[entity]]
shape = { box = { min = [-3, 0], max = [-2, 1] } }
velocity = [1, 0]
mass = "fixed"
[[entity]]
shape = { box = { min = [3, 0], max = [4, 1] } }
velocity = [-1, 0]
mass = "fixed"
END
# Of folders not the time: a run claims the one it is to write into, and lets it go.
tree() {
  (cd out && find . -type d -printf '%p %i\n' -o -printf '%p %y %i %s %l %T@\n' -type f -exec sha256sum {} + | sort)
}
# A folder of films and pictures, each list with a torn end, and what a killed run left; `begin` makes a new copy of it.
"$flatray" render lamp.toml --rays 1 -o 'begun/####.film' --quiet
"$flatray" render box.toml -o 'begun/f_####.png' --quiet
printf '{"frame":' | tee -a begun/manifest.jsonl >> begun/timings.jsonl
echo part > begun/.f_0001.png.0123456789abcdef.part
begin() { rm -rf out two && cp -a begun out; }
films="render lamp.toml --rays 300000 -o out/####.film --resume"
pictures="render box.toml --seed 1 -o out/f_####.png --resume"
refused() {  # refused CODE CHANGE TEXT ARGS...: after the change, a shell's word
  local code=$1 change=$2 text=$3 before
  shift 3
  begin
  eval "$change"
  before=$(tree)
  run "$code" "$@"
  says err "$text"
  [[ $(tree) == "$before" ]] || fail "$change, flatray $*: $(diff <(echo "$before") <(tree))"
}
# shellcheck disable=SC2086
walk() {
  # Films of other light, and what is none.
  refused 6 : "is a film of other light: its seed is 0, not 7" $films --seed 7
  refused 6 : "is a film of other light" $films --size 8x6
  refused 6 : "its scene is" $films -D lamp.0.at=[1,1]
  refused 6 : "its scrambles is 1, not 16" $films -D light.scrambles=16
  refused 6 : "its size is" ${films/lamp/other}
  refused 6 'cp out/0003.film out/0002.film' "0002.film: error: is a film of other light: its frame is 3, not 2" $films
  refused 4 'truncate -s -8 out/0003.film' "0003.film: error: film has" $films
  refused 4 'truncate -s 0 out/0003.film' "0003.film: error: " $films
  refused 4 'echo mine > out/0003.film' "0003.film: error: is not a film" $films
  refused 6 'ln -sf 0001.film out/0003.film' "0003.film: error: is a link" $films
  refused 6 'rm out/0003.film; mkdir out/0003.film' "0003.film: error: is a folder" $films
  refused 6 'rm out/0003.film; mkfifo out/0003.film' "0003.film: error: is not a plain file" $films
  refused 6 'echo mine > out/e_0002.png' "e_0002.png: error: is there already" $films --error-image out/e_####.png
  # Lists.
  for list in manifest timings; do
    refused 6 "echo mine > out/$list.jsonl" "$list.jsonl: error: is there already" $films
    refused 6 "rm out/$list.jsonl; mkfifo out/$list.jsonl" "$list.jsonl: error: is not a plain file" $films
    refused 6 "rm out/$list.jsonl; ln -s 0001.film out/$list.jsonl" "$list.jsonl: error: is a link" $pictures
  done
  refused 6 'ln -s 0001.film out/manifest.0-of-2.jsonl' "manifest.0-of-2.jsonl: error: is a link" $pictures
  # Pictures of others.
  refused 6 'echo mine > out/f_0003.png; sed -i /f_0003/d out/manifest.jsonl' "f_0003.png: error: is there already" $pictures
  refused 6 'ln -sf 0001.film out/f_0003.png' "f_0003.png: error: is a link" $pictures
  refused 6 'rm out/f_0003.png; mkdir out/f_0003.png' "f_0003.png: error: is a folder" $pictures --force
  # The second of two scenes.
  refused 6 'cp -r out two; cp out/0003.film two/lamp_0002.film; mv two out' "lamp_0002.film: error: is a film of other light" \
    render other.toml lamp.toml -o 'out/two/{scene}_####.film' --resume --rays 1
  refused 6 'mkdir out/other; ln -s other out/lamp' "out/lamp: error: is a link" \
    render other.toml lamp.toml -o 'out/{scene}/####.film' --resume --rays 1
  # What a scene or an option says.
  refused 4 'rm out/.*.part' "bodies are jammed" ${pictures/box/jam} -f 3..4
  refused 2 : "does not go with a film" $films --crop 0,0,4,4
  refused 2 : "no lamp" ${films/lamp/box}
  refused 2 : "film.size[0] is 0" $films -D film.size=[0,0]
}
walk
# What fits goes on from the same folder.
begin
# shellcheck disable=SC2086
run 0 $films
# shellcheck disable=SC2086
run 0 $pictures
run 0 verify out
finish
