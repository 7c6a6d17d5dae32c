// RawBytes: large memory that something else is about to fill. Filling it with zeros first would
// touch every page of it once more.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace ribalta {

/// An allocator whose containers leave new elements as the memory is.
template <typename T>
struct RawAllocator : std::allocator<T> {
    RawAllocator() = default;
    template <typename U>
    explicit(false) RawAllocator(const RawAllocator<U>& /*other*/) noexcept {}

    template <typename U>
    struct rebind {
        using other = RawAllocator<U>;
    };
    template <typename U, typename... Arguments>
    void construct(U* place, Arguments&&... arguments) {
        if constexpr (sizeof...(Arguments) == 0) {
            ::new (static_cast<void*>(place)) U;
        } else {
            ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
        }
    }
};

/// Bytes that resize() adds hold anything: whoever resizes it writes them all.
using RawBytes = std::vector<std::byte, RawAllocator<std::byte>>;

}  // namespace ribalta
