// PhotometricWeb: how many candela a luminaire sends in every direction, as it was measured. No
// files, no pictures.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

namespace ribalta::gltf {

struct PhotometricWeb {
    /// How the two angles span the sphere. All have (0, 0) straight ahead.
    enum class Type {
        /// `vertical` is the angle off the axis, 0..180, `horizontal` goes around it, from +X
        /// towards +Y. Tables of a half or a quarter of the circle are mirrored.
        kC,
        /// `vertical` turns about the luminaire's horizontal axis, towards +X; `horizontal` is the
        /// angle off that turned plane, towards -Y.
        kB,
        /// `horizontal` turns about the vertical axis, towards -Y; `vertical` is the angle off that
        /// turned plane, towards +X.
        kA,
    };

    Type type = Type::kC;
    std::vector<double> vertical;    ///< degrees, rising, two or more
    std::vector<double> horizontal;  ///< degrees, rising, one or more; one: the same all around
    std::vector<double> candela;     ///< of all vertical angles of the first horizontal one, ...

    /// Candela in a unit direction, interpolated between the angles; 0 beyond the vertical ones.
    /// The luminaire shines along -Z, the way that glTF's lamps do.
    double at(const glm::dvec3& direction) const;
};

}  // namespace ribalta::gltf
