#!/usr/bin/env bash
# Rows a chunk, runs that go on, mistakes of the command line.
source "$(dirname "$0")/lib.sh"

run 0 stability --families vertex,edge --count 16384 -o log
says out 'vertex'
[[ $(wc -l < log/stability.csv) -gt 2 ]] || fail 'no row for each tracer and family'

# As many rays as are asked for, and of a part of a chunk a row, which more rays take the place of.
run 0 stability --families vertex --count 1 --tracer brute,grid -o few
[[ $(awk 'NR > 1 { print $4 }' "$work/out.txt" | tr '\n' ' ') == '1 1 ' ]] || fail 'one ray was asked for'
run 0 stability --families vertex --count 16385 --tracer grid -o few
[[ $(awk 'NR > 1 { print $4 }' "$work/out.txt") == 16385 ]] || fail 'one ray more than a chunk was asked for'
[[ $(grep '^vertex,grid,' few/stability.csv | cut -d, -f5,6 | tr '\n' ' ') == '0,1 0,16384 1,1 ' ]] || fail 'rows are not of the rays asked for'
run 0 verify few
cp -r few torn
truncate -s -7 torn/stability.csv
run 1 verify torn
says out 'torn/stability.csv: ends within a line'
run 2 stability --families vertex --count 1 --seed 18446744073709551616
says err '18446744073709551616 is out of range'

# What is logged is not done again, and more of it only adds rows.
cp log/stability.csv before.csv
run 0 stability --families edge,vertex --count 10 -o log
says out ' 16384 ' # more is there
cmp -s before.csv log/stability.csv || fail 'chunks were done again'
run 0 stability --families vertex --tracer brute --count 20000 -o log
head -n "$(wc -l < before.csv)" log/stability.csv | cmp -s - before.csv || fail 'earlier rows changed'
[[ $(grep -c '^vertex,brute,[a-z0-9]*,1,' log/stability.csv) == 2 ]] || fail 'the second chunk is missing'

# Counts are those of any number of threads.
run 0 stability --families n-gon --count 40000 -j 1 -o one
run 0 stability --families n-gon --count 40000 -j 3 -o three
cmp -s <(cut -d, -f1-11 one/stability.csv | sort) <(cut -d, -f1-11 three/stability.csv | sort) \
  || fail 'counts depend on the threads'

# A tier has rows of its own, and counts what the others count.
run 0 stability --families circles --tracer grid,brute --tiers portable,baseline --count 1000 -o tiers
for tier in portable baseline; do
  grep -qE "^circles +brute +$tier +1000 " "$work/out.txt" || fail "no row of $tier"
  grep ",$tier," tiers/stability.csv | cut -d, -f1,2,4-11 | sort > "$tier.csv"
done
[[ $(wc -l < portable.csv) == 2 ]] && cmp -s portable.csv baseline.csv || fail 'tiers do not count the same'
run 2 stability --pairs 10 --tiers portable
says err 'is about the families of inputs'
run 2 stability --tiers sse
says err 'there are: portable, baseline'

# The mean of the times of all chunks lies between the least and the most of them, which one chunk does not have.
run 0 stability --families n-gon --tracer grid --count 40000 -o one
awk 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
     { split($at["ns_of_chunks"], range, "[.][.]"); mean = $at["ns_a_query"] + 0
       exit !(NF > 5 && range[1] + 0 <= mean && mean <= range[2] + 0 && range[2] != "") }' "$work/out.txt" ||
  fail 'the range of the chunks does not hold their mean'
run 0 stability --families n-gon --tracer grid --count 10
says out ' unknown '

# A row cut short by a full disk is done again.
truncate -s -3 one/stability.csv
run 0 stability --families n-gon --count 40000 -o one
cmp -s <(cut -d, -f1-11 one/stability.csv | sort) <(cut -d, -f1-11 three/stability.csv | sort) \
  || fail 'a torn row was not done again'
# Where all rows are there, what is left of one more is cut off.
cp one/stability.csv whole.csv
printf 'n-gon,grid' >> one/stability.csv
run 0 stability --families n-gon --count 40000 -o one
cmp -s whole.csv one/stability.csv || fail 'a torn row was left'
run 0 verify one

# What is not exact is counted, and called wrong.
run 1 stability --families vertex --count 10 --tracer float
says out 'float'

# Sealed rooms: no ray gets out, by any exact tracer.
run 0 stability --leaks 1000 --tracer grid  # 1.6 million bounces
says out 'round-scaled-by-1e15'
[[ $(awk 'NR > 1 { leaks += $5 } END { print leaks }' "$work/out.txt") == 0 ]] || fail 'a ray leaked'
run 2 stability --leaks 10 --families vertex
run 2 stability --count 10 --places origin

