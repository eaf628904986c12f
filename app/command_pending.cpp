// Commands whose stages are still being built.
#include "app/commands.h"
#include "geom/errors.h"

namespace cocoon::app {

void run_demo(const DemoArguments&, Job&) { throw InputError("demo: not in this build yet"); }
void run_sample(const SampleArguments&, Job&) { throw InputError("sample: not in this build yet"); }
void run_update(const UpdateArguments&, Job&) { throw InputError("update: not in this build yet"); }
void run_compare(const CompareArguments&, Job&) {
  throw InputError("compare: not in this build yet");
}

}  // namespace cocoon::app
