#!/usr/bin/env bash
# needs: formats/obj formats/list
# A line of 100 MB and ten million objects are read, or refused with one line, in bounded memory.
source "$(dirname "$0")/lib.sh"
limit_memory 2500000

# One line of 100 MB is that of all files here: each writes its start over the start of the one before, which is not longer.
long() { mv long.* "$1" && printf '%b' "$2" 1<> "$1"; }  # long FILE START
head -c 100000013 /dev/zero | tr '\0' 1 > long.list
printf ', 1, 2\n' >> long.list
run 4 check long.list
truncate -s 100000013 long.list
long long.1.obj 'v 0 0\nv '
run 4 check long.1.obj
says err "long.1.obj:2:3: error: '1111111111111111111111111111111111111111' is not a finite number"
long long.toml 'flatray = 1\n#'
run 4 check long.toml
says err "the scene is 100000013 bytes long"
long long.2.obj 'v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n#'
run 0 check long.2.obj
long long.string.toml 'flatray = 1\n     x = "111111'
truncate -s 60000000 long.string.toml
printf '"' >> long.string.toml
run 4 check long.string.toml
rm long.*

# ten_million LINE: a thousand lines, four times ten of what there is.
ten_million() {
  for _ in {1..1000}; do printf '%b' "$1"; done > lines
  for _ in 1 2 3 4; do
    cat lines lines lines lines lines lines lines lines lines lines > more
    mv more lines
  done
}
ten_million ' 1 2 3'
{ printf 'v 0 0\nv 1 0\nv 0 1\nf'; cat lines lines; } > face.obj
run 4 check face.obj
says err "face.obj:4:1: error: 'f' has more than 1000000 vertices"
ten_million 'f 1 2 3\n'
{ printf 'v 0 0\nv 1 0\nv 0 1\n'; cat lines; } > faces.obj
run 0 check faces.obj
rm ./*.obj
ten_million '[[a]]\n'
{ printf 'flatray = 1\n'; cat lines; } > many.toml
run 4 check many.toml
says err "the scene holds"
ten_million '1,'
{ printf 'flatray = 1\nx = ['; cat lines; printf ']'; } > values.toml
run 4 check values.toml
says err "values"
# An object of a list takes 2 KB: ten million would take 20 GB.
ten_million 'A, 1, 2\n'
mv lines many.list
limit_memory 500000
run 4 check many.list --max-entities 100000
says err "many.list:100001:1: error: the list has more than 100000 objects"
for err in out.txt err.txt; do (($(wc -c < "$err") < 2000)) || fail "std$err is long"; done
finish
