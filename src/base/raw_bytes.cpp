#include "base/raw_bytes.h"

namespace ribalta {

void* takeRawMemory(std::size_t bytes) {
    return ::operator new(bytes);
}

void giveRawMemory(void* memory, std::size_t /*bytes*/) noexcept {
    ::operator delete(memory);
}

}  // namespace ribalta
