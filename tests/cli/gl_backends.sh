#!/usr/bin/env bash
# needs: gl
# The GL back ends as users run them.
source "$(dirname "$0")/lib.sh"
# Mesa keeps memory and threads that LeakSanitizer cannot always read.
scene moving.toml 6 'stroke = { width = 0.5, colour = "#2040ff80" }'

run 0 --version
says out "Mesa"
"$flatray" check moving.toml --sandbox > /dev/null 2> err.txt && sandbox=--sandbox  # only where the kernel has it
for backend in gl osmesa egl; do
  run 0 render moving.toml -o "$backend/####.png" --backend "$backend" -j 1
  run 0 render moving.toml -o "${backend}_2/####.png" --backend "$backend" -j 2
  same "$backend" "${backend}_2" "$backend, one thread and two"
  same_manifest "$backend" "${backend}_2" "$backend, one thread and two"
  # Mesa finds in the sandbox all that it draws with.
  run 0 render moving.toml -o "${backend}_3/####.png" --backend "$backend" -j 2 ${sandbox:+--sandbox}
  same "$backend" "${backend}_3" "$backend in the sandbox"
  same_manifest "$backend" "${backend}_3" "$backend in the sandbox"
done
same osmesa egl "OSMesa and EGL"
grep -q '"backend":"gl: OSMesa, Mesa [0-9.]*' osmesa/manifest.jsonl || fail "the manifest does not name OSMesa and its version"
grep -q '"backend":"gl: EGL, Mesa [0-9.]*' egl/manifest.jsonl || fail "the manifest does not name EGL and its version"
run 0 render moving.toml -o 'auto/####.png' --backend auto
same auto gl "auto with GL is gl"

# Frames of one back end are not taken for another's.
cp -r osmesa mixed
run 0 render moving.toml -o 'mixed/####.png' --backend software --resume
grep -q '"backend":"software"' mixed/manifest.jsonl || fail "--resume kept the pictures of another back end"
run 0 render moving.toml -o 'osmesa/####.png' --backend osmesa --resume
says err "6 kept"

# Close to the software back end; the closer, the more samples.
run 0 render moving.toml -f 4 -o exact.png
for samples in 4 16 64; do
  run 0 render moving.toml -f 4 -o "s$samples.png" --backend gl --samples "$samples"
  run 1 compare "s$samples.png" exact.png --metric mean
  mean[samples]=$(sed -n 's/ *mean //p' out.txt)
done
awk "BEGIN { exit !(${mean[4]} < 1 && ${mean[16]} < ${mean[4]} && ${mean[64]} < ${mean[16]}) }" ||
  fail "means with 4, 16, 64 samples: ${mean[4]} ${mean[16]} ${mean[64]}"
run 0 render moving.toml -f 1 -o light.hdr --backend gl
exists light.hdr

# Tiles: wider and higher than one.
run 0 render moving.toml -f 1 -o wide.png --backend gl --size 5000x40
run 0 render moving.toml -f 1 -o high.png --backend gl --size 40x5000
run 0 render moving.toml -f 1 -o crop.png --backend gl --size 5000x40 --crop 2000,0,2100,40
[[ $(size_of wide.png) == 5000x40 && $(size_of high.png) == 40x5000 ]] || fail "sizes of tiled pictures"

# The module links neither Mesa nor EGL: it finds them when asked.
module=$(dirname "$flatray")/flatray_gl.so
readelf -d "$module" | grep NEEDED | grep -qE 'OSMesa|EGL|libGL|OpenGL' && fail "the module links GL"
finish
