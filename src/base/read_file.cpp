#include "base/read_file.h"

#include <cerrno>
#include <cstring>
#include <exception>
#include <fstream>
#include <string>

#include "base/error.h"

namespace ribalta {

std::vector<std::byte> readFile(const std::filesystem::path& path, std::uint64_t limitBytes) {
    const Place place{path.empty() ? "''" : path.string(), ""};
    std::error_code status;
    const auto type = std::filesystem::status(path, status).type();
    if (type == std::filesystem::file_type::not_found) {
        throw Error(ErrorKind::kBadInput, place, "no such file; check the path");
    }
    if (status) {
        throw Error(ErrorKind::kBadInput, place, "cannot be opened: " + status.message());
    }
    if (type != std::filesystem::file_type::regular) {
        throw Error(ErrorKind::kBadInput, place, "is not a regular file; give a file");
    }
    const std::uint64_t size = std::filesystem::file_size(path, status);
    if (status) {
        throw Error(ErrorKind::kBadInput, place, "cannot be opened: " + status.message());
    }
    if (size > limitBytes) {
        throw Error(ErrorKind::kBadInput, place,
                    "has " + std::to_string(size) + " bytes, over the limit of " +
                        std::to_string(limitBytes));
    }
    std::ifstream stream(path, std::ios::binary);
    std::vector<std::byte> bytes;
    try {
        bytes.resize(size);
    } catch (const std::exception&) {
        throw Error(ErrorKind::kBadInput, place,
                    "has " + std::to_string(size) + " bytes, which do not fit into memory");
    }
    if (!stream ||
        !stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size))) {
        throw Error(ErrorKind::kBadInput, place,
                    std::string("cannot be read: ") + std::strerror(errno) +
                        "; check its permissions and its disk");
    }
    return bytes;
}

}  // namespace ribalta
