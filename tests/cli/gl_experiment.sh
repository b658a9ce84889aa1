#!/usr/bin/env bash
# needs: gl shapes/circle shapes/convex shapes/polygon shapes/segment
# The GL back end against exact areas on scenes of the project: samples explain every difference.
source "$(dirname "$0")/lib.sh"
# Mesa keeps memory and threads that LeakSanitizer cannot always read.
[[ -z $sanitizers ]] || export ASAN_OPTIONS=detect_leaks=0
for name in tutorial/02_shapes tutorial/09_chamber paper/case_two; do
  run 0 experiment backends "$root/scenes/$name.toml" -o files
  says out "all differences are those between exact areas and samples"
  says out "Mesa"
  exists files/backends.csv files/backends.json
done
FLATRAY_GL_MODULE=absent.so run 5 experiment backends "$root/scenes/paper/case_two.toml"
says err "tools/setup --gl"
finish
