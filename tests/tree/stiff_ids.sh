#!/usr/bin/env bash
# stiff_ids.sh ROOT: every stiff case delivered so far is a test by its number. Prints the missing ones.
# A test is TEST(Suite, A7...) in a source under tests/, or a number in a file name under tests/cli (e1_empty_scene).
set -euo pipefail
cd "$1/tests"

ids=(A{1..16} B{1..13} C{1..32} D{1..9} E{1..11} F{1..6})
names=$(
  find . -name '*_test.cpp' -exec cat {} + | tr '\n' ' ' |
    grep -oE 'TEST(_[PF])?\([A-Za-z0-9_]+,[[:space:]]*[A-Za-z0-9_]+' | sed -E 's/.*,[[:space:]]*//'
  find . -path './cli/*' -printf '%f\n' | sed 's/^./\U&/'
)
missing=()
for id in "${ids[@]}"; do
  grep -qE "^$id([^0-9]|\$)" <<<"$names" || missing+=("$id")
done
echo "stiff cases: ${#ids[@]} numbers, ${#missing[@]} without a test${missing[*]:+: ${missing[*]}}"
# The tests that the shipped catalogue names are there.
present=$(
  for module in */; do
    find "$module" -name "*_test.cpp" -exec cat {} + | tr '\n' ' ' | grep -oE 'TEST\([A-Za-z0-9_]+,[[:space:]]*[A-Za-z0-9_]+' |
      sed -E "s/^TEST\(/${module%/}./; s/,[[:space:]]*/./" || true
  done
  find cli -name '*.sh' | sed 's,/,.,; s/\.sh$//'
)
mapfile -t gone < <(
  grep -ohE '"(cli\.e[0-9]+_[a-z_]+|[a-z]+\.[A-Za-z]+\.[A-F][0-9]+[A-Za-z0-9]*)"' ../src/oracle/catalogue*.cpp |
    tr -d '"' | sort -u | grep -vxFf <(echo "$present")
)
echo "tests that the catalogue names: ${#gone[@]} are not there${gone[*]:+: ${gone[*]}}"
((${#missing[@]} + ${#gone[@]} == 0))
