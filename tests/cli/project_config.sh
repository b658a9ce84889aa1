#!/usr/bin/env bash
# Options from flatray.toml of the folder: below the command line and the environment, above the scene.
source "$(dirname "$0")/lib.sh"
scene box.toml 1

printf 'size = "20x10"\noutput = "set.png"\njobs = 1\nquiet = true\ncount = 3\n' > flatray.toml
run 0 render box.toml
silent err
[[ $(size_of set.png) == 20x10 ]] || fail "size is not that of flatray.toml"
FLATRAY_SIZE=30x10 run 0 render box.toml
[[ $(size_of set.png) == 30x10 ]] || fail "the environment does not win"
FLATRAY_SIZE=30x10 run 0 render box.toml --size 40x10 -o over.png
[[ $(size_of over.png) == 40x10 ]] || fail "the command line does not win"

printf 'force = true\n' > flatray.toml
echo precious > kept.png
FLATRAY_FORCE=0 run 6 render box.toml -o kept.png
[[ $(< kept.png) == precious ]] || fail "the environment says no, and flatray.toml yes"
run 0 render box.toml -o kept.png

printf 'max-entities = 3\n' > flatray.toml
printf 'flatray = 1\n[[entity]]\nshape = { box = { min = [0, 0], max = [1, 1] } }\n%s\n' \
  'repeat = { grid = { count = [4, 1], step = [2, 2] } }' > four.toml
run 4 check four.toml
says err "the limit is 3; --max-entities raises it"
run 0 check four.toml --max-entities 4

printf 'define = ["film.size=[7,5]", "fps=3"]\n' > flatray.toml
run 0 render box.toml -o seven.png
[[ $(size_of seven.png) == 7x5 ]] || fail "-D of flatray.toml is not heard"

run 0 render box.toml -D fps=5 -o key.png
[[ $(size_of key.png) == 7x5 ]] || fail "-D of another key discards those of flatray.toml"
FLATRAY_DEFINE=film.size=[9,9] run 0 render box.toml -D fps=5 -o key.png
[[ $(size_of key.png) == 9x9 ]] || fail "the environment does not win over flatray.toml"
printf 'define = ["fps=3",\n  "film.size=[7,0]"]\n' > flatray.toml
run 2 check box.toml
says err "flatray.toml:2:3: error: film.size[1] is 0"
run 0 check box.toml -D film.size=[7,5]
rm flatray.toml
run 2 experiment mean-free-path "$root/scenes/chamber/sinai.toml" --sweep fps=1,0 --count 100 -n 3
says err "--sweep fps:1:7: error: fps is not above 0"

printf 'jobz = 2\nquiet = 3\nsize = [1, 2]\n' > flatray.toml
run 2 render box.toml -o x.png
says err "flatray.toml:1:1: error: unknown option 'jobz' (did you mean 'jobs'?)"
says err "flatray.toml:2:9: error: quiet is a number, not true or false"
says err "flatray.toml:3:8: error: size is an array, not a number or string"
printf 'jobs = = 2\n' > flatray.toml
run 2 render box.toml -o x.png
says err "flatray.toml:1:8: error:"
printf '\njobs = 0\nsize = "axb"\n' > flatray.toml
run 2 render box.toml -o x.png
says err "flatray.toml:2:8: error: 0 is out of range"
says err "flatray.toml:3:8: error: width 'a' is not a whole number of pixels"

rm flatray.toml
for kind in 'mkdir' 'mkfifo' 'ln -s nowhere'; do
  $kind flatray.toml
  run 3 render box.toml -o x.png
  says err "flatray.toml: error: is not a plain file of this folder"
  rm -r flatray.toml
done
absent x.png
finish
