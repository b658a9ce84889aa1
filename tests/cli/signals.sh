#!/usr/bin/env bash
# Every verb that can take long, SIGINT, SIGTERM and SIGHUP: it ends soon with 130, 143 or 129, one line says why and what is
# kept, and no file is there in part. Verbs run side by side; each gets its signal when it listens.
source "$(dirname "$0")/lib.sh"
# Mesa keeps shaders on disk by a thread of lowest priority, which a process that ends waits for where all cores are busy.
export MESA_SHADER_CACHE_DISABLE=true
scene box.toml 100000
mkfifo never never.png
exec 3<> never 4<> never.png  # held open: who reads them waits
mkdir scenes golden_images
scene scenes/slow.toml 1 '[[entity]]' 'shape = { circle = { radius = 20 } }' 'opacity = 0.5' \
  'fill = { linear = { from = [0, 0], to = [16, 12], stops = ["#ff0000", "#0000ff"] } }' \
  'repeat = { grid = { count = [100000, 1], step = [1e-5, 0] } }'
echo '{"schema": "flatray.goldens/1", "goldens": []}' > golden_images/manifest.json

# Verb after verb, on work of hours; a word @ stands for the verb's own folder.
commands=(
  'check never'
  'explain never'
  'explain box.toml --measure -f 1..100000'
  'hit never --ray 0,0,1,1'
  'collide SCENES/collision/gas.toml -D frames=999999 -f 1..999999'
  'convert never @/out.toml'
  'compare never.png never.png'
  'query never'
  'orbit SCENES/chamber/sinai.toml -n 10000000'
  'golden update slow --why slow --size 320x200'
  'render box.toml -o @/f_####.png'
  'accuracy SCENES/tutorial/10_everything.toml --budget 100000s -o @'
  'stability --count 1000000000000 -o @'
  'stability --pairs 1000000000 -o @'
  'stability --leaks 1000000000 -o @'
  'experiment avoidance SCENES/collision/avoid.toml -D film.size=[8000,8000] -o @'
  'experiment backends SCENES/tutorial/10_everything.toml -o @'
  'experiment caustic SCENES/chamber/ellipse.toml -n 1000000000 -o @'
  'experiment divergence SCENES/chamber/sinai.toml -n 1000000 -o @'
  'experiment escape SCENES/chamber/three_discs.toml --count 1000000000000 -o @'
  'experiment gas SCENES/collision/gas.toml --count 1000000000 -o @'
  'experiment lyapunov SCENES/chamber/sinai.toml --count 1000000000000 -o @'
  'experiment markov SCENES/markov/runner.toml --root / --count 4294967296 -o @'
  'experiment mean-free-path SCENES/chamber/sinai.toml --count 1000000000000 -o @ --resume'
  'experiment phase-portion SCENES/chamber/mushroom.toml --count 1000000000000 -o @'
  'experiment poincare SCENES/chamber/stadium.toml --count 1 -n 1000000000 -o @'
  'experiment reflections SCENES/chamber/hall.toml -n 1000000000 -o @'
)

# listens PID: whether the process is flatray by now, not yet the shell, and catches SIGTERM; or is over.
listens() {
  [[ -e /proc/$1 ]] || return 0
  [[ $(< "/proc/$1/status") =~ ^Name:[[:space:]]+"${flatray##*/}"[[:space:]].*SigCgt:[[:space:]]*([0-9a-f]+) ]] &&
    ((0x${BASH_REMATCH[1]} & 0x4000))
} 2> /dev/null

signal() {  # INDEX SIGNAL: a process that runs gets the signal
  kill -0 "${pids[$1]}" 2> /dev/null || fail "${commands[$1]}: was over by itself: $(head -c 300 "run$1.err")"
  kill "-$2" "${pids[$1]}"
}
# expect INDEX SIGNAL CODE WORD: it ends as it must.
expect() {
  local command="${commands[$1]}" err=run$1.err code
  wait "${pids[$1]}"
  code=$?
  ((code == $3)) || fail "$command: SIG$2 gave exit code $code"
  ((SECONDS - start < 10)) || fail "$command: ended $((SECONDS - start)) s after SIG$2"
  [[ $(grep -c "$4" "$err") == 1 ]] || fail "$command: says $(head -c 300 "$err")"
  # With sanitizers work may end only as its grace is over, which leaves its claim to the folder.
  found=$(find "run$1" -name '.*')
  [[ -z $found || -n $sanitizers && $found == *.0000000000000000.part ]] || fail "$command: left $found"
  [[ ! -e run$1/out.toml ]] || fail "$command: left a file in part"
}

[[ -e ${flatray%/*}/flatray_gl.so ]] || commands=("${commands[@]/experiment backends*/check never}")  # needs GL
at_once=4
for ((first = 0; first < ${#commands[@]}; first += at_once)); do
  wave=("${!commands[@]}") wave=("${wave[@]:first:at_once}") pids=()
  for i in "${wave[@]}"; do
    mkdir "run$i"
    words=${commands[i]//@/run$i}
    # A shell starts what runs in the background deaf to SIGINT; env gives it back its ears.
    env --default-signal=INT,TERM,HUP "$flatray" ${words//SCENES/$root/scenes} > "run$i.out" 2> "run$i.err" &
    pids[i]=$!
  done
  for i in "${wave[@]}"; do
    for _ in {1..200}; do
      listens "${pids[i]}" && break
      sleep 0.02
    done
  done
  sleep 0.1
  # All of a wave at once: the one that waits for its turn works on.
  start=$SECONDS
  names=(INT TERM HUP) codes=(130 143 129) said=(interrupted terminated 'hung up')
  for i in "${wave[@]}"; do signal "$i" "${names[i % 3]}"; done
  for i in "${wave[@]}"; do expect "$i" "${names[i % 3]}" "${codes[i % 3]}" "${said[i % 3]}"; done
done

# What is ignored stays so: a script that runs flatray beside itself keeps it from its own Ctrl-C.
(trap '' INT && exec "$flatray" query never 2> deaf.err) &
pid=$!
for _ in {1..100}; do
  listens $pid && break
  sleep 0.02
done
kill -INT $pid
sleep 0.1
kill -0 $pid || fail "SIGINT was ignored and ended it"
kill -TERM $pid
wait $pid
(($? == 143)) || fail "SIGTERM after an ignored SIGINT"
finish
