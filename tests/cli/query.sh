#!/usr/bin/env bash
# Questions as lines: order, errors that do not stop the rest, a conversation, memory.
source "$(dirname "$0")/lib.sh"

question() { # ID Y
  echo "{\"id\":$1,\"op\":\"clip\",\"polygon\":[[0,0],[4,0],[4,4],[0,4]],\"origin\":[-1,$2],\"direction\":[1,0]}"
}

question 1 2 > one.jsonl
run 0 query one.jsonl
says out '"id":1,"class":"through","t_enter":1,"t_exit":5,"edge_enter":3,"edge_exit":1'

# A line that is no question is answered as such, and the rest go on.
{ question 1 2; echo 'no question'; question 3 4; printf '%s' "$(question 4 5)"; } > mixed.jsonl
run 1 query mixed.jsonl
says out '"error":"column 2: no JSON'
says out '"id":3,"class":"along"'
says out '"id":4,"class":"miss"'
[[ $(wc -l < out.txt) == 4 ]] || fail "four lines, $(wc -l < out.txt) answers"

# Nor does a line above 16 MB end the stream, or take more room than one of 16 MB.
{ question 1 2; head -c 40000000 /dev/zero | tr '\0' '['; echo; question 3 4; head -c 17000000 /dev/zero | tr '\0' '['; } > long.jsonl
run 1 query long.jsonl
[[ $(grep -c '"error":"a line holds 16777216 bytes at most"' out.txt) == 2 ]] || fail 'a long line is not answered'
[[ $(wc -l < out.txt) == 4 ]] || fail "four lines, $(wc -l < out.txt) answers"
says out '"id":3,"class":"along"'
if [[ -z $sanitizers ]]; then
  (ulimit -v 100000 && "$flatray" query long.jsonl) | cmp - out.txt || fail 'in 100 MB of address space'
fi
rm long.jsonl

# Without MPFR nothing is read.
if "$flatray" query --precision certified /dev/null 2> none.txt; then
  run 0 query --precision certified one.jsonl
else
  run 5 query --precision certified one.jsonl
  says err 'MPFR'
fi

run 3 query nowhere.jsonl
says err 'nowhere.jsonl'
run 2 query one.jsonl mixed.jsonl

# Any number of threads, a pipe as well as a file: the same answers in the same order.
for ((i = 0; i < 5000; ++i)); do question "$i" "$((i % 7)).5"; done > many.jsonl
"$flatray" query many.jsonl > first.jsonl
[[ $(wc -l < first.jsonl) == 5000 ]] || fail 'an answer is missing'
for threads in 2 7; do
  "$flatray" query -j "$threads" many.jsonl | cmp - first.jsonl || fail "-j $threads answers otherwise"
done
"$flatray" query < many.jsonl | cmp - first.jsonl || fail 'standard input is answered otherwise'
"$flatray" query - < many.jsonl | cmp - first.jsonl || fail "'-' is answered otherwise"

# Who asks one question and waits gets its answer before asking the next.
coproc "$flatray" query
asked=$COPROC_PID  # gone from COPROC_PID as soon as it ends
for id in 1 2 3; do
  question "$id" 2 >&"${COPROC[1]}"
  read -r -t 60 line <&"${COPROC[0]}" || fail "no answer to question $id"
  [[ $line == *"\"id\":$id,"* ]] || fail "to question $id: $line"
done

exec {COPROC[1]}>&-
wait "$asked"

# An answer does not wait for those to questions after it, which take minutes.
question 1 2 > slow.jsonl
for ((i = 0; i < 100; ++i)); do
  echo '{"op":"orbit","walls":[{"circle":{"center":[0,0],"radius":1}},{"circle":{"center":[0.1,0.2],"radius":0.3}}],"origin":[0.9,0.1],"direction":[0.3,1],"bounces":1000000}'
done >> slow.jsonl
coproc SLOW { exec "$flatray" query slow.jsonl 2> none.txt; }
read -r -t 30 line <&"${SLOW[0]}" || fail 'an answer waits for slow questions after it'
[[ $line == *'"id":1,'* ]] || fail "before slow questions: $line"
kill "$SLOW_PID"
wait "$SLOW_PID" 2> none.txt

# Between periodic walls, proven as well where there is MPFR.
echo '{"op":"orbit","walls":[{"circle":{"center":[0,0],"radius":0.5}}],"cell":[[-1,-1],[1,-1],[1,1],[-1,1]],"origin":[0.75,0],"direction":[1,0],"bounces":2}' > cell.jsonl
run 0 query cell.jsonl
says out '"cells":[[1,0],[0,0]],"lattice":[[2,0],[0,2]],"certain":2'
if "$flatray" query --precision certified /dev/null 2> none.txt; then
  run 0 query --precision certified cell.jsonl
  says out '"points":[[-0.5,0],[0.5,0]],"end":"limit","out":null,"cells":[[1,0],[0,0]],"lattice":[[2,0],[0,2]],"certain":2'
fi

# A disc stands in every cell at exact vectors of the lattice from itself, whatever doubles make of its centre there: the first
# ray passes by it at 2^-53, and the points of the second are those of 300 digits.
cat > exact_cell.jsonl << 'JSON'
{"op":"orbit","cell":[[0,0],[4,0],[4,4],[0,4]],"walls":[{"circle":{"center":[3.3306690738754696e-16,2],"radius":1.0000000000000002}}],"origin":[3,0.5],"direction":[0,1],"bounces":1}
{"op":"orbit","cell":[[-1.01953125,0.0830078125],[-0.639892578125,-0.7998046875],[0.081298828125,-1.074462890625],[1.01953125,-0.0830078125],[0.639892578125,0.7998046875],[-0.081298828125,1.074462890625]],"walls":[{"circle":{"center":[-0.6686327616612555,-0.6698347058756978],"radius":0.5450031853850711}}],"origin":[-0.13507262052475966,0.2887664743587428],"direction":[0.5941061349832164,-0.8043866609879258],"bounces":2}
JSON
run 0 query exact_cell.jsonl
says out '"certain":0'
if "$flatray" query --precision certified /dev/null 2> none.txt; then
  run 0 query --precision certified exact_cell.jsonl
  says out '{"walls":[],"points":[],"end":"escape","out":[0,1],"cells":[]'
  says out '[-0.0756528513740949,0.6605155402395749]]'
fi

# 11 MB of questions in 30 MB of address space.
if [[ -z $sanitizers ]]; then
  many() { local i; for ((i = 0; i < 20; ++i)); do cat many.jsonl; done; }
  count=$(many | (ulimit -v 30000 && "$flatray" query) | wc -l)
  ((count == 100000)) || fail "100 000 questions, $count answers"
fi
finish
