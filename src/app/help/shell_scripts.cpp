// The scripts ask the program at each tab, so that they never fall behind it. Names of a scene are
// quoted by them, so that TAB never puts on the line what the shell would run.
#include "app/help/completion.h"
#include "base/entry_named.h"

namespace flatray {
namespace {

constexpr const char* kBash = R"sh(# flatray completion bash: source it, or keep it in
# ~/.local/share/bash-completion/completions/flatray
# A word as it was typed, without its quotes; nothing in it is run.
_flatray_bare() {
  case $1 in
    [\'\"]*) bare=${1:1} bare=${bare%"${1:0:1}"} ;;
    *\\*) IFS= read -d '' bare < <(printf '%s\0' "$1") ;;
    *) bare=$1 ;;
  esac
}
# A candidate as it may stand after what opened the word: a quote, or nothing.
_flatray_quoted() {
  case $2 in
    \'*) quoted=${1//\'/\'\\\'\'} ;;
    \"*)
      quoted=${1//\\/\\\\} quoted=${quoted//\"/\\\"} quoted=${quoted//\$/\\\$}
      quoted=${quoted//\`/\\\`} ;;
    *) printf -v quoted %q "$1" ;;
  esac
}
_flatray() {
  local IFS=$' \t\n' line extension bare quoted word=${COMP_WORDS[COMP_CWORD]}
  local -a words=() extensions=() files=()
  COMPREPLY=()
  for line in "${COMP_WORDS[@]:1:COMP_CWORD}"; do
    _flatray_bare "$line"
    words+=("$bare")
  done
  [[ $word == '=' ]] && word=
  while IFS= read -r line; do
    case $line in
      $'\t'files*)
        read -r -a extensions <<< "${line#$'\t'files}"
        for extension in "${extensions[@]}"; do
          mapfile -t files < <(compgen -f -X "!*.$extension" -- "$word")
          COMPREPLY+=("${files[@]}")
        done
        mapfile -t files < <(compgen -d -- "$word")
        COMPREPLY+=("${files[@]}")
        compopt -o filenames ;;
      $'\t'folders)
        mapfile -t files < <(compgen -d -- "$word")
        COMPREPLY+=("${files[@]}")
        compopt -o filenames ;;
      *)
        line=${line%%$'\t'*}
        [[ $word == \"* && $line == *!* ]] && continue  # no quoting keeps it from the history
        _flatray_quoted "$line" "$word"
        COMPREPLY+=("$quoted") ;;
    esac
  done < <("${COMP_WORDS[0]}" completion words -- flatray "${words[@]}" 2> /dev/null)
  [[ ${#COMPREPLY[@]} == 1 && ${COMPREPLY[0]} == *= ]] && compopt -o nospace
  return 0
} 2> /dev/null
complete -F _flatray flatray
)sh";

constexpr const char* kZsh = R"sh(#compdef flatray
# flatray completion zsh: keep it as _flatray in a folder of $fpath, or source it after compinit.
# What is offered is quoted by compadd, to which _describe hands it.
_flatray() {
  local line word
  local -a described extensions
  for line in "${(@f)$("${(Q)words[1]}" completion words -- flatray "${(@Q)words[2,CURRENT]}" 2> /dev/null)}"; do
    case $line in
      '') ;;
      $'\t'files*)
        extensions=(${=line#$'\t'files})
        _files -g "*.(${(j:|:)extensions})" ;;
      $'\t'folders) _files -/ ;;
      *)
        word=${line%%$'\t'*}
        described+=("${${word//\\/\\\\}//:/\\:}${${line#"$word"}/$'\t'/:}") ;;
    esac
  done
  (( $#described )) && _describe flatray described
}
compdef _flatray flatray
)sh";

constexpr const char* kFish =
    R"sh(# flatray completion fish: keep it in ~/.config/fish/completions/flatray.fish, or source it.
# What is printed is quoted by fish itself.
function __flatray_complete
    set -l before (commandline -opc)
    set -l typed (commandline -ct)
    set -l word (string unescape -- "$typed"; or printf '%s\n' "$typed")
    for line in ($before[1] completion words -- $before "$word" 2> /dev/null)
        switch $line
            case \t'files*'
                for extension in (string split ' ' -- $line)[2..-1]
                    __fish_complete_suffix "$typed" .$extension
                end
            case \t'folders'
                __fish_complete_directories "$typed"
            case '*'
                printf '%s\n' "$line"
        end
    end
end
complete -c flatray -f -a '(__flatray_complete)'
)sh";

struct Shell {
  const char *name, *script;
};
constexpr Shell kShells[] = {{"bash", kBash}, {"zsh", kZsh}, {"fish", kFish}};

}  // namespace

std::string completion_script(std::string_view shell) {
  for (const auto& [name, script] : kShells)
    if (shell == name) return script;
  return "";
}

std::vector<std::string> completed_shells() { return names_of(kShells); }

}  // namespace flatray
