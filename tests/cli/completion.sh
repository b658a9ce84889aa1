#!/usr/bin/env bash
# Completion in bash, and in zsh and fish where they are installed: verbs, options, their values, names, files.
source "$(dirname "$0")/lib.sh"
scene first.toml 1
scene second.toml 1
mkdir -p folder
touch other.md picture.png
PATH=$(dirname "$flatray"):$PATH

# What the scripts ask: `words LINE` completes its last word.
words() { "$flatray" completion words -- "$@" | sed 's/^\t/:/; s/\t.*//' | tr '\n' ' '; }
# expect WANTED GOT WHAT
expect() { [[ $2 == "$1" ]] || fail "$3: got '$2', wanted '$1'"; }
expect "check collide compare completion " "$(words flatray c | sed "s/convert //")" verbs
expect "--frames --format --force " "$(words flatray render --f)" options
expect "$("$flatray" list pictures | cut -d" " -f1 | tr "\n" " ")" "$(words flatray render --format '')" "values of an option"
expect "--progress=always " "$(words flatray render --progress=al)" "values after ="
expect "always " "$(words flatray render --progress = al)" "values after =, as bash parts words"
expect "grid,exact " "$(words flatray stability --tracer grid,ex)" "the second of several values"
expect "--tracer=grid,exact " "$(words flatray stability --tracer=grid,ex)" "the second value after ="
expect "markov " "$(words flatray experiment mar)" experiments
expect "software " "$(words flatray render --backend s)" "back ends"
expect "mean " "$(words flatray compare a b --metric me)" metrics
expect "tracers " "$(words flatray list t)" lists
expect "bash " "$(words flatray completion b)" shells
expect "frames " "$(words flatray help fram)" topics
expect "check update " "$(words flatray golden '')" actions
expect "box " "$(words flatray hit first.toml --from '')" "entities of the scene"
expect "" "$(words flatray hit absent.toml --from '')" "entities of no scene"
mkfifo pipe.toml
expect box "$(timeout 60 "$flatray" completion words -- flatray hit pipe.toml first.toml --from '')" "beside a pipe"
rm pipe.toml
expect "film.background= " "$(words flatray render first.toml -D film.b)" "keys of a scene"
expect ":folders " "$(words flatray golden check --root '')" folders
expect "film.background= " "$(words flatray experiment escape first.toml --sweep film.b)" "keys that a sweep goes over"
expect "none " "$(words flatray orbit first.toml --speed '')" "a word beside a number"
expect ":files json " "$(words flatray render --profile '' | tr -d '\t')" "profiles"
expect ":files film hdr pfm png " "$(words flatray merge --output '' | tr -d '\t')" "what films merge into"
for verb in render merge; do
  expect ":files hdr pfm png " "$(words flatray $verb --error-image '' | tr -d '\t')" "pictures of the error, $verb"
done
for first in '' a.hdr; do
  expect ":files hdr pfm png " "$(words flatray compare $first '' | tr -d '\t')" "pictures to compare"
done
expect ":files jsonl json " "$(words flatray query '' | tr -d '\t')" "questions"
expect "" "$(words flatray render --size '')" "values that are free"
expect "" "$(words nothing at all)" "another program's words"
[[ $(words flatray render '') == ":files "*toml* ]] || fail "scene files"
run 2 completion tcsh
says err "bash, zsh, fish"

# Every verb has every option of its help completed.
for verb in $(words flatray ''); do
  completed=" $(words flatray "$verb" --) "
  for option in $("$flatray" help "$verb" | sed '/^Examples/,$d' | grep -o ' --[a-z0-9-]*'); do
    [[ $completed == *" $option "* ]] || fail "$verb: $option is not completed"
  done
done

