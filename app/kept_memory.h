// How the program gets its memory.
#pragma once

namespace cocoon::app {

// From now on memory that is freed stays with the process, and is handed out again as it is, but
// for what is larger than 32 MiB. By default glibc gives much of it back to the system, which
// clears each page that it lends once more. No effect with other C libraries, or if the user has
// settings of his own (MALLOC_TRIM_THRESHOLD_, GLIBC_TUNABLES). Not for a process that goes on for
// days: it would keep the most that it ever held. Complexity: O(1).
void keep_freed_memory();

}  // namespace cocoon::app
