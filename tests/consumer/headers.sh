#!/usr/bin/env bash
# headers.sh COMPILER INCLUDE: each header of INCLUDE/flatray compiles alone without a warning, is at most 20 000 lines
# when preprocessed (or 1500 more than <span> and <vector>, which with g++ 14 are more than that alone), and takes nothing
# but itself and the standard library. Prints the lines of each.
set -euo pipefail
compiler=$1 include=$2

lines_of() { grep -vcE '^(#|[[:space:]]*$)' <<<"$1" || true; }  # of none grep fails
standard=$(printf '#include <%s>\n' span vector | "$compiler" -std=c++20 -E -x c++ -)
limit=$(($(lines_of "$standard") + 1500))
((limit > 20000)) || limit=20000
failures=0
fault() { echo "$1"; failures=$((failures + 1)); }

headers=("$include"/flatray/*.h)
for wanted in trace collide transport picture; do
  [[ -e $include/flatray/$wanted.h ]] || fault "flatray/$wanted.h is not installed"
done
others=$(find "$include" -type f -not -path "$include/flatray/*.h")
[[ -z $others ]] || fault "installed beside the headers of flatray: $others"
for header in "${headers[@]}"; do
  name=flatray/${header##*/}
  text=$(echo "#include <$name>" | "$compiler" -std=c++20 -E -I "$include" -x c++ -)
  lines=$(lines_of "$text")
  echo "$name: $lines lines"
  ((lines <= limit)) || fault "$name: more than $limit lines when preprocessed"
  finds=$(grep -E '^# [0-9]+ "[^"]*/(eigen3|Eigen|fmt|tl|gmp|mpfr|nlohmann|toml)' <<<"$text" | head -3 || true)
  [[ -z $finds ]] || fault "$name: takes another library: $finds"
  finds=$(grep -nE '(Eigen|fmt|tl)::|mpz_' <<<"$text" | head -3 || true)
  [[ -z $finds ]] || fault "$name: names another library: $finds"
  echo "#include <$name>" | "$compiler" -std=c++20 -fsyntax-only -I "$include" -Wall -Wextra -Wpedantic -Wshadow \
    -Wconversion -Werror -x c++ - || fault "$name: does not compile alone"
  if [[ $name != flatray/owned.h ]]; then  # which computes nothing
    finds=$(echo "#include <$name>" | "$compiler" -std=c++20 -fsyntax-only -ffast-math -I "$include" -x c++ - 2>&1 || true)
    [[ $finds == *"compile without -ffast-math"* ]] || fault "$name: compiles with -ffast-math"
  fi
done
((${#headers[@]} > 0 && failures == 0))
