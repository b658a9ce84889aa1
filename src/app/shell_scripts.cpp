// The scripts ask the program at each tab, so that they never fall behind it.
#include "app/completion.h"

namespace flatray {
namespace {

constexpr const char* kBash = R"sh(# flatray completion bash: source it, or keep it in
# ~/.local/share/bash-completion/completions/flatray
_flatray() {
  local IFS=$'\n' line extension word=${COMP_WORDS[COMP_CWORD]}
  COMPREPLY=()
  [[ $word == '=' ]] && word=
  while read -r line; do
    case $line in
      :files*)
        IFS=' ' read -r -a extensions <<< "${line#:files }"
        for extension in "${extensions[@]}"; do
          COMPREPLY+=($(compgen -f -X "!*.$extension" -- "$word"))
        done
        COMPREPLY+=($(compgen -d -- "$word"))
        compopt -o filenames ;;
      :folders)
        COMPREPLY+=($(compgen -d -- "$word"))
        compopt -o filenames ;;
      *) COMPREPLY+=("${line%%$'\t'*}") ;;
    esac
  done < <("${COMP_WORDS[0]}" completion words -- "${COMP_WORDS[@]:0:COMP_CWORD+1}" 2> /dev/null)
  [[ ${#COMPREPLY[@]} == 1 && ${COMPREPLY[0]} == *= ]] && compopt -o nospace
  return 0
} 2> /dev/null
complete -F _flatray flatray
)sh";

constexpr const char* kZsh = R"sh(#compdef flatray
# flatray completion zsh: keep it as _flatray in a folder of $fpath, or source it after compinit.
_flatray() {
  local line
  local -a described extensions
  for line in "${(@f)$("$words[1]" completion words -- "${(@)words[1,CURRENT]}" 2> /dev/null)}"; do
    case $line in
      '') ;;
      :files*)
        extensions=(${=line#:files})
        _files -g "*.(${(j:|:)extensions})" ;;
      :folders) _files -/ ;;
      *) described+=("${${line//:/\\:}/$'\t'/:}") ;;
    esac
  done
  (( $#described )) && _describe flatray described
}
compdef _flatray flatray
)sh";

constexpr const char* kFish =
    R"sh(# flatray completion fish: keep it in ~/.config/fish/completions/flatray.fish, or source it.
function __flatray_complete
    set -l before (commandline -opc)
    set -l word (commandline -ct)
    for line in ($before[1] completion words -- $before "$word" 2> /dev/null)
        switch $line
            case ':files*'
                for extension in (string split ' ' -- $line)[2..-1]
                    __fish_complete_suffix "$word" .$extension
                end
            case ':folders'
                __fish_complete_directories "$word"
            case '*'
                echo $line
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

std::vector<std::string> completed_shells() {
  std::vector<std::string> names;
  for (const Shell& shell : kShells) names.emplace_back(shell.name);
  return names;
}

}  // namespace flatray
