#!/usr/bin/env bash
# needs: shapes/circle shapes/segment shapes/convex
# A scene with one of everything: no message says "1 rays". Counts are put into words by base/counted.h.
leaks=looked_for
source "$(dirname "$0")/lib.sh"
cat > one.toml <<'TOML'
flatray = 1
film    = { size = [24, 24], world = [[-1, -1], [11, 11]] }

[[chamber]]
name  = "room"
shape = { box = { min = [0, 0], max = [10, 10] } }
[[chamber.pillars]]
shape = { circle = { centre = [5, 6], radius = 1 } }

[[ray]]
name      = "ray"
at        = [2, 2]
direction = [1, 0]
bounces   = 1

[[entity]]
name         = "thing"
shape        = { segment = { from = [1, 1], to = [3, 3] } }
bounding_box = { width_px = 1 }

[[edge_rays]]
from    = "thing"
against = "thing"
TOML
cat > wrong.toml <<'TOML'
flatray = 1
[[entity]]
shape  = { ellipse = { radii = [1] } }
fill   = { linear = { from = [0, 0], to = [1, 0], stops = ["#000000"] } }
[[ray]]
at        = [1]
direction = [1, 0]
TOML
printf 'v 0 0\nv 1 0\nv 2 0\nv 0 1\nf 1 2 3\nf 1 2 4\n' > flat.obj
printf 'v 0 0\nf 1 2 3\n' > missing.obj

# told ARGS...: what the program says, whatever its exit code.
told() {
  "$flatray" "$@" > told.txt 2>&1
  lines=$((lines + $(wc -l < told.txt)))
  grep -nE '(^|[^0-9.,x])1 ([a-z]+ )?[a-z]+s\b' told.txt |
    grep -vE '1 ([a-z]+ )?(is|as|has|this|its|was|pass|less|ms|across|gives|meets|in doubles|differs|misses|leaves|needs|stands)\b' > found.txt
  [[ ! -s found.txt ]] || fail "flatray $*: $(head -1 found.txt)"
}
lines=0
told check one.toml
told check wrong.toml
told check flat.obj
told check missing.obj
told check one.toml --max-entities 1
told explain one.toml -j 1
told explain --measure one.toml -j 1
told explain --measure --keep-all one.toml -j 1
told render one.toml -o one.png -j 1
told render one.toml --dry-run -j 1
told render one.toml --size 2x2 --max-pixels 1
told render one.toml --max-corners 1
told compare one.png one.png
told orbit one.toml
told orbit one.toml --precision certified
told hit one.toml --ray 0,2,1,0
told hit one.toml --ray 0,2,1,0 --op union
told collide one.toml
told stability one.toml
told stability --families grid --count 1 --tracer grid
told experiment reflections one.toml --bounces 1 -o out
told experiment mean-free-path one.toml --count 1 -o out
told experiment mean-free-path one.toml --count 2 --bounces 1 -o out
told experiment mean-free-path one.toml --count 1 --starts quasi -o out
told experiment coverage one.toml --bounces 1 -o out
told experiment caustic one.toml --bounces 1 -o out
told accuracy one.toml --choice precision --budget 0.2 -o out
((lines > 100)) || fail "only $lines lines were looked at"
finish
