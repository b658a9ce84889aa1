#!/usr/bin/env bash
# figures.sh ROOT FLATRAY: figures in the documents are those of docs/measured/figures.txt, and commands they name are there.
# 1. A citation [VALUE](...figures.txt#ID) has the value of row ID; every row is cited; a row has an id of its own.
# 2. A row of kind `exact` is what its command prints, run here. One of kind `once` names the machine.
# 3. Goals S1 to S15 have figures in the rows of PERFORMANCE's tables alone; who names a goal elsewhere cites.
# 4. Verbs, options, scenes, benchmarks, tools and tests that the documents name exist.
# 5. Each part of PERFORMANCE and of docs/measured names the command of its figures.
set -euo pipefail
root=$1 flatray=$2
cd "$root"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin" && ln -s "$flatray" "$work/bin/flatray"
export PATH=$work/bin:$PATH
failures=0
fault() { echo "$1"; failures=$((failures + 1)); }
table=docs/measured/figures.txt
mapfile -t documents < <(ls README.md CONTRIBUTING.md docs/*.md docs/measured/*.md)

declare -A value_of
while IFS= read -r row; do
  row=${row// :: /$'\x1f'}  # one character that no command has, so that read can split
  IFS=$'\x1f' read -r id value kind command machine <<<"$row"
  [[ -z ${value_of[$id]:-} ]] || fault "$table: $id stands there twice"
  value_of[$id]=$value
  case $kind in
    exact)
      printed=$(bash -c "$command" 2>"$work/err.txt" || true)
      [[ $printed == "$value" ]] || fault "$table: $id is $value; '$command' prints '$printed' $(head -1 "$work/err.txt")" ;;
    once) [[ -n $machine ]] || fault "$table: $id: of which machine?" ;;
    *) fault "$table: $id: a figure is exact or once, not '$kind'" ;;
  esac
done < <(grep ' :: ' "$table" | grep -v 'ID :: VALUE')

citations=0
declare -A cited
while IFS=: read -r file line link; do
  citations=$((citations + 1))
  value=${link%%]*} value=${value#[} id=${link##*#} id=${id%)}
  cited[$id]=1
  [[ $value == "${value_of[$id]:-missing}" ]] ||
    fault "$file:$line: says $value of $id, which is ${value_of[$id]:-no figure} in $table"
done < <(grep -noE '\[[^][]*\]\([^) ]*figures\.txt#[^)]*\)' "${documents[@]}" docs/adr/*.md)
for id in "${!value_of[@]}"; do
  [[ -n ${cited[$id]:-} ]] || fault "$table: nobody cites $id"
done

# A goal outside of its tables: no number beside it that is no citation.
while IFS=: read -r file line text; do
  bare=$(sed -E 's/\[[^][]*\]\([^)]*\)//g; s/\bS[0-9]+\b//g; s/`[^`]*`//g' <<<"$text")
  ! grep -qE '[0-9]+\.[0-9]+|[0-9] (times|ns)\b' <<<"$bare" ||
    fault "$file:$line: a figure of a goal stands here by itself: cite $table"
done < <(grep -nE '\bS[0-9]+\b' "${documents[@]}" | grep -vE '^[^:]*:[0-9]+:(\| S[0-9]+ \||#)')
mapfile -t repeated < <(grep -ohE '^\| S[0-9]+ \|[^|]*\|' docs/PERFORMANCE.md | sort | uniq -d)
for row in "${repeated[@]}"; do fault "docs/PERFORMANCE.md: two rows of one goal: $row"; done

# Commands: code in backquotes, and lines of fences that start with flatray.
verbs=$("$flatray" help | sed -nE 's/^  ([a-z]+) .*/\1/p')
declare -A help_of
commands=0
while IFS=: read -r file line command; do
  read -r _ verb rest <<<"$command"
  [[ $verb =~ ^[a-z]+$ ]] || continue
  commands=$((commands + 1))
  grep -qx "$verb" <<<"$verbs" || { fault "$file:$line: flatray has no verb $verb"; continue; }
  [[ -n ${help_of[$verb]:-} ]] || help_of[$verb]=$("$flatray" help "$verb")
  for flag in $(grep -oE '(^| )--[a-z-]+' <<<"${rest%%#*}" || true); do
    grep -qE -e "$flag( |$)" <<<"${help_of[$verb]}" || fault "$file:$line: flatray $verb has no option $flag"
  done
done < <(awk 'FNR == 1 { code = 0 } /^```/ { code = !code; next }
  { place = FILENAME ":" FNR ":" }
  code || /^    / { if (match($0, /^ *(\$ )?flatray [a-z].*/)) { sub(/^ *(\$ )?/, ""); print place $0 } next }
  { while (match($0, /`flatray [a-z][^`]*`/)) { print place substr($0, RSTART + 1, RLENGTH - 2); $0 = substr($0, RSTART + RLENGTH) } }' "${documents[@]}")
while IFS=: read -r file line path; do
  compgen -G "$path" >/dev/null || compgen -G "$path.*" >/dev/null || fault "$file:$line: $path is not there"
done < <(grep -noE '\b(scenes|benchmarks|tools|tests)/[a-zA-Z0-9_/.-]*[a-zA-Z0-9_]' "${documents[@]}")

# Parts and their commands.
while read -r fault_found; do fault "$fault_found"; done < <(
  awk 'function close_part() { if (part != "" && !named) print place ": no command is named for: " part }
       FNR == 1 { close_part(); part = "" }
       /^## / || /^\*\*[A-Z]/ { close_part(); part = $0; named = 0; place = FILENAME ":" FNR }
       /\]\([a-z]+\.(md|txt)\)/ { named = 1 }  # which is looked at by itself
       /`?(flatray|benchmarks\/|tools\/|tests\/|build\/|oracle\/|coverage_check|mesh_check|FLATRAY_FULL_COUNTS)/ { named = 1 }
       END { close_part() }' docs/PERFORMANCE.md docs/measured/*.md)
echo "figures kept: ${#value_of[@]}, citations: $citations, commands named: $commands, faults: $failures"
((failures == 0))
