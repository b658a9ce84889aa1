#include "app/help/help.h"

namespace flatray::help_verb {
namespace {

Result<VerbOutput> run(const NoOptions& options) {
  if (options.operands().empty()) return VerbOutput{{help_text()}};
  FLATRAY_TRY(page, help_page(options.operands().front()));
  return VerbOutput{{std::move(*page)}};
}

}  // namespace

extern const Verb entry = {"help",
                           "[TOPIC]",
                           "explain a verb, a topic, a table or a shape of scenes",
                           kCommand<NoOptions, &run>,
                           "  flatray help render\n"
                           "  flatray help frames\n"
                           "  flatray help entity\n",
                           "",
                           &help_names};

}  // namespace flatray::help_verb
