// Where: a step on the way down into a document, cheap enough to be taken for every element; it
// becomes a Place only when there is something to say.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/error.h"

namespace ribalta::gltf {

class Where {
  public:
    /// The document's root. `file` must outlive this and everything below it.
    explicit Where(const Place& file) : file_(&file) {}
    /// One step below `up`, which must outlive this.
    Where(const Where& up, std::string_view key) : up_(&up), key_(key) {}
    Where(const Where& up, std::size_t index) : up_(&up), index_(index), isIndex_(true) {}

    Place place() const {
        if (up_ == nullptr) {
            return *file_;
        }
        return isIndex_ ? up_->place().at(index_) : up_->place().at(std::string(key_));
    }

  private:
    const Place* file_ = nullptr;
    const Where* up_ = nullptr;
    std::string_view key_;
    std::size_t index_ = 0;
    bool isIndex_ = false;
};

}  // namespace ribalta::gltf
