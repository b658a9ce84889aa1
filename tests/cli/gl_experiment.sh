#!/usr/bin/env bash
# needs: gl materials/glass shapes/capsule shapes/circle shapes/convex shapes/ngon shapes/polygon shapes/segment shapes/star
# The GL back end against exact areas on scenes of the project: samples explain every difference.
source "$(dirname "$0")/lib.sh"
# Mesa keeps memory and threads that LeakSanitizer cannot always read.
for name in tutorial/02_shapes tutorial/09_chamber paper/case_two drawing/gradients drawing/fading; do
  run 0 experiment backends "$root/scenes/$name.toml" -D film.size=[160,100] -o files
  says out "all differences are those between exact areas and samples"
  says out "Mesa"
  exists files/backends.csv files/backends.json
done
# What is drawn by shaders of its own is the same whoever made the context.
for name in gradients fading; do
  for backend in osmesa egl; do
    run 0 render "$root/scenes/drawing/$name.toml" -f 13 -o "$name/$backend.png" --backend "$backend"
  done
  cmp "$name/osmesa.png" "$name/egl.png" || fail "$name by OSMesa and by EGL"
done
MESA_EXTENSION_OVERRIDE=-GL_ARB_gpu_shader_fp64 \
  run 5 render "$root/scenes/drawing/gradients.toml" -f 1 -o x.png --backend osmesa
says err "no doubles in its shaders"
says err "say --backend software"
# Glass and a magnetic field are drawn like all else.
for name in glass_disc magnetic_stadium; do
  run 0 experiment backends "$root/scenes/chamber/$name.toml" -D 'film.size=[48,48]' -o files
done
FLATRAY_GL_MODULE=absent.so run 5 experiment backends "$root/scenes/paper/case_two.toml"
says err "tools/setup --gl"
finish
