#pragma once
#include <string>
#include <vector>

#include "app/verb.h"

namespace flatray {

/// Names `flatray help` takes: verbs, the topics written (app/help/topics.cpp), and every table and
/// shape of the scene language, each once.
std::vector<std::string> help_names();

/// Text of `flatray help`, of `flatray help VERB` and of `flatray help TOPIC`.
std::string help_text();
std::string help_text(const Verb& verb);
/// Error   Trouble::usage with the nearest name.
Result<std::string> help_page(const std::string& name);

/// The topics written by hand. Their text may name tables, whose keys then follow it.
struct WrittenTopic {
  const char *name, *summary, *text;
  const char* tables = "";  ///< names, parted by blanks
};
std::vector<WrittenTopic> written_topics();

}  // namespace flatray
