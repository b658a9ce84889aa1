#!/usr/bin/env bash
# needs: formats/obj formats/list shapes/circle
# Messages say what is meant; what means nothing is told, not passed over.
leaks=looked_for
source "$(dirname "$0")/lib.sh"
scene scene.toml 3
run 2 render scene.toml --shard 0/99999999
says err "'0/99999999' has too many shards"
run 2 render scene.toml --ray-shard 0/18446744073709551616 -o shard.film
says err "'0/18446744073709551616' has too many shards"
run 2 render scene.toml -o "$(printf 'd/%.0s' {1..1600})a.png"
says err "the path has 3205 bytes"
run 2 accuracy scene.toml --budget 1e9
says err "is too long a time"
run 0 render scene.toml --size 8x6 --progress always
says err "33 %, 1 of 3 frames"
mkdir folder
run 3 compare folder nosuch
says err "nosuch: error: is not there"
run 2 render scene.toml -o
says err "--output: error: needs a value PATTERN"
run 2 render scene.toml --quiet=3
says err "--quiet: error: takes no value"
printf 'v 0 0\nv 4 4\nv 4 0\nv 0 4\nf 1 2 3 4\n' > crossing.obj
run 4 check crossing.obj
says err "crossing.obj:5:1: error: edges of this face cross"

# All mistakes of a command line are told together, those of words and those of values.
run 2 orbit scene.toml --bounces x --frame 0 --corner bak --nosuch -o
for one in "--bounces: error: 'x' is not a whole number" '--frame: error: 0 is out of range' \
  "--corner: error: unknown value 'bak' (did you mean 'back'?)" '--nosuch: error: unknown option' \
  'flatray: 5 errors'; do says err "$one"; done

# Of two ways to print both are named; what is said nearer counts.
for two in 'json csv' 'json svg' 'csv svg'; do
  run 2 hit scene.toml --ray 0,4,1,0 --${two% *} --${two#* }
  says err "--${two#* }: error: does not go with --${two% *}"
done
FLATRAY_JSON=1 run 0 hit scene.toml --ray 0,4,1,0 --csv
says out 'ray,against,edge'

# One rule of frames.
run 0 render scene.toml -f 6 --size 8x6 -o six.png
run 0 collide scene.toml -f 6

# Blank lines are no questions.
printf '\n \r\n{"op":"clip","polygon":[[0,0],[1,0],[0,1]],"origin":[-1,0.25],"direction":[1,0]}\n\n' > questions
run 0 query questions
(($(wc -l < out.txt) == 1)) || fail "a blank line was answered"

# Misspelt variables are warned of; known ones are not.
FLATRAY_SIZ=8x6 FLATRAY_SIZE=8x6 run 0 render scene.toml -f 1 -o size.png
says err "FLATRAY_SIZ: warning: no option is set by this variable"
says err "did you mean FLATRAY_SIZE?"
(($(grep -c warning err.txt) == 1)) || fail "more is warned of than is misspelt"

# A light of HDR is compared, beyond white too; a picture that cannot be judged is counted.
run 0 render scene.toml -f 1 --size 8x6 -o a.hdr --quiet
run 0 compare a.hdr a.hdr
says out equal
head -c 100 a.hdr > cut.hdr
run 4 compare a.hdr cut.hdr
mkdir -p goldens/scenes
run 3 golden check --root goldens
says err "name the folder that has goldens by --root"
cp scene.toml goldens/scenes
(unset CI && run 0 golden update scene --why "test" -f 1 --root goldens)
for picture in goldens/golden_images/scene/*.png; do echo garbage > "$picture"; done
run 4 golden check --root goldens
says out "1 golden, 0 of them different, 1 not judged"

# flatray.toml: with a byte-order mark it is read; broken it leaves help alone.
printf '\xef\xbb\xbfsize = "8x6"\n' > flatray.toml
run 0 render scene.toml -f 1 -o marked.png
[[ $(size_of marked.png) == 8x6 ]] || fail "flatray.toml with a byte-order mark"
printf 'size = = 3\n' > flatray.toml
run 0 help render
run 0 --help
run 0 render --help
run 0 completion bash

# A list in Latin-1 becomes TOML that is read.
rm flatray.toml
printf 'caf\xe9, 1, 2\n' > latin.list
run 0 convert latin.list latin.toml
run 0 check latin.toml
# All mistakes of a list, and a name that two have.
printf 'X, 1\nY, a, b\nZ, 1, 2\nW 1 2\n' > three.txt
run 4 check three.txt
says err "three.txt:4:1: error: a name and two numbers are wanted"
says err "3 errors"
printf 'flatray = 1\n[[entity]]\nname = "d"\nshape = { circle = {} }\n' > two.toml
printf '[[entity]]\nname = "d"\nshape = { circle = {} }\n' >> two.toml
run 2 convert two.toml - -D 'entity.d.at=[7,7]'
says err "two entries are named 'd'"
finish
