#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

namespace flatray {

/// Says, as long as it lives, that a file has a temporary name: remove_in_flight() takes it away
/// when the program ends before the file has its own.
class InFlight {
 public:
  /// Of a file that others may use, too, `locked` is a descriptor of it with a shared lock: it is taken
  /// away only where no other has one, and the name is still its own.
  explicit InFlight(const std::filesystem::path& temporary, int locked = -1);
  InFlight(const InFlight&) = delete;
  InFlight& operator=(const InFlight&) = delete;
  ~InFlight();
  /// A signal handler may call it.
  void remove() const;

 private:
  const std::string path_;
  const int locked_;
  std::size_t slot_;
};

/// A program that works on such a file, by its process number, and ends with this one; none: -1.
void set_program_in_flight(int process);

/// Ends that program and removes the temporary files of all threads. A signal handler may call it; the program must end
/// next, since a thread that was writing one waits for ever.
void remove_in_flight();

}  // namespace flatray
