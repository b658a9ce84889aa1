#!/usr/bin/env bash
# Every exit code of the design, with the message that goes with it.
source "$(dirname "$0")/lib.sh"
scene good.toml 1

# 0
run 0 render good.toml -o good.png
exists good.png
run 0 check good.toml
run 0 --version
says out "isa"
run 0 help render
says out "--resume"
run 0 render --help
says out "--resume"
run 0 --help
says out "render"

# 2: usage
run 2
run 2 rendr good.toml
says err "did you mean render?"
run 2 good.toml
says err "flatray render good.toml"
run 2 --quiet render good.toml
says err "the verb comes first"
run 2 render
says err "needs SCENE..."
run 2 render good.toml --outptu x.png
says err "did you mean --output?"
run 2 render good.toml -j 0
says err "--jobs: error: 0 is out of range"
run 2 render good.toml -f 1..2 -o one.png
says err "no place for the numbers of 2 frames"
run 2 render good.toml good.toml -o one.png
says err "no place for the names of 2 scenes"
run 2 render good.toml good.toml
says err "another scene is named 'good'"
run 2 list shpes
says err "did you mean 'shapes'?"
run 2 hit good.toml --from bx
says err "did you mean 'box'?"
run 2 experiment markof good.toml
says err "did you mean 'markov'?"
absent out one.png

# 3: missing
run 3 render absent.toml
says err "absent.toml: error: cannot read: No such file or directory"
says err "flatray: 1 error, nothing rendered"
run 3 check .

# 4: invalid
scene bad.toml 1 'velocty = [1, 2]' 'layer = "top"'
run 4 render bad.toml -o bad.png
says err "did you mean 'velocity'?"
says err "flatray: 2 errors, nothing rendered"
run 4 check bad.toml
absent bad.png
run 4 render good.toml bad.toml
absent out  # one scene is wrong: the other is not begun

# 5: not available here
if ! "$flatray" list isas | grep -q avx512; then
  FLATRAY_ISA=avx512 run 5 list isas
fi
FLATRAY_ISA=mmx run 2 list isas

# 6: cannot be written
run 6 render good.toml -o good.toml/x.png
says err "good.toml"
"$flatray" list verbs > /dev/full 2> err.txt
[[ $? == 6 ]] || fail "a full standard output is no success"
echo '{"op":"nearest","walls":[],"origin":[0,0],"direction":[1,0]}' | "$flatray" query > /dev/full 2> err.txt
[[ $? == 6 ]] || fail "a full standard output is no success of query"
says err "No space left on device"
finish
