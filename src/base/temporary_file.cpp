#include "base/temporary_file.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <random>
#include <string>

#include <fcntl.h>
#include <unistd.h>

#include "base/error.h"

namespace ribalta {
namespace {

[[noreturn]] void failed(const std::filesystem::path& target, const std::string& why) {
    throw Error(ErrorKind::kJobFailed, {target.string(), ""}, "cannot be written: " + why);
}

// What the system says, and what can be done about it.
std::string reasonAndCure(int error) {
    const auto cure = [error] {
        switch (error) {
            case ENOENT:
                return "; make the folder first";
            case ENOSPC:
            case EDQUOT:
                return "; make room, or choose another disk";
            case EFBIG:
                return "; raise the limit of a file's size (ulimit -f)";
            case EACCES:
            case EPERM:
            case EROFS:
                return "; choose a folder that you may write to";
            default:
                return "; choose another place";
        }
    };
    return std::strerror(error) + std::string(cure());
}

// The names that a signal handler must remove; null where a slot is free.
std::array<std::atomic<const char*>, 16> unfinished{};

void remember(const char* name) {
    for (auto& slot : unfinished) {
        const char* free = nullptr;
        if (slot.compare_exchange_strong(free, name)) {
            return;
        }
    }
}

void forget(const char* name) {
    for (auto& slot : unfinished) {
        const char* mine = name;
        if (slot.compare_exchange_strong(mine, nullptr)) {
            return;
        }
    }
}

// A name beside the target, with its ending, that hardly any file has.
std::filesystem::path unusedName(const std::filesystem::path& target) {
    constexpr char kLetters[] = "abcdefghijklmnopqrstuvwxyz0123456789";
    std::random_device random;
    std::uniform_int_distribution<std::size_t> letter(0, sizeof(kLetters) - 2);
    std::string middle = ".";
    for (int i = 0; i < 10; ++i) {
        middle += kLetters[letter(random)];
    }
    return target.parent_path() / (target.stem().string() + middle + target.extension().string());
}

}  // namespace

TemporaryFile::TemporaryFile(const std::filesystem::path& target) : target_(target) {
    std::error_code missing;
    const auto status = std::filesystem::status(target, missing);
    if (std::filesystem::is_directory(status)) {
        failed(target, "it is a folder; give a file name");
    }
    // The rename would put a file in the place of a device, or of a link instead of what it names.
    if (std::filesystem::exists(status)) {
        if (!std::filesystem::is_regular_file(status)) {
            failed(target, "it is not a regular file; give a file name");
        }
        target_ = std::filesystem::canonical(target, missing);
    }
    int file = -1;
    int error = EEXIST;
    while (file < 0 && error == EEXIST) {
        path_ = unusedName(target_);
        // Known before it is there, so that no signal finds it there and unknown.
        remember(path_.c_str());
        file = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        error = errno;
        if (file < 0) {
            forget(path_.c_str());
        }
    }
    if (file < 0) {
        failed(target, reasonAndCure(error));
    }
    close(file);
}

TemporaryFile::~TemporaryFile() {
    if (!committed_) {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    forget(path_.c_str());
}

void TemporaryFile::commit() {
    const int file = open(path_.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) {
        failed(target_, reasonAndCure(errno));
    }
    // A full disk may show only now.
    const int synced = fsync(file);
    const int why = errno;
    close(file);
    if (synced != 0 && why != EINVAL && why != EROFS) {
        failed(target_, reasonAndCure(why));
    }
    std::error_code error;
    std::filesystem::rename(path_, target_, error);
    if (error) {
        failed(target_, reasonAndCure(error.value()));
    }
    committed_ = true;
}

void writeFileAtomically(const std::filesystem::path& target, std::string_view content) {
    TemporaryFile temporary(target);
    std::ofstream stream(temporary.path(), std::ios::binary);
    stream.write(content.data(), static_cast<std::streamsize>(content.size()));
    stream.close();
    if (!stream) {
        failed(target, reasonAndCure(errno));
    }
    temporary.commit();
}

void removeTemporaryFiles() noexcept {
    for (const auto& slot : unfinished) {
        if (const char* const name = slot.load()) {
            unlink(name);
        }
    }
}

}  // namespace ribalta
