#include "scene/animation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "scene/scene.h"

namespace ribalta {
namespace {

using Interpolation = AnimationSampler::Interpolation;

// The two keys around a time, and how far it is from the first to the second.
struct Stretch {
    std::size_t first = 0;
    std::size_t second = 0;
    double share = 0.0;    ///< 0..1
    double seconds = 0.0;  ///< between the keys
};

Stretch stretchAt(const AnimationSampler& sampler, double seconds) {
    const std::vector<float>& keys = sampler.seconds;
    const auto after = std::upper_bound(keys.begin(), keys.end(), seconds,
                                        [](double time, float key) { return time < double(key); });
    if (after == keys.begin()) {
        return {};
    }
    const auto first = std::size_t(after - keys.begin()) - 1;
    if (after == keys.end()) {
        return {first, first, 0.0, 0.0};
    }
    const double length = double(keys[first + 1]) - double(keys[first]);
    return {first, first + 1, (seconds - double(keys[first])) / length, length};
}

// Appendix C.5: how much of the two keys' values and of the tangents between them.
struct HermiteShares {
    double from = 1.0;
    double out = 0.0;
    double to = 0.0;
    double in = 0.0;
};

HermiteShares hermiteShares(const Stretch& at) {
    const double t = at.share;
    const double t2 = t * t;
    const double t3 = t2 * t;
    return {2.0 * t3 - 3.0 * t2 + 1.0, at.seconds * (t3 - 2.0 * t2 + t), 3.0 * t2 - 2.0 * t3,
            at.seconds * (t3 - t2)};
}

glm::dvec4 hermite(const AnimationSampler& sampler, const Stretch& at) {
    const std::vector<glm::vec4>& values = sampler.values;
    const glm::dvec4 from(values[3 * at.first + 1]);
    if (at.first == at.second) {
        return from;
    }
    const HermiteShares share = hermiteShares(at);
    return share.from * from + share.out * glm::dvec4(values[3 * at.first + 2]) +
           share.to * glm::dvec4(values[3 * at.second + 1]) +
           share.in * glm::dvec4(values[3 * at.second]);
}

// Appendix C.4, the shorter way. The angle by its half's tangent, which is exact for small ones.
glm::dvec4 slerp(const glm::dvec4& from, glm::dvec4 to, double share) {
    if (glm::dot(from, to) < 0.0) {
        to = -to;
    }
    const double angle = 2.0 * std::atan2(glm::length(to - from), glm::length(to + from));
    const double sine = std::sin(angle);
    if (sine < 1e-9) {
        return from + share * (to - from);
    }
    return (std::sin((1.0 - share) * angle) * from + std::sin(share * angle) * to) / sine;
}

glm::dvec4 normalizedKey(const AnimationSampler& sampler, std::size_t key) {
    const bool cubic = sampler.interpolation == Interpolation::kCubicSpline;
    return glm::normalize(glm::dvec4(sampler.values[cubic ? 3 * key + 1 : key]));
}

void apply(const Animation& animation, double seconds, Scene& scene) {
    for (const AnimationChannel& channel : animation.channels) {
        const AnimationSampler& sampler = animation.samplers[std::size_t(channel.sampler)];
        const auto mover = std::size_t(channel.mover);
        switch (channel.part) {
            case AnimationChannel::Part::kTranslation:
                scene.movers[mover].pose.translation = glm::dvec3(sampleVector(sampler, seconds));
                break;
            case AnimationChannel::Part::kRotation:
                scene.movers[mover].pose.rotation = sampleRotation(sampler, seconds);
                break;
            case AnimationChannel::Part::kScale:
                scene.movers[mover].pose.scale = glm::dvec3(sampleVector(sampler, seconds));
                break;
            case AnimationChannel::Part::kWeights:
                sampleWeights(sampler, seconds, scene.deformers[mover].weights);
                break;
            case AnimationChannel::Part::kDial: {
                const glm::dvec4 value = sampleVector(sampler, seconds);
                for (int c = 0; c < channel.count; ++c) {
                    scene.dials[mover].now[channel.first + c] = value[c];
                }
                break;
            }
        }
    }
}

void placeMovers(Scene& scene) {
    for (const Dial& dial : scene.dials) {
        bringTo(dial, scene);
    }
    for (const Mover& mover : scene.movers) {
        scene.nodes[std::size_t(mover.node)].parentFromLocal = mover.pose.parentFromLocal();
    }
    placeNodes(scene);
}

void rest(Scene& scene) {
    for (Mover& mover : scene.movers) {
        mover.pose = mover.rest;
    }
    for (Deformer& deformer : scene.deformers) {
        deformer.weights = deformer.restWeights;
    }
    for (Dial& dial : scene.dials) {
        dial.now = dial.rest;
    }
}

}  // namespace

glm::dvec4 sampleVector(const AnimationSampler& sampler, double seconds) {
    const Stretch at = stretchAt(sampler, seconds);
    if (sampler.interpolation == Interpolation::kCubicSpline) {
        return hermite(sampler, at);
    }
    const glm::dvec4 from(sampler.values[at.first]);
    if (sampler.interpolation == Interpolation::kStep || at.first == at.second) {
        return from;
    }
    return from + at.share * (glm::dvec4(sampler.values[at.second]) - from);
}

glm::dquat sampleRotation(const AnimationSampler& sampler, double seconds) {
    const Stretch at = stretchAt(sampler, seconds);
    glm::dvec4 value = normalizedKey(sampler, at.first);
    if (at.first != at.second && sampler.interpolation == Interpolation::kLinear) {
        value = glm::normalize(slerp(value, normalizedKey(sampler, at.second), at.share));
    } else if (sampler.interpolation == Interpolation::kCubicSpline) {
        const glm::dvec4 curve = hermite(sampler, at);
        // A curve through the origin has no direction there; the key before it has.
        if (glm::length(curve) > 1e-9) {
            value = glm::normalize(curve);
        }
    }
    return {value.w, value.x, value.y, value.z};
}

void sampleWeights(const AnimationSampler& sampler, double seconds, std::span<float> weights) {
    const Stretch at = stretchAt(sampler, seconds);
    const bool cubic = sampler.interpolation == Interpolation::kCubicSpline;
    const auto row = [&](std::size_t key, std::size_t part) {
        return &sampler.weights[(cubic ? 3 * key + part : key) * sampler.targets];
    };
    const float* from = row(at.first, 1);
    const float* to = row(at.second, 1);
    const float* out = row(at.first, 2);
    const float* in = row(at.second, 0);
    const HermiteShares share = hermiteShares(at);
    const bool between = at.first != at.second && sampler.interpolation != Interpolation::kStep;
    for (std::size_t t = 0; t < std::min(sampler.targets, weights.size()); ++t) {
        double value(from[t]);
        if (between && cubic) {
            value = share.from * double(from[t]) + share.out * double(out[t]) +
                    share.to * double(to[t]) + share.in * double(in[t]);
        } else if (between) {
            value += at.share * (double(to[t]) - double(from[t]));
        }
        weights[t] = float(value);
    }
}

bool isAnimated(const Scene& scene) {
    return std::any_of(scene.animations.begin(), scene.animations.end(),
                       [](const Animation& animation) { return !animation.channels.empty(); });
}

double durationSeconds(const Scene& scene, int animation) {
    double last = 0.0;
    for (std::size_t i = 0; i < scene.animations.size(); ++i) {
        if (animation != kAllAnimations && std::size_t(animation) != i) {
            continue;
        }
        const Animation& each = scene.animations[i];
        for (const AnimationChannel& channel : each.channels) {
            last =
                std::max(last, double(each.samplers[std::size_t(channel.sampler)].seconds.back()));
        }
    }
    return last;
}

void poseScene(Scene& scene, double seconds, int animation) {
    rest(scene);
    if (animation == kAllAnimations) {
        // Backwards, so that the first has the last word.
        for (std::size_t i = scene.animations.size(); i-- > 0;) {
            apply(scene.animations[i], seconds, scene);
        }
    } else {
        apply(scene.animations[std::size_t(animation)], seconds, scene);
    }
    placeMovers(scene);
}

void restScene(Scene& scene) {
    rest(scene);
    placeMovers(scene);
}

Camera posedCamera(const Scene& scene, const Camera& camera) {
    Camera posed = camera;
    if (camera.node < 0 || camera.node >= int(scene.nodes.size())) {
        return posed;
    }
    posed.frame = rigidFrame(scene.nodes[std::size_t(camera.node)].worldFromLocal);
    for (const Dial& dial : scene.dials) {
        const bool isItsOwn = dial.list == Dial::List::kCameras &&
                              std::any_of(dial.owners.begin(), dial.owners.end(), [&](int owner) {
                                  return scene.cameras[std::size_t(owner)].node == camera.node;
                              });
        if (isItsOwn) {
            bringTo(dial, posed);
        }
    }
    return posed;
}

}  // namespace ribalta
