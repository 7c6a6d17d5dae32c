// LoadOptions: what of a file is loaded, and how much it may ask for. Plain data, kept by loadGltf.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace ribalta {

class FileCache;

/// How much a file may ask for. What would go beyond is refused before memory is taken for it. The
/// defaults are far above any stage's needs and the same on every machine.
struct LoadLimits {
    /// Bytes: the files that are read, the document, buffers, geometry and pixels, all added up.
    std::uint64_t memory = 16'000'000'000;
    std::uint64_t vertices = 150'000'000;  ///< vertices and indices of all primitives together
    std::uint64_t nodes = 4'000'000;       ///< of the file, and instances of them
    std::uint64_t pixels = 268'435'456;    ///< of one picture
    std::uint64_t nesting = 200;  ///< objects and arrays within each other in JSON, 1..1000

    bool operator==(const LoadLimits&) const = default;
};

/// What handles JSON recurses: LoadLimits::nesting is never taken to be more.
inline constexpr std::uint64_t kMaxNesting = 1000;

struct LoadOptions {
    /// One of the file's scenes, by name or counted from 0; none: the file's own choice, or its
    /// first one.
    std::optional<std::string> scene{};
    /// One of its material variants (KHR_materials_variants), the same way; none: the materials
    /// that it shows by default.
    std::optional<std::string> variant{};
    LoadLimits limits{};
    /// Whether buffers, pictures and the like may lie outside the scene's folder.
    bool allowOutside = false;

    double unitScale = 1.0;       ///< metres of one of the file's units, > 0
    double intensityScale = 1.0;  ///< of all lamps, > 0

    /// Where meshes that took time to decode are kept for the next start; null: nowhere. Outlives
    /// the load.
    const FileCache* cache = nullptr;

    bool operator==(const LoadOptions&) const = default;
};

}  // namespace ribalta
