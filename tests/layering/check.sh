#!/usr/bin/env bash
# check.sh ROOT: fails when a file of ROOT/src/<module> includes a header of a module it may not know.
# Prints file:line of each such include.
set -euo pipefail

# What each module may include, besides itself; what those may include comes with them.
declare -A direct=(
  [base]=''
  [geom]='base'
  [trace]='geom'
  [image]='base'
  [scene]='geom'
  [anim]='scene trace'
  [collide]='anim'
  [transport]='anim image'
  [precise]='transport'
  [render]='transport collide image'
  [oracle]='transport'
  [study]='render oracle precise'
  [app]='study'
)

declare -A allowed
allow() {  # allow FOR MODULE: MODULE and all it may include
  [[ " ${allowed[$1]:-} " == *" $2 "* ]] && return
  allowed[$1]+=" $2"
  local next
  for next in ${direct[$2]}; do allow "$1" "$next"; done
}
for module in "${!direct[@]}"; do allow "$module" "$module"; done

cd "$1"
wrong=0
while IFS=: read -r file line include; do
  module=${file#src/}; module=${module%%/*}
  target=${include#*\"}; target=${target%%\"*}
  [[ $target == */* ]] || continue  # beside the file, or a generated table
  if [[ $target == flatray/* ]]; then  # a public header: of the module in whose folder it lies
    target=$(compgen -G "src/*/include/$target" || echo "src/$target"); target=${target#src/}
  fi
  target=${target%%/*}
  if [[ -z ${direct[$module]+known} ]]; then
    echo "$file:$line: module '$module' has no row in the table of tests/layering/check.sh"
  elif [[ -z ${direct[$target]+known} ]]; then
    continue  # a folder of the module itself
  elif [[ " ${allowed[$module]} " == *" $target "* ]]; then
    continue
  else
    echo "$file:$line: $module must not include $target (it may include:${allowed[$module]})"
  fi
  wrong=$((wrong + 1))
done < <(grep -rnE '^[[:space:]]*#[[:space:]]*include[[:space:]]*"' --include='*.h' --include='*.cpp' src)
while IFS= read -r upward; do
  echo "$upward: includes go down from src/, never up"
  wrong=$((wrong + 1))
done < <(grep -rnE '^[[:space:]]*#[[:space:]]*include[[:space:]]*"\.\./' --include='*.h' --include='*.cpp' src || true)
files=$(find src -name '*.h' -o -name '*.cpp' | wc -l)
echo "layering: $files files, $wrong wrong includes"
((wrong == 0))
