#!/usr/bin/env bash
# The program of few entries: what FLATRAY_ONLY (the third argument, with ; between) names is listed and nothing else; boxes are
# drawn; all that is left out is refused as that, exit 5, and nothing is drawn without it.
only=$3
set -- "$1" "$2"
source "$(dirname "$0")/../cli/lib.sh"

# Listed are just the entries of the build.
for kind in shapes formats tracers passes backends views metrics encoders pictures experiments verbs; do
  run 0 list "$kind"
  awk '{ print $1 }' out.txt | sort >listed.txt
  tr ';' '\n' <<<"$only" | sed -n "s|^$kind/||p" | sort >wanted.txt
  diff wanted.txt listed.txt >difference.txt || fail "list $kind: $(tr '\n' ' ' <difference.txt)"
done
run 0 --version
says out "nothing optional"
needed=$(readelf -d "$flatray" | grep NEEDED)
for library in mpfr embree OSMesa EGL; do
  grep -q "lib$library" <<<"$needed" && fail "flatray links $library"
done

# What is there works.
scene moving.toml 2
run 0 check moving.toml
run 0 render moving.toml -o 'out/####.png'
exists out/0001.png out/0002.png
[[ $(size_of out/0002.png) == 64x48 ]] || fail "the picture has another size"
run 0 explain moving.toml
says out "passes/orbits"

# What is not there is said to be left out.
refused() {
  run 5 "$@"
  says err "left out of this build"
  absent x.png
}
printf 'flatray = 1\n[[entity]]\nshape = { circle = { radius = 1 } }\nfill = "#000000"\n' >circle.toml
refused check circle.toml
refused render circle.toml -o x.png
says err "the shape 'circle'"
refused render "$root/scenes/imported/castle.obj" -o x.png
scene one.toml 1
refused render one.toml -o x.png --tracer grid
refused render one.toml -o x.hdr
refused render one.toml -o x --format pfm
refused render one.toml -o x.png --view hits
refused render one.toml -o x.png --backend gl
refused orbit moving.toml
refused experiment gas moving.toml
run 2 render one.toml -o x.png --tracer gird

# A scene of boxes that asks for more than boxes is not drawn without it.
scene ray.toml 1 '[[ray]]' 'at = [0, 0]' 'direction = [1, 0.5]'
refused render ray.toml -o x.png
says err "passes/orbits"
says err "1 ray"
scene chamber.toml 1 '[[chamber]]' 'shape = { box = { min = [0, 0], max = [16, 12] } }'
refused render chamber.toml -o x.png
says err "passes/chambers"
scene box.toml 1 'bounding_box = { colour = "#000000", width = 0.1 }'
refused render box.toml -o x.png
says err "passes/bounding_boxes"
run 0 explain ray.toml
says out "concerns this scene: 1 ray"
finish
