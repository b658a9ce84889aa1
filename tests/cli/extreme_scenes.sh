#!/usr/bin/env bash
# scenes/extreme: what the comment of each file says must come out.
# needs: formats/toml shapes/box shapes/circle shapes/polygon shapes/segment shapes/star
source "$(dirname "$0")/lib.sh"
extreme=$root/scenes/extreme

# alike WHAT A... -- B...: `flatray render A...` and `flatray render B...` draw the same bytes.
alike() {
  local what=$1 first=()
  shift
  while [[ $1 != -- ]]; do first+=("$1"); shift; done
  shift
  run 0 render "${first[@]}" --quiet -o one.png
  run 0 render "$@" --quiet -o other.png
  cmp -s one.png other.png || fail "$what"
}
alike "A1, A2: huge and tiny differ" "$extreme/huge.toml" -- "$extreme/tiny.toml"
alike "A4: far and near differ" "$extreme/far.toml" -- \
  "$extreme/far.toml" -D group.all.at=[0,0] -D film.world=[[0,0],[32,20]]
alike "B1: slivers show" "$extreme/slivers.toml" -- \
  "$extreme/slivers.toml" -D 'entity.comb.shape={ box = { min = [2, 2], max = [30, 6] } }'
alike "ten thousand opaque boxes are not one" "$extreme/pile.toml" -- \
  "$extreme/pile.toml" -D entity.pile.repeat.grid.count=[1,1]
alike "a thousand veils are not opaque" "$extreme/pile.toml" --crop 97,30,137,70 -- "$extreme/pile.toml" --crop 97,30,137,70 \
  -D entity.haze.repeat.grid.count=[1,1] -D 'entity.haze.fill="#1f77b4"'

run 0 hit "$extreme/near_parallel.toml"
says out '  through: t from 1 to 2'
says out '  touch: t from 2 to 2'
says out '  miss, starts outside'

for scene in "$extreme"/*.toml; do run 0 check "$scene"; done
finish
