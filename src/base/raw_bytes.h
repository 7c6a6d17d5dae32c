// RawBytes: large memory that something else is about to fill. Filling it with zeros first would
// touch every page of it once more.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace ribalta {

/// Memory for `bytes`, in pages of the usual size: huge ones were measured to take longer, as the
/// system has to clear space for them. Throws std::bad_alloc.
void* takeRawMemory(std::size_t bytes);
void giveRawMemory(void* memory, std::size_t bytes) noexcept;

/// An allocator whose containers leave new elements as the memory is.
template <typename T>
struct RawAllocator {
    using value_type = T;

    RawAllocator() = default;
    template <typename U>
    explicit(false) RawAllocator(const RawAllocator<U>&) noexcept {}  // as containers want it

    T* allocate(std::size_t count) { return static_cast<T*>(takeRawMemory(count * sizeof(T))); }
    void deallocate(T* memory, std::size_t count) noexcept {
        giveRawMemory(memory, count * sizeof(T));
    }
    template <typename U, typename... Arguments>
    void construct(U* place, Arguments&&... arguments) {
        if constexpr (sizeof...(Arguments) == 0) {
            ::new (static_cast<void*>(place)) U;
        } else {
            ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
        }
    }
    bool operator==(const RawAllocator&) const = default;
};

/// Bytes that resize() adds hold anything: whoever resizes it writes them all.
using RawBytes = std::vector<std::byte, RawAllocator<std::byte>>;

}  // namespace ribalta