# bash: as its readline calls the function.
source <("$flatray" completion bash)
in_bash() {
  COMP_WORDS=("$@")
  COMP_CWORD=$(($# - 1))
  _flatray
  echo "${COMPREPLY[*]}"
}
expect render "$(in_bash flatray ren)" "bash, a verb"
expect --resume "$(in_bash flatray render --resu)" "bash, an option"
expect never "$(in_bash flatray render --progress = n)" "bash, a value"
expect "first.toml folder" "$(in_bash flatray render f)" "bash, scenes and folders"
expect "picture.png" "$(in_bash flatray compare p)" "bash, pictures"
expect "folder" "$(in_bash flatray golden --root f)" "bash, folders"

# Names that a shell would run: each comes back as the one word it is, whatever quote opened the word.
names=('.hidden' '$(touch ran)' '`touch ran`' 'a b;touch ran' "it's \"\\" '"$(touch ran)"' ':files toml' ':folders' '-n' '-rf' '*' 'x!!' $'\xc3\xbc')
{
  printf 'flatray = 1\n'
  for name in "${names[@]}" $'\n$(touch ran)\n' $'\tfiles md' $'\e[2J'; do
    text=${name//\\/\\\\} text=${text//\"/\\\"} text=${text//$'\n'/\\n} text=${text//$'\t'/\\t}
    printf '[[entity]]\nname = "%s"\nshape = { circle = { radius = 1 } }\n' "${text//$'\e'/\\u001b}"
  done
} > hostile.toml
run 0 check hostile.toml
mapfile -t offered < <("$flatray" completion words -- flatray hit hostile.toml --from '')
expect "${names[*]}" "${offered[*]}" "names that a line holds"
for opened in '' "'" '"'; do
  COMP_WORDS=(flatray hit hostile.toml --from "$opened") COMP_CWORD=4
  _flatray
  for i in "${!COMPREPLY[@]}"; do
    eval "word=($opened${COMPREPLY[i]}$opened)"
    [[ " ${names[*]} " == *" ${word[*]} "* && ${#word[@]} == 1 ]] || fail "bash, opened by <$opened>: ${COMPREPLY[i]}"
  done
  ((i >= ${#names[@]} - 2)) || fail "bash, opened by <$opened>: only $i names"
done
expect '\$\(touch\ ran\)' "$(in_bash flatray hit hostile.toml --from '\$\(')" "bash, a name begun in quotes"
absent ran

if command -v zsh > /dev/null; then
  "$flatray" completion zsh > zsh.txt
  in_zsh() {
    zsh -f -c 'compdef() { :; }; _files() { print -r -- "files $*"; }
      _describe() { print -rl -- "${(P@)2}"; }
      source zsh.txt; words=("$@"); CURRENT=$#words; _flatray' zsh "$@" 2>&1 | tr '\n' ' '
  }
  expect "render:draw frames of scenes into picture files " "$(in_zsh flatray ren)" "zsh, a verb"
  expect "always " "$(in_zsh flatray render --progress al)" "zsh, a value"
  expect "files -g *.(hdr|pfm|png) " "$(in_zsh flatray compare p)" "zsh, pictures"
  expect "\\:files toml " "$(in_zsh flatray hit hostile.toml --from :fi)" "zsh, a colon"
  expect "it's \"\\\\ " "$(in_zsh flatray hit hostile.toml --from it)" "zsh, a backslash"
  expect '$(touch ran) ' "$(in_zsh flatray hit hostile.toml --from '\$')" "zsh, a name begun in quotes"
fi
if command -v fish > /dev/null; then
  "$flatray" completion fish > fish.txt
  in_fish() { HOME=$work fish --no-config -c "source fish.txt; complete -C '$1'" 2>&1 | cut -f1 | tr '\n' ' '; }
  expect "render " "$(in_fish 'flatray ren')" "fish, a verb"
  expect "always " "$(in_fish 'flatray render --progress al')" "fish, a value"
  expect "second.toml " "$(in_fish 'flatray render s')" "fish, scenes"
  expect '$(touch ran) ' "$(in_fish 'flatray hit hostile.toml --from \$')" "fish, a name begun in quotes"
  expect "-n -rf " "$(in_fish 'flatray hit hostile.toml --from -')" "fish, names like options"
fi
absent ran
finish
