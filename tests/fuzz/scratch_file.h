// A file of a target's own in memory, written anew for every input.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string>

#include <unistd.h>

namespace ribalta::fuzz {

class ScratchFile {
  public:
    /// `extension` with its dot.
    explicit ScratchFile(const char* extension) {
        const char* const memory = "/dev/shm";
        const std::filesystem::path parent =
            access(memory, W_OK) == 0 ? memory : std::filesystem::temp_directory_path();
        std::string folder = (parent / "ribalta_fuzz_XXXXXX").string();
        if (mkdtemp(folder.data()) == nullptr) {
            throw std::runtime_error("no folder in " + parent.string());
        }
        folder_ = folder;
        path_ = folder_ / (std::string("input") + extension);
    }
    ~ScratchFile() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;

    const std::filesystem::path& path() const { return path_; }

    void write(std::span<const std::uint8_t> bytes) const {
        std::ofstream stream(path_, std::ios::binary | std::ios::trunc);
        stream.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
        if (!stream.flush()) {
            throw std::runtime_error("cannot write " + path_.string());
        }
    }

  private:
    std::filesystem::path folder_;
    std::filesystem::path path_;
};

}  // namespace ribalta::fuzz
