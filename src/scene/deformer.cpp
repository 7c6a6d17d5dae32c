#include "scene/deformer.h"

#include <algorithm>
#include <cstddef>

#include "base/content_hash.h"
#include "base/parallel_for.h"
#include "optics/shader_lib.h"
#include "scene/scene.h"

namespace ribalta {
namespace {

// Products with coordinates, which are below 1e18 at rest and may be moved by targets, still fit
// single precision.
constexpr double kLargest = 1e15;
constexpr std::size_t kVerticesAtOnce = 4096;

glm::mat4 inSingle(const glm::dmat4& matrix) {
    glm::mat4 result;
    for (int column = 0; column < 4; ++column) {
        result[column] = glm::vec4(glm::clamp(matrix[column], -kLargest, kLargest));
    }
    return result;
}

bool isMirrored(const glm::dmat4& matrix) {
    return glm::determinant(glm::dmat3(matrix)) < 0.0;
}

std::uint64_t shapeOf(const Deformer& deformer) {
    ContentHash hash;
    hash.add(deformer.weights);
    hash.add(deformer.localFromMesh);
    return std::max<std::uint64_t>(hash.value(), 1);
}

void skin(Deformer& deformer, Scene& scene) {
    const Skin& skin = scene.skins[std::size_t(deformer.skin)];
    const auto joint = [&](std::size_t j) -> const glm::dmat4& {
        return scene.nodes[std::size_t(skin.joints[j])].worldFromLocal;
    };
    std::size_t mirrored = 0;
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
        mirrored += isMirrored(joint(j)) != isMirrored(skin.jointFromMesh[j]) ? 1 : 0;
    }
    // A reflection in x is its own inverse.
    const double side = 2 * mirrored > skin.joints.size() ? -1.0 : 1.0;
    const glm::dvec3 place = glm::clamp(glm::dvec3(joint(0)[3]), -kLargest, kLargest);
    glm::dmat4 localFromWorld(1.0);
    localFromWorld[0][0] = side;
    localFromWorld[3] = glm::dvec4(-side * place.x, -place.y, -place.z, 1.0);
    Node& node = scene.nodes[std::size_t(deformer.node)];
    node.worldFromLocal = glm::dmat4(1.0);
    node.worldFromLocal[0][0] = side;
    node.worldFromLocal[3] = glm::dvec4(place, 1.0);

    deformer.localFromMesh.resize(skin.joints.size());
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
        deformer.localFromMesh[j] = inSingle(localFromWorld * (joint(j) * skin.jointFromMesh[j]));
    }
}

// One primitive in one shape, vertex by vertex. The same steps as shaders/passes/deform.comp.
class Deformation {
  public:
    Deformation(const Primitive& primitive, const Deformer& deformer)
        : primitive_(primitive), deformer_(deformer) {
        for (std::size_t t = 0; t < std::min(primitive.targets.size(), deformer.weights.size());
             ++t) {
            if (deformer.weights[t] != 0.0F) {
                active_.push_back(t);
            }
        }
        for (const glm::mat4& matrix : deformer.localFromMesh) {
            joints_.emplace_back(matrix);
        }
    }

    void deform(std::size_t vertex, DeformedVertices& result) const {
        const glm::dmat4 matrix = blend(vertex);
        const glm::dvec3 position = shader::deformedPosition(matrix, morphed(vertex));
        result.positions[vertex] = glm::vec3(position);
        if (!primitive_.normals.empty()) {
            result.normals[vertex] = glm::vec3(normalOf(vertex, matrix));
        }
        if (!primitive_.tangents.empty()) {
            const glm::vec4& rest = primitive_.tangents[vertex];
            const glm::dvec3 tangent = sum(vertex, glm::dvec3(rest), &MorphTarget::tangents);
            result.tangents[vertex] = glm::vec4(glm::vec3(shader::deformedTangent(matrix, tangent)),
                                                rest.w * float(shader::deformedSide(matrix)));
        }
    }

  private:
    using Array = std::vector<glm::vec3> MorphTarget::*;

