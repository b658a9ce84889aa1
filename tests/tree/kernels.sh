#!/usr/bin/env bash
# kernels.sh BUILD: what the kernel objects of each instruction-set tier hold.
#   - no weak symbol: the linker keeps one copy of those, and it could be one this machine cannot run
#   - zmm registers in avx512 and only there, ymm in avx2 and never below
# Exit code 77 (skipped) where the build has no such objects to look into.
set -euo pipefail

tiers=(portable baseline avx2 avx512)
skip() { echo "skipped: $1"; exit 77; }
[[ $(uname -m) == x86_64 ]] || skip "tiers are of x86-64"
command -v nm >/dev/null && command -v objdump >/dev/null || skip "no nm, objdump (binutils)"

failures=0
fault() { echo "$1"; failures=$((failures + 1)); }
count() { objdump -d --no-show-raw-insn "$1" | grep -cE "%$2[0-9]" || true; }

folders=0
while IFS= read -r folder; do
  folders=$((folders + 1))
  for tier in "${tiers[@]}"; do
    object=$folder/$tier.cpp.o
    [[ -f $object ]] || { fault "$object: missing"; continue; }
    weak=$(nm -C "$object" | grep -E ' [WVuvw] ' || true)
    [[ -z $weak ]] || fault "$object: weak symbols"$'\n'"$weak"
    ymm=$(count "$object" ymm) zmm=$(count "$object" zmm)
    echo "$tier: $ymm instructions with ymm, $zmm with zmm: ${folder##*CMakeFiles/}"
    case $tier in
      portable | baseline) ((ymm + zmm == 0)) || fault "$object: registers beyond its tier" ;;
      avx2) ((ymm > 0 && zmm == 0)) || fault "$object: must use ymm, and no zmm" ;;
      avx512) ((zmm > 0)) || fault "$object: must use zmm" ;;
    esac
  done
done < <(find "$1/src" -name 'avx512.cpp.o' -printf '%h\n' | sort)
echo "kernels: $folders folders, $failures faults"
((folders > 0)) || fault 'no kernel object in this build'
((failures == 0))
