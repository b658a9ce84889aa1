#!/usr/bin/env bash
# fast_math.sh ROOT COMPILER: our headers refuse to be compiled with -ffast-math, and say why.
set -euo pipefail

compile() { echo '#include "base/check.h"' | "$compiler" -std=c++20 -fsyntax-only -I "$root/src" -I "$root/src/base/include" "$@" -x c++ - 2>&1; }
root=$1 compiler=$2
compile
if said=$(compile -ffast-math); then
  echo 'compiled with -ffast-math'; exit 1
fi
echo "$said"
grep -qF 'flatray needs IEEE 754 arithmetic' <<<"$said"
