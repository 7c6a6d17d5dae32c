#include "base/raw_bytes.h"

#include <sys/mman.h>

namespace ribalta {
namespace {

constexpr std::size_t kHugePage = std::size_t(1) << 21U;
// Smaller ones would waste too much of their last page.
constexpr std::size_t kLarge = 2 * kHugePage;

bool isLarge(std::size_t bytes) {
    return bytes >= kLarge;
}

}  // namespace

void* takeRawMemory(std::size_t bytes) {
    if (!isLarge(bytes)) {
        return ::operator new(bytes);
    }
    void* const memory = ::operator new(bytes, std::align_val_t(kHugePage));
    // Whole pages alone, so that what lies behind is not touched. Where the system has none, the
    // usual ones do.
    madvise(memory, bytes / kHugePage * kHugePage, MADV_HUGEPAGE);
    return memory;
}

void giveRawMemory(void* memory, std::size_t bytes) noexcept {
    if (!isLarge(bytes)) {
        ::operator delete(memory);
        return;
    }
    ::operator delete(memory, std::align_val_t(kHugePage));
}

}  // namespace ribalta
