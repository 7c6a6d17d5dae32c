// RawBytes: large memory that something else is about to fill. Filling it with zeros first, as a
// std::vector does, would touch every page of it once more.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>

namespace ribalta {

/// Owns its bytes; copies are deep.
class RawBytes {
  public:
    RawBytes() = default;
    /// So many bytes that hold anything: whoever makes them writes them all.
    explicit RawBytes(std::size_t size)
        : bytes_(std::make_unique_for_overwrite<std::byte[]>(size)), size_(size) {}
    RawBytes(std::size_t size, std::byte value) : RawBytes(size) {
        std::fill_n(bytes_.get(), size, value);
    }
    explicit RawBytes(std::span<const std::byte> bytes) : RawBytes(bytes.size()) {
        std::copy(bytes.begin(), bytes.end(), begin());
    }
    ~RawBytes() = default;
    RawBytes(const RawBytes& other) : RawBytes(std::span<const std::byte>(other)) {}
    RawBytes(RawBytes&& other) noexcept
        : bytes_(std::move(other.bytes_)), size_(std::exchange(other.size_, 0)) {}
    RawBytes& operator=(RawBytes other) noexcept {
        std::swap(bytes_, other.bytes_);
        std::swap(size_, other.size_);
        return *this;
    }

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    std::byte* data() { return bytes_.get(); }
    const std::byte* data() const { return bytes_.get(); }
    std::byte* begin() { return data(); }
    const std::byte* begin() const { return data(); }
    std::byte* end() { return data() + size_; }
    const std::byte* end() const { return data() + size_; }
    std::byte& operator[](std::size_t index) { return bytes_[index]; }
    const std::byte& operator[](std::size_t index) const { return bytes_[index]; }
    /// Throws std::out_of_range.
    const std::byte& at(std::size_t index) const {
        if (index >= size_) {
            throw std::out_of_range("RawBytes::at");
        }
        return bytes_[index];
    }
    bool operator==(const RawBytes& other) const {
        return std::equal(begin(), end(), other.begin(), other.end());
    }

  private:
    std::unique_ptr<std::byte[]> bytes_;
    std::size_t size_ = 0;
};

}  // namespace ribalta
