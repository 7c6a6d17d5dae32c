#include "gltf/mend_primitive.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "gltf/tally.h"

namespace ribalta::gltf {
namespace {

// An optional attribute that does not fit is left out; the rest can be drawn.
template <typename T>
void dropMisfit(std::vector<T>& values, std::size_t count, const char* name, const Place& place,
                Report& report) {
    if (values.empty() || values.size() == count) {
        return;
    }
    report.repaired(place.at("attributes").at(name), "has " + std::to_string(values.size()) +
                                                         " elements for " + std::to_string(count) +
                                                         " vertices; it is left out");
    values.clear();
}

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

template <typename T>
std::size_t replaceNonFinite(std::vector<T>& values, const T& replacement) {
    std::size_t replaced = 0;
    for (T& value : values) {
        bool finite = true;
        for (int c = 0; c < T::length(); ++c) {
            finite = finite && std::isfinite(value[c]);
        }
        if (!finite) {
            value = replacement;
            ++replaced;
        }
    }
    return replaced;
}

void mendAttributes(Primitive& primitive, const Place& place, Report& report) {
    const std::size_t count = primitive.positions.size();
    dropMisfit(primitive.normals, count, "NORMAL", place, report);
    dropMisfit(primitive.tangents, count, "TANGENT", place, report);
    dropMisfit(primitive.uv0, count, "TEXCOORD_0", place, report);
    dropMisfit(primitive.uv1, count, "TEXCOORD_1", place, report);
    dropMisfit(primitive.colors, count, "COLOR_0", place, report);
    const auto tell = [&](std::size_t replaced, const char* name, const char* by) {
        if (replaced > 0) {
            report.repaired(
                place.at("attributes").at(name),
                std::to_string(replaced) + " elements are not finite numbers; " + by + " is used");
        }
    };
    tell(replaceNonFinite(primitive.uv0, glm::vec2(0.0F)), "TEXCOORD_0", "0");
    tell(replaceNonFinite(primitive.uv1, glm::vec2(0.0F)), "TEXCOORD_1", "0");
    tell(replaceNonFinite(primitive.colors, glm::vec4(1.0F)), "COLOR_0", "white");
    for (glm::vec4& color : primitive.colors) {
        color = glm::clamp(color, glm::vec4(0.0F), glm::vec4(1.0F));
    }
}

// Metres. Farther places, moved by joints and seen from elsewhere, leave single precision.
constexpr float kFarthest = 1e18F;

bool isPlace(const glm::vec3& position) {
    return isFinite(position) && glm::all(glm::lessThan(glm::abs(position), glm::vec3(kFarthest)));
}

// Takes out triangles (lines, points) with a corner that is no place.
void dropNonFinite(Primitive& primitive, const Place& place, Report& report) {
    std::vector<char> broken(primitive.positions.size(), 0);
    bool any = false;
    for (std::size_t i = 0; i < broken.size(); ++i) {
        if (!isPlace(primitive.positions[i])) {
            broken[i] = 1;
            any = true;
            primitive.positions[i] = glm::vec3(0.0F);
        }
    }
    if (!any) {
        return;
    }
    const std::size_t corners = primitive.topology == Topology::kTriangles ? 3
                                : primitive.topology == Topology::kLines   ? 2
                                                                           : 1;
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i + corners <= primitive.indices.size(); i += corners) {
        const auto first = primitive.indices.begin() + std::ptrdiff_t(i);
        const auto last = first + std::ptrdiff_t(corners);
        if (std::none_of(first, last, [&](std::uint32_t index) { return broken[index] != 0; })) {
            kept.insert(kept.end(), first, last);
        }
    }
    report.repaired(
        place.at("attributes").at("POSITION"),
        "holds positions that are not finite numbers below 1e18; what they belong to (" +
            std::to_string((primitive.indices.size() - kept.size()) / corners) + " of " +
            std::to_string(primitive.indices.size() / corners) + " pieces) is left out");
    primitive.indices = std::move(kept);
}

template <typename T>
void keepVertices(std::vector<T>& values, const std::vector<std::uint32_t>& kept,
                  std::size_t each = 1) {
    if (values.empty()) {
        return;
    }
    std::vector<T> result;
    result.reserve(kept.size() * each);
    for (const std::uint32_t vertex : kept) {
        for (std::size_t i = 0; i < each; ++i) {
            result.push_back(values[vertex * each + i]);
        }
    }
    values = std::move(result);
}

// Vertices that nothing draws: primitives often share one long vertex buffer.
void dropUnusedVertices(Primitive& primitive) {
    constexpr std::uint32_t kUnused = 0xFFFFFFFF;
    std::vector<std::uint32_t> newIndex(primitive.positions.size(), kUnused);
    std::vector<std::uint32_t> kept;
    for (const std::uint32_t index : primitive.indices) {
        newIndex[index] = 0;
    }
    for (std::uint32_t i = 0; i < newIndex.size(); ++i) {
        if (newIndex[i] != kUnused) {
            newIndex[i] = std::uint32_t(kept.size());
            kept.push_back(i);
        }
    }
    if (kept.size() == primitive.positions.size()) {
        return;
    }
    for (std::uint32_t& index : primitive.indices) {
        index = newIndex[index];
    }
    keepVertices(primitive.positions, kept);
    keepVertices(primitive.normals, kept);
    keepVertices(primitive.tangents, kept);
    keepVertices(primitive.uv0, kept);
    keepVertices(primitive.uv1, kept);
    keepVertices(primitive.colors, kept);
    keepVertices(primitive.influences, kept, std::size_t(primitive.influencesPerVertex));
    for (MorphTarget& target : primitive.targets) {
        keepVertices(target.positions, kept);
        keepVertices(target.normals, kept);
        keepVertices(target.tangents, kept);
    }
}

// What eight bits a coordinate may do to a unit vector's length, and room.
constexpr float kLengthTolerance = 0.02F;

// Normals and tangents of unit length; those that have no direction get a stand-in.
void normalise(Primitive& primitive, const Place& place, Report& report) {
    std::size_t broken = 0;
    std::size_t longOrShort = 0;
    for (glm::vec3& normal : primitive.normals) {
        const float length = glm::length(normal);
        const bool usable = std::isfinite(length) && length > 1e-20F;
        normal = usable ? normal / length : glm::vec3(0.0F, 1.0F, 0.0F);
        broken += usable ? 0 : 1;
        longOrShort += usable && std::abs(length - 1.0F) > kLengthTolerance ? 1 : 0;
    }
    if (longOrShort > 0) {
        report.repaired(place.at("attributes").at("NORMAL"),
                        counted(longOrShort, "normals") + " not of unit length; made so");
    }
    if (broken > 0) {
        report.repaired(place.at("attributes").at("NORMAL"),
                        std::to_string(broken) + " normals have no direction; +Y is used");
    }
    broken = 0;
    for (glm::vec4& tangent : primitive.tangents) {
        const glm::vec3 axis(tangent.x, tangent.y, tangent.z);
        const float length = glm::length(axis);
        const bool usable = std::isfinite(length) && length > 1e-20F;
        tangent = glm::vec4(usable ? axis / length : glm::vec3(1.0F, 0.0F, 0.0F),
                            tangent.w < 0.0F ? -1.0F : 1.0F);
        broken += usable ? 0 : 1;
    }
    if (broken > 0) {
        report.repaired(place.at("attributes").at("TANGENT"),
                        std::to_string(broken) + " tangents have no direction; +X is used");
    }
}

}  // namespace

void mendPrimitive(Primitive& primitive, const Place& place, Report& report) {
    mendAttributes(primitive, place, report);
    dropNonFinite(primitive, place, report);
    dropUnusedVertices(primitive);
    normalise(primitive, place, report);
}

}  // namespace ribalta::gltf
