#include "app/help/schema.h"

#include "app/verb.h"

namespace flatray::schema_verb {
namespace {

Result<VerbOutput> run(const NoOptions&) {
  return VerbOutput{{json_text(scene_schema(), {.indent = 2}) + "\n"}};
}

}  // namespace

extern const Verb entry = {"schema", "",
                           "print the JSON Schema of scenes, by which editors check and complete",
                           kCommand<NoOptions, &run>,
                           "  flatray schema > scene.schema.json\n"
                           "  first line of a scene, for Even Better TOML and taplo:\n"
                           "  #:schema ./scene.schema.json\n"};

}  // namespace flatray::schema_verb
