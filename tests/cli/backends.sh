#!/usr/bin/env bash
# What holds of back ends whether or not the GL module was built.
source "$(dirname "$0")/lib.sh"
scene moving.toml 3

run 0 render moving.toml -o 'plain/####.png'
run 0 render moving.toml -o 'named/####.png' --backend software
same plain named "the software back end is the default"
same_manifest plain named "the software back end is the default"
grep -q '"backend":"software"' plain/manifest.jsonl || fail "the manifest does not name the back end"
run 0 list backends
says out "software"

# A back end that is not there is exit 5, with what to install, and nothing is written.
FLATRAY_GL_MODULE=absent.so run 5 render moving.toml -o 'gl/####.png' --backend gl
says err "absent.so is not there"
says err "tools/setup --gl"
says err "nothing rendered"
absent gl
echo 'no library' > wrong.so
FLATRAY_GL_MODULE=$PWD/wrong.so run 5 render moving.toml -o 'gl/####.png' --backend osmesa
FLATRAY_GL_MODULE=absent.so run 0 render moving.toml -o 'auto/####.png' --backend auto
same plain auto "auto without GL is the software back end"
FLATRAY_GL_MODULE=absent.so run 0 --version
says out "software; no gl"

run 2 render moving.toml --backend softwar
says err "software"
run 2 render moving.toml --samples 16
says err "takes no samples"
run 2 render moving.toml --backend gl --samples 5
says err "--samples"

# Neither Mesa nor the module is linked, and nothing of them is loaded unasked.
for library in OSMesa EGL GL OpenGL flatray_gl; do
  readelf -d "$flatray" | grep NEEDED | grep -q "lib$library\|$library.so" && fail "flatray links $library"
done
LD_DEBUG=files "$flatray" render moving.toml -f 1 -o one.png 2>&1 | grep -qiE 'osmesa|libegl|flatray_gl' &&
  fail "a software render loads GL"
finish
