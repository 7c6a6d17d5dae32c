#include "base/freed_memory.h"

#include <climits>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace ribalta {

void keepFreedMemory() {
#ifdef __GLIBC__
    // Where blocks cannot be kept it would do harm to keep the heap's end alone.
    if (mallopt(M_MMAP_THRESHOLD, 1 << 30) != 0) {
        mallopt(M_TRIM_THRESHOLD, INT_MAX);
    }
#endif
}

void returnFreedMemory() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

}  // namespace ribalta
