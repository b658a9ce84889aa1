#!/usr/bin/env bash
# `flatray help VERB` and the lines of `flatray schema` are as committed in tests/cli/help, so that no option, name,
# range or default is lost unseen. What changes on purpose: HELP_TEXTS=keep bash tests/cli/help_texts.sh FLATRAY ROOT,
# and a line in CHANGELOG.md.
source "$(dirname "$0")/lib.sh"
kept=$root/tests/cli/help

# expect FILE: standard input is what the file holds.
expect() {
  cat > now.txt
  [[ ${HELP_TEXTS:-} == keep ]] && cp now.txt "$kept/$1"
  diff -u "$kept/$1" now.txt || fail "$1 has changed"
}

verbs=$("$flatray" list verbs | awk '{ print $1 }')
for verb in $verbs; do expect "$verb.txt" < <("$flatray" help "$verb"); done
for file in "$kept"/*.txt; do
  verb=$(basename "$file" .txt)
  [[ $verb == schema_lines || -f $root/src/app/verbs/$verb.cpp ]] || fail "$verb.txt is of no verb"
done

# A build that leaves parts out has a smaller schema.
whole=yes
for kind in shapes lamps materials; do
  [[ $("$flatray" list $kind | awk '{ print $1 }' | LC_ALL=C sort) == \
    "$(basename -as .cpp "$root/src/scene/$kind"/*.cpp | LC_ALL=C sort)" ]] || whole=no
done
[[ $whole == no ]] ||
  expect schema_lines.txt < <("$flatray" schema | sed 's/^ *//; s/,$//' | LC_ALL=C sort | uniq -c)
finish
