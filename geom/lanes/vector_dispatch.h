// Calls the version of a function with vector instructions that suits the processor.
//
// HWY_EXPORT and HWY_DYNAMIC_DISPATCH of Highway do the same, but need its shared library, which
// measures the resolution of the clock whenever it is loaded: 4 ms of each start of a program, as
// much as a small scan takes. These need the headers alone, and the same tables.
#pragma once

#include <cstdint>
#include <hwy/targets.h>

namespace cocoon {

// The instruction sets among HWY_TARGETS that this processor has, as bits: those of x86 by its own
// word, elsewhere those that the compiler takes for granted. O(1).
std::int64_t instruction_sets();

// Begins with the best of instruction_sets(). A test may choose others by Update(). Thread-safe.
hwy::ChosenTarget& chosen_instruction_set();

}  // namespace cocoon

// Entry 0 is for a choice that has not been made yet, which does not occur.
#define COCOON_VECTOR_EXPORT(function)                                            \
  static decltype(&HWY_STATIC_DISPATCH(function)) const function##_versions[] = { \
      nullptr, HWY_CHOOSE_TARGET_LIST(function), HWY_CHOOSE_FALLBACK(function)}

#define COCOON_VECTOR_CALL(function) \
  (*function##_versions[cocoon::chosen_instruction_set().GetIndex()])
