// Programs that run one after the other in one process, each with the heap as if it were the first.
#pragma once

#include <cstdlib>  // defines __GLIBC__, if it is that
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace cocoon::bench {

// Gives back to the system what is free, so that none pays for tidying up what another one has
// left: triangulations of millions of small pieces.
inline void tidy_heap() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace cocoon::bench
