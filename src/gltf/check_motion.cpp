#include "gltf/check_motion.h"

#include <algorithm>
#include <cmath>

#include "gltf/read_nodes.h"

namespace ribalta::gltf {
namespace {

// Upper bounds of how far a matrix moves the origin and of how much it lengthens what it places.
struct Reach {
    double move = 0.0;
    double lengthen = 0.0;
};

// The longest column is exact where the columns stand at right angles; else all of it is added up.
double lengthening(const glm::dmat4& matrix) {
    const glm::dmat3 axes(matrix);
    const glm::dvec3 lengths(glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]));
    const double longest = std::max({lengths.x, lengths.y, lengths.z});
    const double skew =
        std::max({std::abs(glm::dot(axes[0], axes[1])), std::abs(glm::dot(axes[1], axes[2])),
                  std::abs(glm::dot(axes[2], axes[0]))});
    return skew <= 1e-9 * longest * longest ? longest : glm::length(lengths);
}

// The longest value between any keys. Of a spline's four weights those of the values add up to 1,
// and those of the tangents are below 4/27.
double longest(const AnimationSampler& sampler) {
    const bool cubic = sampler.interpolation == AnimationSampler::Interpolation::kCubicSpline;
    double value = 0.0;
    double tangent = 0.0;
    for (std::size_t i = 0; i < sampler.values.size(); ++i) {
        const double length = glm::length(glm::dvec3(sampler.values[i]));
        (cubic && i % 3 != 1 ? tangent : value) =
            std::max(cubic && i % 3 != 1 ? tangent : value, length);
    }
    double gap = 0.0;
    for (std::size_t i = 1; i < sampler.seconds.size(); ++i) {
        gap = std::max(gap, double(sampler.seconds[i]) - double(sampler.seconds[i - 1]));
    }
    return value + 0.3 * gap * tangent;
}

}  // namespace

std::optional<std::size_t> movesOutOfBounds(const Scene& scene, const std::vector<Node>& nodes) {
    std::vector<Reach> local(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const glm::dmat4& matrix = nodes[i].parentFromLocal;
        local[i] = {glm::length(glm::dvec3(matrix[3])), lengthening(matrix)};
    }
    for (const Animation& animation : scene.animations) {
        for (const AnimationChannel& channel : animation.channels) {
            if (channel.part == AnimationChannel::Part::kWeights ||
                channel.part == AnimationChannel::Part::kDial) {
                continue;
            }
            Reach& reach = local[std::size_t(scene.movers[std::size_t(channel.mover)].node)];
            const AnimationSampler& sampler = animation.samplers[std::size_t(channel.sampler)];
            if (channel.part == AnimationChannel::Part::kTranslation) {
                reach.move = std::max(reach.move, longest(sampler));
            } else if (channel.part == AnimationChannel::Part::kScale) {
                reach.lengthen = std::max(reach.lengthen, longest(sampler));
            }
        }
    }
    std::vector<Reach> world(nodes.size());
    std::vector<char> moves(nodes.size(), 0);
    for (const Mover& mover : scene.movers) {
        moves[std::size_t(mover.node)] = 1;
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        world[i] = local[i];
        if (nodes[i].parent >= 0) {
            const auto parent = std::size_t(nodes[i].parent);
            world[i].move = world[parent].move + world[parent].lengthen * local[i].move;
            world[i].lengthen = world[parent].lengthen * local[i].lengthen;
            moves[i] = char(moves[i] | moves[parent]);
        }
        if (moves[i] != 0 &&
            !(world[i].move <= kMaxTransform && world[i].lengthen <= kMaxTransform)) {
            return i;
        }
    }
    return std::nullopt;
}

}  // namespace ribalta::gltf
