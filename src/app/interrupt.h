#pragma once

namespace flatray {

/// From now on Ctrl-C and SIGTERM ask for a stop instead of ending the program (a second one ends it), and a file
/// grown beyond its limit is an error of the write instead of the end of the program.
void catch_interrupts();

/// Whether a stop was asked for: work in flight is finished, nothing new begun.
bool interrupted();

}  // namespace flatray
