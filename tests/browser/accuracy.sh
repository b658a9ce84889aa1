#!/usr/bin/env bash
# needs: shapes/circle shapes/polygon shapes/convex shapes/segment
# accuracy.sh FLATRAY ROOT [FOLDER]: the pages of `flatray accuracy` for three scenes, in a real browser. FOLDER takes
# pictures of them.
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
for sign in 'console: oh' 'asks for' 'wider than the window' 'axe: image-alt'; do
  grep -qF "$sign" "$work/said" || { echo "not seen on a broken page: $sign"; exit 1; }
done

node "$root/tests/browser/page_test.mjs" ${3:+--pictures "$3"} "${pages[@]}"
