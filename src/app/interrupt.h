#pragma once

namespace flatray {

/// How the program ends from now on when SIGINT, SIGTERM or SIGHUP comes, or its time is over:
/// temporary files are removed, one line on standard error says why and what is `kept`, and the
/// exit code is interrupted_code().
///
/// Where something is `kept`, what asks interrupted() has 0.6 s to end by itself; without, and at a
/// second signal, the end is at once. A signal that is ignored, as of what a script runs in the
/// background, stays ignored.
void catch_interrupts(const char* kept);

/// Lets the time of the program be over so long from now, once.
void limit_seconds(double seconds);

/// From now on a file grown beyond the limit of the shell is an error of the write, not the end of
/// the program.
void survive_file_limits();

/// From now on what reads no more is an error of the write, not the end of the program.
void survive_closed_pipes();

/// From now on a crash is told as that of the GL library, exit code 5: it does not survive that
/// memory ends.
void expect_crashes_of_gl();

/// Whether a stop was asked for: files in flight are finished, nothing new is begun and no frame
/// drawn to its end.
bool interrupted();

/// Exit code where --max-seconds or --max-memory ended the program, as that of timeout(1).
inline constexpr int kOverLimit = 124;

/// Then: 130 after SIGINT, 143 after SIGTERM, 129 after SIGHUP, kOverLimit when time was over.
int interrupted_code();

/// The word for it, "interrupted". Who asks says it: an end by force after that says nothing more.
const char* interruption();

}  // namespace flatray
