#!/usr/bin/env bash
# cli_ends.sh ROOT: every script of tests/cli ends with `finish`, which leaves it: what stands below is never run.
set -euo pipefail
cd "$1/tests/cli"

failures=0 scripts=0
for script in *.sh; do
  [[ $script == lib.sh ]] && continue
  scripts=$((scripts + 1))
  line=$(grep -nx finish "$script" | head -n 1 | cut -d: -f1 || true)
  [[ ${line:-0} == "$(wc -l <"$script")" ]] && continue
  echo "tests/cli/$script:${line:-1}: must end with its one 'finish'"
  failures=$((failures + 1))
done
echo "cli_ends: $scripts scripts, $failures faults"
((failures == 0))
