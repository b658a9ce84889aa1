#!/usr/bin/env bash
# compile_flags.sh BUILD: every source is compiled without fused multiply-add, and none with flags that change the bits.
set -euo pipefail

commands=$(grep '"command":' "$1/compile_commands.json")
fused=$(grep -vF -e ' -ffp-contract=off ' <<<"$commands" || true)
loose=$(grep -E -e ' -(ffast-math|Ofast|march=native|funsafe-math[a-z-]*|mfma) ' <<<"$commands" || true)
echo "compile flags: $(wc -l <<<"$commands") sources"
[[ -z $fused ]] || { echo "without -ffp-contract=off:"; echo "$fused"; exit 1; }
[[ -z $loose ]] || { echo "with flags that change the bits:"; echo "$loose"; exit 1; }
