#include "base/mapped_file.h"

#include <array>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <mutex>
#include <utility>

#include <sys/mman.h>
#include <unistd.h>

namespace ribalta {
namespace {

// A mapping whose pages may fail to be there. Read by the signal's handler, which may run in any
// thread at any time: plain atomic numbers.
struct GuardedRange {
    std::atomic<bool> isTaken = false;
    std::atomic<std::uintptr_t> begin = 0;  // both are 0 while there is no mapping
    std::atomic<std::uintptr_t> end = 0;
    std::atomic<bool> wasCut = false;
};

std::array<GuardedRange, 64> guardedRanges;
struct sigaction handlerBefore {};

// Puts zeros where a file has no bytes any more; the access that failed is then made again. A fault
// elsewhere is handled as it would have been without this program's handler.
void onBusError(int, siginfo_t* info, void*) {
    const auto address = reinterpret_cast<std::uintptr_t>(info->si_addr);
    const auto pageBytes = std::uintptr_t(sysconf(_SC_PAGESIZE));
    for (GuardedRange& range : guardedRanges) {
        const std::uintptr_t end = range.end;
        if (address < range.begin || address >= end) {
            continue;
        }
        const std::uintptr_t page = address / pageBytes * pageBytes;
        void* const zeros = mmap(reinterpret_cast<void*>(page), end - page, PROT_READ,
                                 MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED | MAP_NORESERVE, -1, 0);
        if (zeros != MAP_FAILED) {
            range.wasCut = true;
            return;
        }
    }
    sigaction(SIGBUS, &handlerBefore, nullptr);
}

void installHandler() {
    static std::once_flag once;
    std::call_once(once, [] {
        struct sigaction action {};
        action.sa_sigaction = onBusError;
        action.sa_flags = SA_SIGINFO;
        sigemptyset(&action.sa_mask);
        sigaction(SIGBUS, &action, &handlerBefore);
    });
}

// -1 where all are taken.
int takeRange() {
    for (std::size_t i = 0; i < guardedRanges.size(); ++i) {
        if (!guardedRanges[i].isTaken.exchange(true)) {
            guardedRanges[i].wasCut = false;
            return int(i);
        }
    }
    return -1;
}

}  // namespace

MappedFile::MappedFile(const std::filesystem::path& path, std::uint64_t limitBytes,
                       std::uint64_t wantedBytes) {
    file_.emplace(path);
    const std::uint64_t size = file_->sizeWithin(limitBytes, wantedBytes);
    if (size >= kMappedFrom && map(size)) {
        return;
    }
    read_ = file_->read(size);
    file_.reset();
    bytes_ = read_;
}

bool MappedFile::map(std::size_t size) {
    installHandler();
    guard_ = takeRange();
    if (guard_ < 0) {
        return false;
    }
    GuardedRange& range = guardedRanges[std::size_t(guard_)];
    void* const start = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file_->descriptor(), 0);
    if (start == MAP_FAILED) {
        range.isTaken = false;
        guard_ = -1;
        return false;
    }
    range.begin = reinterpret_cast<std::uintptr_t>(start);
    range.end = reinterpret_cast<std::uintptr_t>(start) + size;
    // From a disk it is read ahead of who looks at it.
    madvise(start, size, MADV_WILLNEED);
    bytes_ = {static_cast<const std::byte*>(start), size};
    return true;
}

MappedFile::~MappedFile() {
    if (guard_ < 0) {
        return;
    }
    GuardedRange& range = guardedRanges[std::size_t(guard_)];
    range.end = 0;
    range.begin = 0;
    munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
    range.isTaken = false;
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : file_(std::move(other.file_)),
      read_(std::move(other.read_)),
      bytes_(std::exchange(other.bytes_, {})),
      guard_(std::exchange(other.guard_, -1)) {}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept {
    std::swap(file_, other.file_);
    std::swap(read_, other.read_);
    std::swap(bytes_, other.bytes_);
    std::swap(guard_, other.guard_);
    return *this;
}

void MappedFile::expectUnchanged() const {
    if (guard_ >= 0 && (guardedRanges[std::size_t(guard_)].wasCut || file_->hasChanged())) {
        file_->refuse(kChangedWhileRead);
    }
}

}  // namespace ribalta
