#include "gltf/same_bytes.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <system_error>

namespace ribalta::gltf {
namespace {

using Bytes = std::span<const std::byte>;

// A file made for it could else have many of a size compared to their ends, each with each.
constexpr std::size_t kMostOfOneSize = 16;

std::optional<std::uint64_t> sizeOf(const ByteSource& source) {
    if (const auto* bytes = std::get_if<Bytes>(&source)) {
        return bytes->size();
    }
    std::error_code failed;
    const std::uint64_t size =
        std::filesystem::file_size(std::get<std::filesystem::path>(source), failed);
    return failed ? std::nullopt : std::optional(size);
}

// A source piece by piece, from its beginning.
class Reader {
  public:
    explicit Reader(const ByteSource& source) {
        if (const auto* bytes = std::get_if<Bytes>(&source)) {
            left_ = *bytes;
        } else {
            file_.open(std::get<std::filesystem::path>(source), std::ios::binary);
        }
    }

    // Empty at the end.
    Bytes next() {
        if (!file_.is_open()) {
            const Bytes piece = left_.first(std::min(left_.size(), block_.size()));
            left_ = left_.subspan(piece.size());
            return piece;
        }
        file_.read(reinterpret_cast<char*>(block_.data()), std::streamsize(block_.size()));
        return Bytes(block_).first(std::size_t(file_.gcount()));
    }

  private:
    Bytes left_;
    std::ifstream file_;
    std::array<std::byte, 16384> block_{};
};

bool areEqual(const ByteSource& a, const ByteSource& b) {
    Reader readerA(a);
    Reader readerB(b);
    for (;;) {
        const Bytes pieceA = readerA.next();
        const Bytes pieceB = readerB.next();
        if (!std::equal(pieceA.begin(), pieceA.end(), pieceB.begin(), pieceB.end())) {
            return false;
        }
        if (pieceA.empty()) {
            return true;
        }
    }
}

}  // namespace

int SameBytes::firstLike(const ByteSource& source, int number) {
    const std::optional<std::uint64_t> size = sizeOf(source);
    if (!size || *size == 0) {
        return number;
    }
    std::vector<Known>& alike = bySize_[*size];
    const auto same = std::find_if(alike.begin(), alike.end(), [&](const Known& known) {
        return areEqual(known.source, source);
    });
    if (same != alike.end()) {
        return same->number;
    }
    if (alike.size() < kMostOfOneSize) {
        alike.push_back({source, number});
    }
    return number;
}

}  // namespace ribalta::gltf
