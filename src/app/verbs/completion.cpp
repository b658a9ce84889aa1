#include "app/help/completion.h"

#include "app/verb.h"

namespace flatray::completion_verb {
namespace {

Result<VerbOutput> run(const NoOptions& options) {
  const std::vector<std::string>& operands = options.operands();
  if (operands.front() == "words")
    return VerbOutput{{completion_lines(complete({operands.begin() + 1, operands.end()}))}};
  std::string script = operands.size() == 1 ? completion_script(operands.front()) : "";
  if (!script.empty()) return VerbOutput{{std::move(script)}};
  return usage_error(named_place(operands.front()), "there is no script for this shell",
                     "say one of: " + comma_list(completed_shells()));
}

}  // namespace

extern const Verb entry = {
    "completion",
    "SHELL",
    "print the script by which bash, zsh or fish completes command lines",
    kCommand<NoOptions, &run>,
    "  source <(flatray completion bash)              # in ~/.bashrc\n"
    "  source <(flatray completion zsh)               # in ~/.zshrc, after compinit\n"
    "  flatray completion fish | source               # in ~/.config/fish/config.fish\n"
    "  flatray completion words -- flatray render --  # what the scripts ask\n",
    "",
    &completed_shells,
    nullptr,
    9'999};

}  // namespace flatray::completion_verb
