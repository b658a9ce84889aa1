#!/usr/bin/env bash
# documents.sh ROOT: README stays short and keeps its two commands; every relative link of a document leads somewhere,
# and every document that the sources name is there.
set -euo pipefail
cd "$1"

failures=0
fault() { echo "$1"; failures=$((failures + 1)); }

lines=$(wc -l <README.md)
((lines <= 150)) || fault "README.md: $lines lines, at most 150"
for preset in demo test; do
  count=$(grep -cxF "tools/setup && cmake --workflow --preset $preset" README.md || true)
  ((count == 1)) || fault "README.md: the command of preset $preset stands there $count times, not once"
done

links=0
while IFS=: read -r file line link; do
  links=$((links + 1))
  target=${link#*](}; target=${target%)}; target=${target%%#*}
  [[ -z $target || $target == *://* || -e $(dirname "$file")/$target ]] || fault "$file:$line: leads nowhere: $target"
done < <(grep -noE '\]\([^) ]+\)' README.md CONTRIBUTING.md CHANGELOG.md $(find docs scenes -name '*.md' 2>/dev/null) /dev/null)
while IFS=: read -r file line target; do
  links=$((links + 1))
  [[ -e $target ]] || fault "$file:$line: names what is not there: $target"
done < <(grep -rnoE 'docs/[A-Za-z0-9_/-]+\.md' src tests tools benchmarks)
echo "documents: $links links, $failures faults"
((failures == 0))
