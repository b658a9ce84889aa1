#pragma once
#include <string>
#include <vector>

#include "app/verb.h"

namespace flatray {

/// A page of `flatray help`: something about the whole program, a table of the scene language or a
/// shape. Verbs are the other pages.
struct Topic {
  std::string name, summary;
};

/// All topics: those written (app/help/topics.cpp), then every table and shape of the language.
std::vector<Topic> help_topics();

/// Names `flatray help` takes: verbs and topics, each once.
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
