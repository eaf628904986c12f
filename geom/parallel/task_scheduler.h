// The only code that calls the scheduler of oneTBB. Use geom/execution.h instead.
#pragma once

#include <cstddef>

namespace cocoon {

using Task = void (*)(void* context, std::size_t i, std::size_t thread);

// Calls task(context, i, thread) for each i in [0, count), on at most `threads` threads of which
// the calling one is one; `thread` < threads differs from that of all tasks under way. The first
// exception of a task reaches the caller; others may then not have been called.
void run_tasks(int threads, std::size_t count, Task task, void* context);

// How many cores this process may run on: all of the machine unless it was bound to some of them
// (taskset, a batch system, a container with a set of its own).
int available_cores();

}  // namespace cocoon
