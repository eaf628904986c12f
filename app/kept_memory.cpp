#include "app/kept_memory.h"

#include <cstdlib>  // defines __GLIBC__, if it is that
#ifdef __GLIBC__
#include <initializer_list>
#include <limits>
#include <malloc.h>
#endif

namespace cocoon::app {

void keep_freed_memory() {
#ifdef __GLIBC__
  for (const char* setting :
       {"MALLOC_TRIM_THRESHOLD_", "MALLOC_MMAP_THRESHOLD_", "GLIBC_TUNABLES"}) {
    if (std::getenv(setting) != nullptr) return;
  }
  // The most that glibc takes; what is larger leaves gaps that little fits into.
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
}

}  // namespace cocoon::app
