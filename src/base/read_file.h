// A whole regular file, as bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace ribalta {

/// The bytes of `path`, the first `wantedBytes` where it has more. Throws Error(kBadInput) that
/// names the path where it does not exist, is no regular file (a folder, a device, a pipe), cannot
/// be read, or would give more than `limitBytes`.
std::vector<std::byte> readFile(const std::filesystem::path& path,
                                std::uint64_t limitBytes = std::uint64_t(1) << 36,
                                std::uint64_t wantedBytes = UINT64_MAX);

}  // namespace ribalta
