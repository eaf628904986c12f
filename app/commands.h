// The commands of the program, one source file each: command_<name>.cpp. A command throws the
// library's errors for what cannot be done (exit code 1) and returns when done (exit code 0).
#pragma once

#include "app/command_line.h"
#include "app/job.h"

namespace cocoon::app {

void run_demo(const DemoArguments& arguments, Job& job);
void run_sample(const SampleArguments& arguments, Job& job);
void run_reconstruct(const ReconstructArguments& arguments, Job& job);
void run_boundary(const BoundaryArguments& arguments, Job& job);
void run_update(const UpdateArguments& arguments, Job& job);
void run_watch(const WatchArguments& arguments, Job& job);
void run_delaunay(const DelaunayArguments& arguments, Job& job);
void run_check(const CheckArguments& arguments, Job& job);
void run_compare(const CompareArguments& arguments, Job& job);

}  // namespace cocoon::app
