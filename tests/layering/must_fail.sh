#!/usr/bin/env bash
# The layering check must find each of the four wrong includes of tests/layering/wrong, and nothing else.
set -euo pipefail
cd "$(dirname "$0")"
if found=$(bash check.sh wrong); then
  echo "check.sh passed the wrong example:"; echo "$found"; exit 1
fi
echo "$found"
for place in src/geom/up.h:2: src/trace/sideways.h:2: src/oracle/accomplice.cpp:2: src/geom/public.h:2:; do
  grep -qF "$place" <<<"$found" || { echo "not found: $place"; exit 1; }
done
grep -qF '4 wrong includes' <<<"$found"
