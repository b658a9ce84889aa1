#!/usr/bin/env bash
# A scene without objects is its background.
source "$(dirname "$0")/lib.sh"
printf 'flatray = 1\nfilm = { size = [40, 30], background = "#336699" }\n' > empty.toml
run 0 render empty.toml
silent out
exists out/empty.png
[[ $(size_of out/empty.png) == 40x30 ]] || fail "size $(size_of out/empty.png)"
printf 'flatray = 1\nfilm = { size = [40, 30], background = "#336698" }\n' > other.toml
run 0 render other.toml
cmp -s out/empty.png out/other.png && fail "one level of the background does not show"
printf 'flatray = 1\n' > nothing.toml
run 0 render nothing.toml
exists out/nothing.png
: > zero.toml
run 4 check zero.toml
finish
