#!/usr/bin/env bash
# Sizes no picture can have are refused before anything is allocated: exit 2 on the command line, 4 in a scene.
source "$(dirname "$0")/lib.sh"
scene box.toml 1
limit_memory 1000000  # a picture of these sizes would not fit

refuse() {  # refuse SIZE TEXT
  run 2 render box.toml --size "$1" -o x.png
  says err "--size: error: $2"
  (($(grep -c error: err.txt) == 1)) || fail "$1: more than one error"
}
refuse 0x5 "width 0 leaves no picture"
refuse 5x0 "height 0 leaves no picture"
refuse -1x5 "width '-1' is not a whole number"
refuse 2147483648x1 "width 2147483648 is over the limit"
refuse 1x4294967297 "height 4294967297 is over the limit"
refuse 65536x65536 "65536x65536 is 4294967296 pixels, over the limit of 268435456"
refuse 1e9x1e9 "width '1e9' is not a whole number"
refuse 100 "'100' is not WIDTHxHEIGHT"

for size in '0, 5' '-1, 5' '2147483648, 1' '4294967297, 1' '65536, 65536' '1e9, 1e9'; do
  printf 'flatray = 1\nfilm = { size = [%s] }\n' "$size" > size.toml
  run 4 render size.toml -o x.png
  says err "size.toml:2:"
done

# A size on the command line replaces the scene's, however wrong that is; a -D is the command line, too.
run 0 render size.toml --size 5x5 -o five.png
run 2 render box.toml -D 'film.size=[0,5]' -o x.png
says err "film.size[0] is 0"

# A limit of one's own, lower and higher.
run 2 render box.toml --size 11x10 --max-pixels 100 -o x.png
says err "over the limit of 100"
run 0 render box.toml --size 10x10 --max-pixels 100 -o x.png
run 0 render box.toml --size 20000x20000 --max-pixels 400000000 --dry-run
run 2 render box.toml --max-pixels 400000001
for crop in 0,0,65,48 5,5,5,6 -1,0,4,4 0,0,4294967297,1; do
  run 2 render box.toml --crop=$crop -o y.png
done
absent y.png
finish
