#!/usr/bin/env bash
# needs: shapes/box shapes/capsule shapes/circle shapes/convex shapes/ellipse shapes/mushroom shapes/ngon shapes/polygon shapes/segment shapes/star
# accuracy.sh FLATRAY ROOT [FOLDER]: the pages of `flatray accuracy` for three scenes and the figures of experiments, orbits
# and hits, in a real browser. FOLDER takes pictures of them.
set -euo pipefail
flatray=$1
root=$2
skip() {
  echo "skipped: $1; tools/setup --browser installs it"
  exit 77
}
export CHROMIUM=${CHROMIUM:-$(command -v chromium || true)}
[[ -n $CHROMIUM ]] || skip "there is no chromium"
command -v node >/dev/null || skip "there is no node"
[[ -d $root/tests/browser/node_modules/playwright-core ]] || skip "there is no playwright-core"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
pages=()
for scene in tutorial/10_everything chamber/three_discs collision/bullet; do
  folder=$work/${scene//\//_}
  "$flatray" accuracy "$root/scenes/$scene.toml" -o "$folder" --budget 4s -D film.size=[200,120] --json >/dev/null
  pages+=("$folder/accuracy.html")
done

# A figure of each kind: maps, lines, points, orbits, graphs.
experiment() { # experiment NAME SCENE OPTION...: its figures
  local folder=$work/$1
  "$flatray" experiment "$1" "$root/scenes/$2.toml" -o "$folder" "${@:3}" --quiet >/dev/null
  pages+=("$folder"/*.svg)
}
experiment caustic chamber/ellipse
experiment reflections chamber/wedge --bounces 50
experiment poincare chamber/mushroom --count 50000
experiment divergence chamber/sinai
experiment escape chamber/stadium_hole --count 20000 -D film.size=[24,60]
experiment splitting chamber/three_discs_6 -n 11 --apart 0.1 --count 200000 --precision fast
experiment transport chamber/lorentz --count 100000
experiment periodic chamber/three_discs_6
experiment lyapunov chamber/sinai --count 20000 --sweep chamber.0.pillars.0.shape.circle.radius=0.1..0.4:0.1
experiment avoidance collision/avoid
experiment markov tutorial/06_markov --count 20000
"$flatray" orbit "$root/scenes/chamber/three_discs.toml" --svg >"$work/orbit.svg"
"$flatray" hit "$root/scenes/paper/case_one.toml" --from ray --against polygon --svg >"$work/hit.svg"
pages+=("$work/orbit.svg" "$work/hit.svg")

# What looks must see what is wrong: a request, a word on the console, a wide line, an image without a name.
mkdir "$work/broken"
cat >"$work/broken/page.html" <<'PAGE'
<!DOCTYPE html><html lang="en"><title>t</title><main><h1>t</h1><img src="none.png"><p style="width: 3000px">t</p>
<script>console.error('oh')</script></main></html>
PAGE
if node "$root/tests/browser/page_test.mjs" "$work/broken/page.html" >"$work/said" 2>&1; then
  echo "a broken page passes"
  exit 1
fi
cat >"$work/broken/figure.svg" <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="90" height="40"><rect width="90" height="40" fill="#fff"/>
<text x="9" y="20" fill="#aaa">pale</text><text x="12" y="20">over it</text><text x="70" y="9">cut off</text></svg>
SVG
if node "$root/tests/browser/page_test.mjs" "$work/broken/figure.svg" >>"$work/said" 2>&1; then
  echo "a broken figure passes"
  exit 1
fi
for sign in "'pale' is too pale" 'lie over each other' "'cut off' is cut off" 'console: oh' 'asks for' 'wider than the window' 'axe: image-alt'; do
  grep -qF "$sign" "$work/said" || { echo "not seen on a broken page: $sign"; exit 1; }
done

node "$root/tests/browser/page_test.mjs" ${3:+--pictures "$3"} "${pages[@]}"
