#pragma once

namespace flatray {

/// From now on Ctrl-C and SIGTERM ask for a stop instead of ending the program; a second one ends
/// it.
void catch_interrupts();

/// From now on a file grown beyond the limit of the shell is an error of the write, not the end of
/// the program.
void survive_file_limits();

/// Whether a stop was asked for: files in flight are finished, nothing new is begun and no frame
/// drawn to its end.
bool interrupted();

}  // namespace flatray
