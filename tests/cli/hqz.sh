#!/usr/bin/env bash
# needs: formats/hqz lamps/ranges materials/mix shapes/segment passes/light
# Scenes of HQZ of one frame a line.
source "$(dirname "$0")/lib.sh"
line() {
  printf '{"resolution":[16,16],"viewport":[0,0,100,100],"exposure":0.5,"rays":1000,"lights":[[1,50,50,0,0,[0,360],0]],'
  printf '"objects":[%s],"materials":[[[0.5,"d"]]]}\n' "$1"
}
line '[0,10,10,20,5]' > two.json
line '[0,10,20,20,5]' >> two.json
run 0 render two.json -o '####.png' --quiet
run 2 render two.json -f 3 -o x.png
says err "--frames: error: there is no frame 3 in two"
says err "its lines are frames 1 to 2"
run 2 render two.json -f 1..3 -o 'x_####.png'
run 2 explain two.json -f 3
[[ ! -e x.png ]] || fail "a frame that no line tells of is drawn"

# What a line lacks takes no memory: not walls times lines.
if [[ -z $sanitizers ]]; then
  line "$(seq -s, -f '[0,%g,1,1,1]' 2000)" > many.json
  for ((i = 0; i < 20000; ++i)); do line ''; done >> many.json
  run 0 check many.json --max-memory 400M
fi
finish
