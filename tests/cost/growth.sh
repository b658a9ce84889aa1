#!/usr/bin/env bash
# growth.sh [--must] FLATRAY: no scene costs more than n log n in what it holds and what is drawn of it. Instructions of
# scenes of n, 2n and 4n equal parts are counted; from 2n to 4n they may grow by 2.5 times what they grow from n to 2n
# (n log n: 2.2; n^2: 4). Where there is no valgrind the check is skipped (exit 77); with --must, or where CI is set, it fails.
set -euo pipefail
must=${CI:-}
[[ $1 != --must ]] || { must=1 && shift; }
flatray=$(realpath "$1")
command -v valgrind >/dev/null || {
  [[ -z $must ]] || { echo "FAIL: there is no valgrind" && exit 1; }
  echo "skipped: there is no valgrind"
  exit 77
}
unset "${!FLATRAY_@}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# What each case asks, n, and its name; `scene` writes it.
cases='
check 1000 comb
check 500 spiral
check 1000 saw
render 100 same_faces
render 100 near_faces
render 120 edge_rays
collide 400 zigzags
meet 400 zigzags
meet 200 combs
gas 100 discs
render 200 circles
orbit 200 rings
orbit 100 legs
render 200 groups
check 250 keys
check 200 includes
check 100 imports
check 1000 round_holes
check 500 cell_discs
convert 2000 named
'

# scene NAME N FILE
scene() {
  awk -v name="$1" -v n="$2" -v file="$3" '
    function point(x, y) { printf "%s[%.17g, %.17g]", points++ ? ", " : "", x, y }
    function outline() { points = 0; printf "[[entity]]\nshape = { polygon = { points = [" }
    function end_outline() { print "] } }" }
    function comb(x, y, i) {
      points = 0
      for (i = 0; i < n / 4; i++) {
        point(x + 4 * i, y); point(x + 4 * i + 1, y + 9); point(x + 4 * i + 2, y + 9); point(x + 4 * i + 3, y)
      }
      point(x + n, y - 1); point(x - 1, y - 1)
    }
    BEGIN {
      srand(7)
      if (name !~ /faces/) print "flatray = 1\nfilm = { size = [64, 64] }"
      if (name == "comb") {
        outline(); comb(0, 0); end_outline()
      } else if (name == "spiral") {
        outline()
        for (i = 0; i < n / 2; i++) { t = 250 * i / n; point((1 + t) * cos(t), (1 + t) * sin(t)) }
        for (i = n / 2; i-- > 0;) { t = 250 * i / n; point((3 + t) * cos(t), (3 + t) * sin(t)) }
        end_outline()
      } else if (name == "saw") {
        outline()
        for (i = 0; i < n / 2; i++) point(i, 2 * n + i % 2 * n - i)
        for (i = n / 2; i-- > 0;) point(i, i % 2 * n - i)
        end_outline()
      } else if (name == "same_faces") {
        print "v 0.1 0.1\nv 3.3 0.4\nv 2.9 3.1\nv 0.3 2.7"
        for (i = 0; i < n; i++) print "f 1 2 3 4"
      } else if (name == "near_faces") {
        for (i = 0; i < n; i++) printf "v %.9f 0.1\nv 3.3 %.9f\nv 2.9 3.1\n", 0.1 + i * 1e-6, 0.4 + i * 1e-7
        for (i = 0; i < n; i++) print "f", 3 * i + 1, 3 * i + 2, 3 * i + 3
      } else if (name == "edge_rays") {
        for (k = 0; k < 2; k++) {
          printf "[[entity]]\nname = \"%s\"\nshape = { polygon = { points = [", k ? "b" : "a"
          comb(k * 1.3, k * 3.7); end_outline()
        }
        print "[[edge_rays]]\nfrom = \"a\"\nagainst = \"b\""
      } else if (name == "combs") {  # one beside the other, of which their last teeth meet
        for (k = 0; k < 2; k++) {
          outline(); comb(k * (n + 1), 0); end_outline()
          printf "velocity = [%d, 0]\n", -k
        }
      } else if (name == "zigzags") {  # beside each other, and never touching
        for (k = 0; k < 2; k++) {
          outline()
          for (i = 0; i < n / 2; i++) point(i, i % 2 * 5 + 3 * k)
          for (i = n / 2; i-- > 0;) point(i, i % 2 * 5 + 3 * k + 1)
          end_outline()
          printf "velocity = [%d, 0]\n", k
        }
      } else if (name == "circles") {
        for (i = 0; i < n; i++)
          printf "[[entity]]\nshape = { circle = { radius = 1 } }\nat = [%.3f, %.3f]\n", 50 * rand(), 50 * rand()
      } else if (name == "discs") {  # of which two meet
        for (i = 0; i < n; i++)
          printf "[[entity]]\nshape = { circle = { radius = 1 } }\nat = [%d, 0]\nvelocity = [%d, 1]\n", 3 * i, i == 0
      } else if (name == "rings") {  # mirrors that nearly lie on one another
        for (i = 0; i < n; i++)
          printf "[[entity]]\nmaterial = \"mirror\"\nshape = { circle = { centre = [%.3f, 0], radius = 1 } }\n", i / 1000
        print "[[ray]]\nat = [0, 3]\ndirection = [0.1, -1]\nbounces = 3"
      } else if (name == "legs") {  # of a mirror that goes to and fro, and one that rests
        printf "[[entity]]\nmaterial = \"mirror\"\nshape = { segment = { from = [0, -9], to = [0, 9] } }\nat = { keys = ["
        for (i = 0; i < n; i++) printf "%s[%.2f, [%.1f, 0]]", i ? ", " : "", i / 100, 5 + i % 2 / 10
        print "] }\n[[entity]]\nmaterial = \"mirror\"\nshape = { segment = { from = [-5, -9], to = [-5, 9] } }"
        printf "[[ray]]\nat = [0, 0]\ndirection = [1, 0]\nspeed = 1000\nbounces = %d\n", n
      } else if (name == "groups") {
        for (i = 0; i < n; i++)
          printf "[[group]]\nname = \"g%d\"\nat = [1, 0]\n%s", i, i ? sprintf("group = \"g%d\"\n", i / 2) : ""
        for (i = 0; i < n; i++) printf "[[entity]]\nshape = { circle = { radius = 1 } }\ngroup = \"g%d\"\n", i
      } else if (name == "keys") {
        printf "[[entity]]\nshape = { circle = { radius = 1 } }\nat = { keys = ["
        for (i = 0; i < n; i++) printf "%s[%d, [%d, %d]]", i ? ", " : "", i, i % 7, i % 5
        print "] }"
      } else if (name == "includes") {
        printf "include = ["
        for (i = 0; i < n; i++) {
          part = sprintf("part%d.toml", i)
          printf "flatray = 1\n[markov.c%d]\nA = { A = 1 }\n", i >part
          close(part)
          printf "%s\"%s\"", i ? ", " : "", part
        }
        print "]"
      } else if (name == "imports") {  # of one file, which grows with them
        part = file ".obj"
        for (i = 0; i < 20 * n; i++) print "# a remark" >part
        print "v 0 0\nv 1 0\nv 0 1\nf 1 2 3" >part
        close(part)
        for (i = 0; i < n; i++) printf "[[entity]]\nshape = { import = { file = \"%s\" } }\n", part
      } else if (name == "round_holes") {
        print "[[chamber]]\nshape = { circle = { radius = 1 } }"
        for (i = 0; i < n; i++) printf "[[chamber.holes]]\nfrom = %.9f\nto = %.9f\n", (i + 0.2) / n, (i + 0.6) / n
      } else if (name == "cell_discs") {  # on a periodic edge, so that each has a copy opposite
        printf "[[chamber]]\nshape = { box = { min = [0, 0], max = [1, 1] } }\nmaterial = \"periodic\"\npillars = ["
        for (i = 0; i < n; i++) printf "%s{ shape = { circle = { centre = [0, %.9f], radius = 1e-6 } } }", i ? ", " : "", (i + 0.5) / n
        print "]\n[[ray]]\nat = [0.5, 0.5]\ndirection = [1, 0.3]"
      } else if (name == "named") {
        for (i = 0; i < n; i++) printf "[[group]]\nname = \"g%d\"\n", i
      }
    }' >"$3"
}

