#!/usr/bin/env bash
# Whatever the texts of a scene hold and whatever was planted in the output folder, nothing outside of it is written.
source "$(dirname "$0")/lib.sh"
mkdir -p in/deep outside work/run
echo precious > outside/victim
echo precious > outside/manifest.jsonl

# Every text of the language is a path out; the file names try as well.
hostile() {  # hostile NAME
  printf 'flatray = 1\nframes = 2\nfilm = { size = [16, 12] }\n'
  printf '[[entity]]\nname = "%s"\nshape = { box = { min = [0, 0], max = [4, 3] } }\nfill = "#102030"\n' "$1"
  printf 'markov = { chain = "%s", start = "A" }\n' "$1"
  printf '[[chamber]]\nname = "%s"\nshape = { box = { min = [0, 0], max = [9, 9] } }\n' "$1"
  printf '[[ray]]\nname = "%s"\nat = [5, 5]\ndirection = [1, 2]\nbounces = 2\n' "$1"
  printf '[markov."%s"]\nA = { A = 1 }\n' "$1"
}
i=0
for name in '../outside/victim' '/etc/flatray_f3' '../../../../tmp/flatray_f3' '{scene}' '####' '%s%n' 'CON' '-rf' '.' '..' \
  '~/flatray_f3' '$(touch outside/pwned)' 'a/../../outside/b'; do
  i=$((i + 1))
  hostile "$name" > "in/deep/h$i.toml"
done
cp in/deep/h1.toml 'in/deep/...toml'
cp in/deep/h1.toml 'in/deep/..%2foutside.toml'
cp in/deep/h1.toml "in/deep/$(printf 'a\nb').toml"
cp in/deep/h1.toml 'in/deep/{scene}{scene}.toml'

# Links planted where files will be: each is refused, replaced by --force, never followed.
cd work/run || exit 1
mkdir -p here
for file in f_1.png f_2.png; do ln -s "$work/outside/victim" "here/$file"; done
for name in .f_1.png.1.part '.f_#.png.1234567812345678.part'; do ln -s "$work/outside/manifest.jsonl" "here/$name"; done

tree() { (cd "$work" && find . -mindepth 1 -path ./work/run -prune -o -not -name out.txt -not -name err.txt -printf '%p %s %l %T@\n' | sort); }
before=$(tree)
run 6 render "$work/in/deep/h1.toml" -o 'here/f_#.png'
says err "here/f_1.png: error: is a link"
for file in manifest.jsonl timings.jsonl; do ln -s "$work/outside/victim" "here/$file"; done
run 6 render "$work/in/deep/h1.toml" -o 'here/g_#.png'
says err "here/manifest.jsonl: error: is a link"
for file in "$work"/in/deep/*; do
  run 0 render "$file" --quiet
  run 0 render "$file" -o 'here/f_#.png' --quiet --force
  run 0 render "$file" -o 'all/{scene}/x{scene}_#.png' --quiet
  run 0 render "$file" -o 'all/{scene}/x{scene}_#.png' --quiet --resume
done
# Names become those of files of experiments.
for file in "$work"/in/deep/*; do
  run 0 experiment markov "$file" -o here/deep/markov --count 10
  run 0 experiment coverage "$file" -o here/deep/sweep --sweep ray.0.bounces=1..2:1
done
exists here/deep/markov/markov_.._.._.._.._tmp_flatray_f3.svg
exists here/deep/sweep/sweep.csv
[[ $(tree) == "$before" ]] || fail "outside changed: $(diff <(echo "$before") <(tree))"
[[ -z $(find . -type l -not -name '.*.part') ]] || fail "a link stayed where a file was written"

# A folder that the scene's name chooses and that is a link leads elsewhere.
cp "$work/in/deep/h1.toml" planted.toml
ln -s "$work/outside" all/planted
ln -s "$work/outside" out/planted
before=$(tree)
run 6 render planted.toml -o 'all/{scene}/f_#.png'
says err "is a link, and a scene's name led to it"
run 6 render planted.toml
[[ $(tree) == "$before" ]] || fail "a link of the scene's name was followed"
rm "$work/outside/manifest.jsonl"
run 0 render planted.toml -o 'all/planted/f_#.png' --quiet  # the user's own word
exists "$work/outside/f_1.png"
run 0 render planted.toml -o '../side/{scene}_#.png' --quiet
exists "$work/work/side/planted_2.png"
finish
