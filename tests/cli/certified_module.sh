#!/usr/bin/env bash
# needs: shapes/circle
# Certified orbits are a module that the program does not link: what holds whether or not it is built.
source "$(dirname "$0")/lib.sh"
sinai=$root/scenes/chamber/sinai.toml

# A module that is not there, or is none, is exit 5, with what to install; orbits in doubles go on without it.
FLATRAY_CERTIFIED_MODULE=absent.so run 5 orbit "$sinai" -n 3 --precision certified
says err "absent.so is not there"
says err "tools/setup"
silent out
echo 'no library' > wrong.so
FLATRAY_CERTIFIED_MODULE=$PWD/wrong.so run 5 orbit "$sinai" -n 3 --precision certified
says err "wrong.so"
FLATRAY_CERTIFIED_MODULE=absent.so run 5 query --precision certified < /dev/null
FLATRAY_CERTIFIED_MODULE=absent.so run 0 orbit "$sinai" -n 3

# A library of another name is no module of ours.
math=$(ldd "$flatray" | awk '/libm\.so/ { print $3 }')
FLATRAY_CERTIFIED_MODULE=$math run 5 orbit "$sinai" -n 3 --precision certified
says err "is not a module of flatray"

# Neither MPFR nor the module is linked, and a render loads neither.
readelf -d "$flatray" | grep NEEDED | grep -qE 'mpfr|flatray_certified' && fail "flatray links MPFR"
LD_DEBUG=files "$flatray" render "$sinai" -f 1 -o one.png 2>&1 | grep -qE 'mpfr|flatray_certified' && fail "a render loads MPFR"
exists one.png
finish
