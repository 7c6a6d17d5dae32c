#include "base/read_file.h"

#include "base/regular_file.h"

namespace ribalta {

std::vector<std::byte> readFile(const std::filesystem::path& path, std::uint64_t limitBytes,
                                std::uint64_t wantedBytes) {
    const RegularFile file(path);
    return file.read(file.sizeWithin(limitBytes, wantedBytes));
}

}  // namespace ribalta
