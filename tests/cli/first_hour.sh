#!/usr/bin/env bash
# Replays docs/FIRST_HOUR.md: its scene, each command with exactly what it prints, each edit.
# needs: formats/toml shapes/circle shapes/polygon
source "$(dirname "$0")/lib.sh"
page=$root/docs/FIRST_HOUR.md
scene=harbour.toml

# blocks: the page's blocks of code as files 01.toml, 02.console, 03.diff, ...
awk '/^```[a-z]+$/ { kind = substr($0, 4); file = sprintf("%02d.%s", ++count, kind); printf "" > file; next }
     /^```$/ { file = ""; next }
     file != "" { print > file }' "$page"

# edit FILE: each line -OLD is replaced by the line +NEW after it; both must be there, OLD once in the scene.
edit() {
  local line old
  while IFS= read -r line; do
    case $line in
      -*) old=${line#-} ;;
      +*)
        [[ $(grep -cxF -e "$old" "$scene") == 1 ]] || fail "$1: not once in the scene: $old"
        awk -v old="$old" -v new="${line#+}" '$0 == old { $0 = new } { print }' "$scene" > edited
        mv edited "$scene" ;;
    esac
  done < "$1"
}

replay() {
  local command printed
  command=$(sed -n 's/^\$ flatray //p' "$1")
  sed 1d "$1" > wanted.txt
  printed=$(eval "\"$flatray\" $command" 2>&1)
  diff <(printf '%s\n' "$printed" | sed '/^$/d') wanted.txt || fail "$1: flatray $command prints something else"
}

messages=0
for block in [0-9]*; do
  case $block in
    *.toml) cp "$block" "$scene" ;;
    *.diff) edit "$block" ;;
    *.console)
      replay "$block"
      messages=$((messages + $(grep -c ': error: ' "$block"))) ;;
  esac
done
((messages == 3)) || fail "the page shows $messages messages, not three"
exists out/frame_0001.png out/frame_0048.png
finish