# They go on, too, and keep what they had counted.
run 1 stability --leaks 1024 --tracer float --places origin -o rooms
cp "$work/out.txt" once.txt
cp rooms/leaks.csv once.csv
run 1 stability --leaks 1024 --tracer float --places origin -o rooms
cmp -s once.txt "$work/out.txt" || fail 'counts were lost'
cmp -s once.csv rooms/leaks.csv || fail 'blocks were done again'
run 1 stability --leaks 1025 --tracer float --places origin -o rooms
[[ $(wc -l < rooms/leaks.csv) == 3 ]] || fail 'one block, and one more, are two rows'

# However many blocks are asked for, memory is of those at work.
endless() {  # FILE ARGS...: stopped when it has a row of what was done
  (limit_memory 2000000; exec "$flatray" stability "${@:2}" -j 2 -o endless > out.txt 2> err.txt) &
  local rows=()
  for _ in {1..3000}; do
    [[ ! -e endless/$1 ]] || mapfile -t rows < "endless/$1"
    ((${#rows[@]} < 2)) || break
    sleep 0.02
  done
  ((${#rows[@]} > 1)) || fail "no row in $1 of what was done"
  kill $!
  wait $!
  (($? == 143)) || fail "stability ${*:2}: ended before it was stopped"
}
endless leaks.csv --leaks 1099511627776 --places origin
endless stability.csv --pairs 1099511627776 --families grid

# Moving pairs, of chosen families; a run goes on where its log ends.
run 0 stability --pairs 1024 --families grid,turning-squares -o pairs
[[ $(wc -l < pairs/stability.csv) == 4 ]] || fail 'a row for each method of each chunk and the head'
run 0 stability --pairs 2000 --families grid -o pairs
[[ $(wc -l < pairs/stability.csv) == 6 ]] || fail 'only the second chunk is new'
says out ' 2000 '
run 2 stability --pairs 1 --families vertex
says err 'turning-grazing'

run 2 stability --families vertx
says err "did you mean 'vertex'?"
run 2 stability --tracer none
FLATRAY_EMBREE_MODULE=absent.so run 5 stability --tracer embree --count 10
says err 'the module absent.so is not there'
run 2 stability --count 0
# Rows that are none of a run are told by their line.
{ head -n 1 one/stability.csv; sed -n 2p one/stability.csv | cut -d, -f1-29; } > row.csv # without its hash, that only fields are wrong
refuses() { # FIELD VALUE
  mkdir -p false
  awk -F, -v OFS=, -v f="$1" -v v="$2" 'NR == 2 { $f = v } 1' row.csv > false/stability.csv
  run 6 stability --families n-gon --count 10 -o false
  says err "false/stability.csv:2: error: is not a row that this program writes"
}
[[ $(head -n 1 row.csv) == family,tracer,isa,seed,chunk,rays,hits,wrong,*,seconds,* ]] || fail 'the columns are others'
seconds=$(head -n 1 row.csv | tr , '\n' | grep -n '^seconds$' | cut -d: -f1)
refuses 7 99999
refuses 8 99999
refuses 6 18446744073709551615
refuses 6 16385
refuses "$seconds" nan
refuses "$seconds" -5
refuses "$seconds" soon
refuses 1 '#n-gon'
sed '2s/,#[0-9a-f]*$//' rooms/leaks.csv | sed '2s/^\([^,]*,[^,]*,[^,]*,[^,]*,[^,]*\),[0-9]*/\1,1025/' > false/leaks.csv
run 6 stability --leaks 10 --tracer float --places origin -o false
says err 'false/leaks.csv:2: error: is not a row that this program writes'
# So are columns of other builds.
mkdir -p columns
cut -d, -f1-28,30 log/stability.csv > columns/stability.csv
run 6 stability --families vertex --count 10 -o columns
says err "columns/stability.csv:1: error: is not a row that this program writes"
run 0 stability --families vertex --count 10 -o columns --force
[[ $(head -n 1 columns/stability.csv) == "$(head -n 1 log/stability.csv)" ]] || fail 'the columns are still those of another build'
# A row with a count that a run may have had, and has not, is told by its hash.
cp -r log changed
sed -i '2s/,16384,/,16383,/' changed/stability.csv
run 1 verify changed
says out 'changed/stability.csv:2: is not a row that this program writes'
run 6 stability --families vertex --count 10 -o changed
says err 'changed/stability.csv:2: error: is not a row that this program writes'
echo 'nonsense' >> log/stability.csv
run 6 stability --families vertex --count 10 -o log
says err 'stability.csv:'
run 1 verify log
run 0 stability --families vertex --count 10 -o log --force
run 0 verify log
says out "log: $(($(wc -l < log/stability.csv) - 1)) record"
finish