    glm::dvec3 sum(std::size_t vertex, glm::dvec3 value, Array array) const {
        for (const std::size_t t : active_) {
            const std::vector<glm::vec3>& displacements = primitive_.targets[t].*array;
            if (!displacements.empty()) {
                value = shader::addTarget(value, glm::dvec3(displacements[vertex]),
                                          double(deformer_.weights[t]));
            }
        }
        return value;
    }

    glm::dvec3 morphed(std::size_t vertex) const {
        return sum(vertex, glm::dvec3(primitive_.positions[vertex]), &MorphTarget::positions);
    }

    glm::dmat4 blend(std::size_t vertex) const {
        const auto each = std::size_t(primitive_.influencesPerVertex);
        if (joints_.empty() || each == 0) {
            return glm::dmat4(1.0);
        }
        glm::dmat4 matrix(0.0);
        for (std::size_t i = 0; i < each; ++i) {
            const Influence& influence = primitive_.influences[vertex * each + i];
            const std::size_t joint = std::min(std::size_t(influence.joint), joints_.size() - 1);
            matrix = shader::addJoint(matrix, joints_[joint], double(influence.weight));
        }
        return matrix;
    }

    glm::dvec3 normalOf(std::size_t vertex, const glm::dmat4& matrix) const {
        const glm::dvec3 rest =
            sum(vertex, glm::dvec3(primitive_.normals[vertex]), &MorphTarget::normals);
        const glm::dvec3 turned = shader::deformedNormal(matrix, rest);
        if (!primitive_.flatNormals) {
            return turned;
        }
        glm::dvec3 corners[3];
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t corner = vertex / 3 * 3 + c;
            corners[c] = shader::deformedPosition(blend(corner), morphed(corner));
        }
        return shader::faceNormal(corners[0], corners[1], corners[2], shader::deformedSide(matrix),
                                  turned);
    }

    const Primitive& primitive_;
    const Deformer& deformer_;
    std::vector<std::size_t> active_;  ///< targets that count
    std::vector<glm::dmat4> joints_;
};

}  // namespace

void shapeDeformers(Scene& scene) {
    for (Deformer& deformer : scene.deformers) {
        if (deformer.skin >= 0) {
            skin(deformer, scene);
        }
        deformer.shape = shapeOf(deformer);
    }
}

DeformedVertices deformVertices(const Primitive& primitive, const Deformer& deformer) {
    DeformedVertices result;
    const std::size_t count = primitive.positions.size();
    result.positions.resize(count);
    result.normals.resize(primitive.normals.size());
    result.tangents.resize(primitive.tangents.size());
    const Deformation deformation(primitive, deformer);
    parallelFor((count + kVerticesAtOnce - 1) / kVerticesAtOnce, [&](std::size_t part) {
        const std::size_t end = std::min(count, (part + 1) * kVerticesAtOnce);
        for (std::size_t vertex = part * kVerticesAtOnce; vertex < end; ++vertex) {
            deformation.deform(vertex, result);
        }
    });
    return result;
}

Bounds deformedBounds(const Primitive& primitive, const Deformer& deformer) {
    glm::dvec3 least(0.0);
    glm::dvec3 most(0.0);
    for (std::size_t t = 0; t < std::min(primitive.targets.size(), deformer.weights.size()); ++t) {
        const Bounds& reach = primitive.targets[t].bounds;
        const auto weight = double(deformer.weights[t]);
        if (weight != 0.0 && !reach.isEmpty()) {
            least += glm::min(weight * reach.low, weight * reach.high);
            most += glm::max(weight * reach.low, weight * reach.high);
        }
    }
    const auto widened = [&](const Bounds& bounds) {
        return bounds.isEmpty() ? bounds : Bounds{bounds.low + least, bounds.high + most};
    };
    if (deformer.localFromMesh.empty() || primitive.influencesPerVertex == 0) {
        return widened(primitive.bounds);
    }
    Bounds bounds;
    for (std::size_t j = 0; j < primitive.jointBounds.size(); ++j) {
        const glm::mat4& matrix =
            deformer.localFromMesh[std::min(j, deformer.localFromMesh.size() - 1)];
        bounds.add(transformed(glm::dmat4(matrix), widened(primitive.jointBounds[j])));
    }
    return bounds;
}

}  // namespace ribalta
