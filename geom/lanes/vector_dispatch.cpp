#include "geom/lanes/vector_dispatch.h"

#if HWY_ARCH_X86
#include <cpuid.h>
#endif

namespace cocoon {
namespace {

// A target with the least that the compiler may be asked for.
constexpr std::int64_t baseline = HWY_ENABLED_BASELINE;

#if HWY_ARCH_X86

// Conversions of half floats, for which older compilers have no name.
bool has_f16c() {
  unsigned eax = 0;
  unsigned ebx = 0;
  unsigned ecx = 0;
  unsigned edx = 0;
  return __get_cpuid(1, &eax, &ebx, &ecx, &edx) != 0 && (ecx & bit_F16C) != 0;
}

// What hwy/ops/set_macros-inl.h asks of each; the operating system must save its registers, too,
// which the compiler's word includes.
bool has_ssse3() { return __builtin_cpu_supports("ssse3") != 0; }
bool has_sse4() {
  return has_ssse3() && __builtin_cpu_supports("sse4.1") && __builtin_cpu_supports("sse4.2") &&
         __builtin_cpu_supports("pclmul") && __builtin_cpu_supports("aes");
}
bool has_avx2() {
  return has_sse4() && __builtin_cpu_supports("avx") && __builtin_cpu_supports("avx2") &&
         __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") &&
         __builtin_cpu_supports("fma") && has_f16c();
}
bool has_avx3() {
  return has_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
         __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
}

#endif

}  // namespace

std::int64_t instruction_sets() {
  std::int64_t sets = baseline;
#if HWY_ARCH_X86
  __builtin_cpu_init();
  if (has_ssse3()) sets |= HWY_SSSE3;
  if (has_sse4()) sets |= HWY_SSE4;
  if (has_avx2()) sets |= HWY_AVX2;
  if (has_avx3()) sets |= HWY_AVX3;
#endif
  return sets & HWY_TARGETS;
}

hwy::ChosenTarget& chosen_instruction_set() {
  static hwy::ChosenTarget chosen;
  [[maybe_unused]] static const bool is_chosen = (chosen.Update(instruction_sets()), true);
  return chosen;
}

}  // namespace cocoon
