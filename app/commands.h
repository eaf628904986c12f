// The commands of the program, one source file each: command_<name>.cpp. A command throws the
// library's errors for what cannot be done (exit code 1), UsageError for arguments that contradict
// each other or the files that they name (exit code 2), and returns when done (exit code 0).
#pragma once

#include "app/command_line.h"
#include "app/job.h"

namespace cocoon::app {

void run(const DemoArguments& arguments, Job& job);
void run(const SampleArguments& arguments, Job& job);
void run(const ReconstructArguments& arguments, Job& job);
void run(const BoundaryArguments& arguments, Job& job);
void run(const UpdateArguments& arguments, Job& job);
void run(const WatchArguments& arguments, Job& job);
void run(const DelaunayArguments& arguments, Job& job);
void run(const CheckArguments& arguments, Job& job);
void run(const CompareArguments& arguments, Job& job);

}  // namespace cocoon::app
