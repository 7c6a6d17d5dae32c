#include "gltf/photometric_web.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"

namespace ribalta::gltf {
namespace {

struct Angles {
    double vertical = 0.0;
    double horizontal = 0.0;
};

double arcSine(double value) {
    return std::asin(std::clamp(value, -1.0, 1.0)) * kDegreesPerRadian;
}

Angles anglesOf(PhotometricWeb::Type type, const glm::dvec3& direction) {
    switch (type) {
        case PhotometricWeb::Type::kB:
            return {std::atan2(direction.x, -direction.z) * kDegreesPerRadian,
                    arcSine(-direction.y)};
        case PhotometricWeb::Type::kA:
            return {arcSine(direction.x),
                    std::atan2(-direction.y, -direction.z) * kDegreesPerRadian};
        case PhotometricWeb::Type::kC:
            break;
    }
    // By both sides of the triangle: the cosine alone says little near the axis.
    const double off = std::hypot(direction.x, direction.y);
    return {std::atan2(off, -direction.z) * kDegreesPerRadian,
            std::atan2(direction.y, direction.x) * kDegreesPerRadian};
}

// Two neighbours in a list, and how far from the first to the second.
struct Between {
    std::size_t first = 0;
    std::size_t second = 0;
    double share = 0.0;
};

// Of an angle that is within the list.
Between find(const std::vector<double>& angles, double angle) {
    const auto above = std::upper_bound(angles.begin(), angles.end(), angle);
    const auto second = std::size_t(
        std::clamp<std::ptrdiff_t>(above - angles.begin(), 1, std::ptrdiff_t(angles.size()) - 1));
    const std::size_t first = second - 1;
    const double share = (angle - angles[first]) / (angles[second] - angles[first]);
    return {first, second, std::clamp(share, 0.0, 1.0)};
}

// Type C goes all around: what the table lacks is a mirror image, or the way from its last angle
// on to its first.
Between findAround(const std::vector<double>& angles, double angle) {
    const double first = angles.front();
    const double last = angles.back();
    angle -= 360.0 * std::floor(angle / 360.0);
    const bool startsAtZero = first == 0.0;
    if (startsAtZero && (last == 90.0 || last == 180.0)) {
        angle = angle > 180.0 ? 360.0 - angle : angle;
        angle = last == 90.0 && angle > 90.0 ? 180.0 - angle : angle;
    } else if (first == 90.0 && last == 270.0) {
        angle = angle < 90.0 ? 180.0 - angle : angle > 270.0 ? 540.0 - angle : angle;
    }
    if (angle >= first && angle <= last) {
        return find(angles, angle);
    }
    const double gap = first + 360.0 - last;
    const double beyond = angle > last ? angle - last : angle + 360.0 - last;
    return {angles.size() - 1, 0, std::clamp(beyond / gap, 0.0, 1.0)};
}

}  // namespace

double PhotometricWeb::at(const glm::dvec3& direction) const {
    Angles angles = anglesOf(type, direction);
    if (angles.vertical < vertical.front() || angles.vertical > vertical.back()) {
        return 0.0;
    }
    Between around;
    if (horizontal.size() > 1) {
        if (type == Type::kC) {
            around = findAround(horizontal, angles.horizontal);
        } else {
            // Half a table is one of a luminaire whose two sides are alike.
            angles.horizontal =
                horizontal.front() == 0.0 ? std::abs(angles.horizontal) : angles.horizontal;
            if (angles.horizontal < horizontal.front() || angles.horizontal > horizontal.back()) {
                return 0.0;
            }
            around = find(horizontal, angles.horizontal);
        }
    }
    const Between along = find(vertical, angles.vertical);
    const auto between = [&](std::size_t plane) {
        const double* const values = &candela[plane * vertical.size()];
        return values[along.first] + along.share * (values[along.second] - values[along.first]);
    };
    const double first = between(around.first);
    return first + around.share * (between(around.second) - first);
}

}  // namespace ribalta::gltf
