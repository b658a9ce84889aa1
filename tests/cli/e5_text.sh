#!/usr/bin/env bash
# needs: formats/obj formats/list
# A line of 100 MB and ten million objects are read, or refused with one line, in bounded memory.
source "$(dirname "$0")/lib.sh"
limit_memory 2500000

bytes() { head -c "$1" /dev/zero | tr '\0' "$2"; }  # bytes COUNT BYTE

{ printf 'v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n#'; bytes 100000000 x; } > comment.obj
run 0 check comment.obj
{ printf 'v 0 0\nv '; bytes 100000000 1; } > number.obj
run 4 check number.obj
says err "number.obj:2:3: error: '1111111111111111111111111111111111111111' is not a finite number"
{ printf 'v 0 0\nv 1 0\nv 0 1\nf'; yes ' 1 2 3' | head -n 16000000 | tr -d '\n'; } > face.obj
run 4 check face.obj
says err "face.obj:4:1: error: 'f' has more than 1000000 vertices"
{ printf 'v 0 0\nv 1 0\nv 0 1\n'; yes 'f 1 2 3' | head -n 10000000; } > faces.obj
run 0 check faces.obj
rm -f ./*.obj

yes 'A, 1, 2' | head -n 10000000 > many.list
run 4 check many.list
says err "many.list:1000001:1: error: the list has more than 1000000 objects"
{ bytes 100000000 A; printf ', 1, 2\n'; } > long.list
run 4 check long.list
rm -f ./*.list

{ printf 'flatray = 1\n#'; bytes 100000000 x; } > comment.toml
run 4 check comment.toml
says err "the scene is 100000013 bytes long"
{ printf 'flatray = 1\nx = "'; bytes 60000000 x; printf '"'; } > string.toml
run 4 check string.toml
{ printf 'flatray = 1\n'; yes '[[a]]' | head -n 10000000; } > many.toml
run 4 check many.toml
says err "the scene holds"
{ printf 'flatray = 1\nx = ['; yes '1,' | head -n 10000000 | tr -d '\n'; printf ']'; } > values.toml
run 4 check values.toml
says err "values"
for err in out.txt err.txt; do (($(wc -c < "$err") < 2000)) || fail "std$err is long"; done
finish
