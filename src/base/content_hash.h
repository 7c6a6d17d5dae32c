// ContentHash: tells contents apart, so that what was made of one is not taken for another's.
// No protection against those who want to deceive.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace ribalta {

/// FNV-1a, 64 bits, over all that is added.
class ContentHash {
  public:
    void add(std::span<const std::byte> bytes);
    void add(std::string_view text);
    /// Plain values without padding, such as the elements of a mesh's arrays.
    template <typename Value, typename Allocator>
    void add(const std::vector<Value, Allocator>& values) {
        static_assert(std::has_unique_object_representations_v<Value> || sizeof(Value) % 4 == 0);
        static_assert(std::is_trivially_copyable_v<Value>);
        addSize(values.size());
        add(std::as_bytes(std::span(values)));
    }

    std::uint64_t value() const { return state_; }
    /// 16 hexadecimal digits.
    std::string text() const;

  private:
    void addSize(std::size_t size);

    std::uint64_t state_ = 0xcbf29ce484222325;
};

}  // namespace ribalta
