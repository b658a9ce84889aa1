#!/usr/bin/env bash
# examples.sh ROOT: every program of ROOT/examples is under 60 lines, begins with a comment, is built, and includes only
# what is installed and the standard library.
set -euo pipefail
cd "$1/examples"

failures=0
fault() { echo "$1"; failures=$((failures + 1)); }
for source in *.cpp; do
  lines=$(wc -l <"$source")
  ((lines < 60)) || fault "$source: $lines lines, must be under 60"
  [[ $(head -c 3 "$source") == '// ' ]] || fault "$source: does not begin with a comment"
  grep -q "^flatray_example(${source%.cpp} " CMakeLists.txt || fault "$source: not built"
  others=$(grep -E '^#include' "$source" | grep -vE '^#include <(flatray/[a-z]+\.h|[a-z_]+)>$' || true)
  [[ -z $others ]] || fault "$source: $others"
done
((failures == 0))
