#!/usr/bin/env bash
# compile_flags.sh BUILD: in no source the compiler fuses multiplications and additions, or has other flags that change the
# bits. Kernels may be compiled for machines that fuse: they say where.
set -euo pipefail

commands=$(grep '"command":' "$1/compile_commands.json")
fused=$(grep -vF -e ' -ffp-contract=off ' <<<"$commands" || true)
loose=$(sed -E 's, -mfma( .*/kernels/avx(2|512)\.cpp),\1,' <<<"$commands" |
  grep -E -e ' -(ffast-math|Ofast|march=native|funsafe-math[a-z-]*|mfma) ' || true)
echo "compile flags: $(wc -l <<<"$commands") sources"
[[ -z $fused ]] || { echo "without -ffp-contract=off:"; echo "$fused"; exit 1; }
[[ -z $loose ]] || { echo "with flags that change the bits:"; echo "$loose"; exit 1; }