# instructions VERB FILE
instructions() {
  local more=() verb=("$1")
  [[ $1 != collide ]] || more=(--method edge-rays --last 1)
  [[ $1 != convert ]] || more=(-)
  [[ $1 != meet ]] || verb=(collide) more=(--last 2)
  [[ $1 != gas ]] || verb=(experiment gas) more=(--count 1 -o "$2.out")
  [[ $1 != render ]] || more=(--size 256x256 -j 1 --quiet -o "$2.png")
  valgrind --tool=callgrind --callgrind-out-file=/dev/null "$flatray" "${verb[@]}" "$2" "${more[@]}" 2>&1 |
    sed -n 's/.*Collected : \([0-9]*\).*/\1/p'
}

failed=0
while read -r verb n name; do
  [[ -n $name ]] || continue
  counts=()
  end=toml
  [[ $name != *faces ]] || end=obj
  for times in 1 2 4; do
    scene "$name" $((times * n)) "$name$times.$end"
    instructions "$verb" "$name$times.$end" >"count$times" &
  done
  wait
  for times in 1 2 4; do counts+=("$(cat "count$times")"); done
  growth=$(awk "BEGIN { print (${counts[2]} - ${counts[1]}) / (${counts[1]} - ${counts[0]}) }")
  printf '%-6s %-14s %9d %9d %9d instructions at %d, %d, %d: %.2f\n' "$verb" "$name" "${counts[@]}" "$n" $((2 * n)) $((4 * n)) "$growth"
  awk "BEGIN { exit !($growth <= 2.5) }" || { echo "FAIL: $verb of $name grows faster than n log n" && failed=1; }
done <<<"$cases"
exit $failed
