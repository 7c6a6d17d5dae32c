#include "base/file_cache.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <system_error>

#include "base/content_hash.h"
#include "base/error.h"
#include "base/log.h"
#include "base/read_file.h"
#include "base/temporary_file.h"

namespace ribalta {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".cache";

/// What a file begins with.
struct Head {
    std::array<char, 8> magic{'r', 'i', 'b', 'a', 'l', 't', 'a', '1'};
    std::uint64_t bytes = 0;  ///< that follow
    std::uint64_t checksum = 0;
};

Head headOf(std::span<const std::byte> content) {
    ContentHash hash;
    hash.add(content);
    return {Head{}.magic, content.size(), hash.value()};
}

std::optional<fs::path> absoluteFolder(const char* variable) {
    const char* const value = std::getenv(variable);
    if (value == nullptr || !fs::path(value).is_absolute()) {
        return std::nullopt;
    }
    return fs::path(value);
}

}  // namespace

std::optional<fs::path> userCacheFolder() {
    if (const std::optional<fs::path> caches = absoluteFolder("XDG_CACHE_HOME")) {
        return *caches / "ribalta";
    }
    if (const std::optional<fs::path> home = absoluteFolder("HOME")) {
        return *home / ".cache" / "ribalta";
    }
    return std::nullopt;
}

FileCache::FileCache(fs::path folder, std::uint64_t limitBytes)
    : folder_(std::move(folder)), limitBytes_(limitBytes) {}

fs::path FileCache::fileOf(const std::string& name, const std::string& key) const {
    return folder_ / (name + "." + key + std::string(kEnding));
}

std::optional<std::vector<std::byte>> FileCache::find(const std::string& name,
                                                      const std::string& key) const {
    const fs::path file = fileOf(name, key);
    std::error_code error;
    if (!fs::exists(file, error)) {
        return std::nullopt;
    }
    std::vector<std::byte> bytes;
    try {
        bytes = readFile(file, sizeof(Head) + limitBytes_);
    } catch (const Error& unreadable) {
        logVerbose("cache: " + std::string(unreadable.what()) + "; it is made anew");
        return std::nullopt;
    }
    Head head;
    if (bytes.size() >= sizeof head) {
        std::memcpy(&head, bytes.data(), sizeof head);
        bytes.erase(bytes.begin(), bytes.begin() + sizeof head);
        const Head expected = headOf(bytes);
        if (head.magic == expected.magic && head.bytes == expected.bytes &&
            head.checksum == expected.checksum) {
            // Files that are used stay; whether the time can be set matters to nobody else.
            fs::last_write_time(file, fs::file_time_type::clock::now(), error);
            return bytes;
        }
    }
    logVerbose("cache: " + file.string() + " is damaged or no file of ribalta's; it is made anew");
    return std::nullopt;
}

void FileCache::keep(const std::string& name, const std::string& key,
                     std::span<const std::byte> content) const {
    if (content.size() > limitBytes_) {
        return;
    }
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) {
        logVerbose("cache: " + folder_.string() + " cannot be made: " + error.message() +
                   "; nothing is kept");
        return;
    }
    const Head head = headOf(content);
    std::string file(sizeof head + content.size(), '\0');
    std::memcpy(file.data(), &head, sizeof head);
    std::transform(content.begin(), content.end(), file.begin() + sizeof head,
                   [](std::byte value) { return std::to_integer<char>(value); });
    try {
        writeFileAtomically(fileOf(name, key), file);
        makeRoom();
    } catch (const Error& unwritable) {
        logVerbose("cache: " + std::string(unwritable.what()) + "; nothing is kept");
    }
}

// Another program may remove or replace files meanwhile: what is gone is as good as removed.
void FileCache::makeRoom() const {
    struct Kept {
        fs::path path;
        std::uint64_t bytes = 0;
        fs::file_time_type used;
    };
    std::vector<Kept> files;
    std::uint64_t total = 0;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
        if (entry.path().extension() != kEnding || !entry.is_regular_file(error)) {
            continue;
        }
        const std::uint64_t bytes = entry.file_size(error);
        if (!error) {
            files.push_back({entry.path(), bytes, entry.last_write_time(error)});
            total += bytes;
        }
    }
    std::sort(files.begin(), files.end(),
              [](const Kept& a, const Kept& b) { return a.used < b.used; });
    for (const Kept& file : files) {
        if (total <= limitBytes_) {
            break;
        }
        fs::remove(file.path, error);
        total -= file.bytes;
    }
}

}  // namespace ribalta
