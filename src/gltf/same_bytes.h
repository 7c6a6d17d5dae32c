// SameBytes: which of a file's pieces of data are equal, byte for byte, under whatever names.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <variant>
#include <vector>

namespace ribalta::gltf {

/// Bytes in memory, which must stay there, or a file with nothing else in it.
using ByteSource = std::variant<std::span<const std::byte>, std::filesystem::path>;

class SameBytes {
  public:
    /// The number of the first source with the same bytes; `number` where there is none, as for
    /// files that cannot be read. Only looks into sources of the same size, the first few of them.
    int firstLike(const ByteSource& source, int number);

  private:
    struct Known {
        ByteSource source;
        int number = 0;
    };
    std::map<std::uint64_t, std::vector<Known>> bySize_;
};

}  // namespace ribalta::gltf
