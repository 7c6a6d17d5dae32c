// LoadOptions: what of a file is loaded. Plain data, checked by loadGltf.
#pragma once

#include <optional>
#include <string>

namespace ribalta {

struct LoadOptions {
    /// One of the file's scenes, by name or counted from 0; none: the file's own choice, or its
    /// first one.
    std::optional<std::string> scene;

    bool operator==(const LoadOptions&) const = default;
};

}  // namespace ribalta
