// Animation: how nodes move over time, as plain data, and its values at a given second (glTF 2.0,
// section 3.11 and appendix C). No clock: what time it is, is the caller's business.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "scene/pose.h"

namespace ribalta {

struct Camera;
struct Scene;

/// Keys, and the way from one to the next. Before the first and after the last nothing changes.
struct AnimationSampler {
    enum class Interpolation {
        kStep,         ///< a key's value holds until the next
        kLinear,       ///< straight; rotations at an even pace along the shorter arc
        kCubicSpline,  ///< Hermite's, by the keys' tangents
    };

    Interpolation interpolation = Interpolation::kLinear;
    std::vector<float> seconds;  ///< by key; at least one, finite, strictly increasing
    /// By key, finite: x, y, z, and w of rotations, which are of any length but none; of dials as
    /// many as the channel moves. With
    /// kCubicSpline three a key: the tangent into it, its value, the tangent out of it, both
    /// tangents a second.
    std::vector<glm::vec4> values;
    /// Instead of them, of morph targets: by key and by target, with kCubicSpline three rows a key.
    std::vector<float> weights{};
    std::size_t targets = 0;  ///< weights in a row
};

/// What a sampler moves.
struct AnimationChannel {
    enum class Part { kTranslation, kRotation, kScale, kWeights, kDial };

    /// Into Scene::movers; of kWeights into Scene::deformers, of kDial into Scene::dials.
    int mover = -1;
    int sampler = -1;  ///< into Animation::samplers; of kWeights one with `weights`
    Part part = Part::kTranslation;
    int first = 0;  ///< of kDial: which of its numbers come from the sampler's
    int count = 0;
};

struct Animation {
    std::string name;
    std::vector<AnimationSampler> samplers;
    std::vector<AnimationChannel> channels;  ///< nothing of a mover, deformer or dial twice
};

/// A node that some animation moves.
struct Mover {
    int node = -1;  ///< into Scene::nodes
    Pose rest;      ///< as the file places it
    Pose pose;      ///< as it stands; its node's parentFromLocal is made of it
};

/// All of a scene's animations on one timeline, as Blender writes one action a lamp. Where several
/// move the same part of a node, the first of them is seen.
inline constexpr int kAllAnimations = -1;

/// The value at a time. A vector's w is without meaning.
glm::dvec4 sampleVector(const AnimationSampler& sampler, double seconds);
/// The value at a time, brought to unit length.
glm::dquat sampleRotation(const AnimationSampler& sampler, double seconds);
/// The weights at a time, as many as both have.
void sampleWeights(const AnimationSampler& sampler, double seconds, std::span<float> weights);

/// Whether there is anything to play.
bool isAnimated(const Scene& scene);

/// When the last key of an animation (an index into Scene::animations, or kAllAnimations) is
/// reached; 0 where nothing moves.
double durationSeconds(const Scene& scene, int animation = kAllAnimations);

/// Moves the scene's nodes, and what hangs on them, to where they are at a time, shapes what is
/// deformed, and turns the dials. What the chosen animation does not move rests. Takes no memory.
void poseScene(Scene& scene, double seconds, int animation = kAllAnimations);

/// Puts all that moves back to where the file places it.
void restScene(Scene& scene);

/// A camera of the scene, or one that was, as the scene is posed: where its node has gone, and with
/// what of its lens is animated; the rest of it stays. One without a node stays as it is.
Camera posedCamera(const Scene& scene, const Camera& camera);

}  // namespace ribalta
