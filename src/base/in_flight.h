#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

namespace flatray {

/// Says, as long as it lives, that a file has a temporary name: remove_in_flight() takes it away
/// when the program ends before the file has its own.
class InFlight {
 public:
  explicit InFlight(const std::filesystem::path& temporary);
  InFlight(const InFlight&) = delete;
  InFlight& operator=(const InFlight&) = delete;
  ~InFlight();

 private:
  const std::string path_;
  std::size_t slot_;
};

/// Removes the temporary files of all threads. A signal handler may call it; the program must end
/// next, since a thread that was writing one waits for ever.
void remove_in_flight();

}  // namespace flatray
