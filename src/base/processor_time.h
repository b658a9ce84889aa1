#pragma once

namespace flatray {

/// Seconds of processor time that all threads of the program have used. For reports, never for
/// results.
double processor_seconds();
/// Those of the calling thread alone.
double thread_seconds();

}  // namespace flatray
