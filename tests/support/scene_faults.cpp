#include "support/scene_faults.h"

#include <cmath>
#include <cstddef>

namespace ribalta::test {
namespace {

class Faults {
  public:
    void check(bool holds, const std::string& what) {
        if (!holds && lines_.size() < 20) {
            lines_.push_back(what);
        }
    }

    void checkIndex(int index, std::size_t count, const std::string& what) {
        check(index >= -1 && index < int(count), what + " is out of range");
    }

    template <typename T>
    void checkFinite(const T& vector, const std::string& what) {
        for (int c = 0; c < T::length(); ++c) {
            check(std::isfinite(vector[c]), what + " is not finite");
        }
    }

    bool any() const { return !lines_.empty(); }
    std::vector<std::string> take() { return std::move(lines_); }

  private:
    std::vector<std::string> lines_;
};

void checkMatrix(const glm::dmat4& matrix, const std::string& what, Faults& faults) {
    for (int column = 0; column < 4; ++column) {
        faults.checkFinite(matrix[column], what);
    }
}

template <typename T>
void checkArray(const std::vector<T>& values, std::size_t count, const std::string& what,
                Faults& faults) {
    faults.check(values.empty() || values.size() == count, what + " has the wrong length");
    for (const T& value : values) {
        faults.checkFinite(value, what);
    }
}

void checkPrimitive(const Primitive& primitive, std::size_t materials, const std::string& what,
                    Faults& faults) {
    const std::size_t count = primitive.positions.size();
    faults.check(count > 0 && !primitive.indices.empty(), what + " draws nothing");
    checkArray(primitive.positions, count, what + " positions", faults);
    checkArray(primitive.normals, count, what + " normals", faults);
    checkArray(primitive.tangents, count, what + " tangents", faults);
    checkArray(primitive.uv0, count, what + " uv0", faults);
    checkArray(primitive.uv1, count, what + " uv1", faults);
    checkArray(primitive.colors, count, what + " colors", faults);
    for (const std::uint32_t index : primitive.indices) {
        faults.check(index < count, what + " index is out of range");
    }
    for (const glm::vec3& normal : primitive.normals) {
        faults.check(std::abs(glm::length(normal) - 1.0F) < 1e-3F, what + " normal is not unit");
    }
    for (const glm::vec4& tangent : primitive.tangents) {
        const float length = glm::length(glm::vec3(tangent.x, tangent.y, tangent.z));
        faults.check(std::abs(length - 1.0F) < 1e-3F, what + " tangent is not unit");
        faults.check(std::abs(tangent.w) == 1.0F, what + " tangent has no side");
    }
    const std::size_t corners = primitive.topology == Topology::kTriangles ? 3
                                : primitive.topology == Topology::kLines   ? 2
                                                                           : 1;
    faults.check(primitive.indices.size() % corners == 0, what + " ends within a piece");
    faults.check(primitive.topology != Topology::kTriangles || !primitive.normals.empty(),
                 what + " has triangles without normals");
    faults.checkIndex(primitive.material, materials, what + " material");
    faults.checkFinite(primitive.bounds.low, what + " bounds");
    faults.checkFinite(primitive.bounds.high, what + " bounds");
}

void checkMaterial(const Material& material, std::size_t textures, const std::string& what,
                   Faults& faults) {
    faults.checkFinite(material.baseColor, what + " baseColor");
    faults.checkFinite(material.emission, what + " emission");
    faults.check(material.metallic >= 0.0F && material.metallic <= 1.0F, what + " metallic");
    faults.check(material.roughness >= 0.0F && material.roughness <= 1.0F, what + " roughness");
    faults.check(std::isfinite(material.normalScale), what + " normalScale");
    faults.check(std::isfinite(material.occlusionStrength), what + " occlusionStrength");
    faults.check(std::isfinite(material.alphaCutoff), what + " alphaCutoff");
    const MaterialLayers layers = material.layers.value_or(MaterialLayers{});
    for (const float share : {layers.specular, layers.clearcoat, layers.clearcoatRoughness,
                              layers.sheenRoughness, layers.anisotropy, layers.transmission}) {
        faults.check(share >= 0.0F && share <= 1.0F, what + " layers");
    }
    faults.check(layers.ior == 0.0F || layers.ior >= 1.0F, what + " ior");
    faults.checkFinite(layers.specularColor, what + " specularColor");
    faults.checkFinite(layers.sheenColor, what + " sheenColor");
    for (const auto* slot :
         {&material.baseColorTexture, &material.metallicRoughnessTexture, &material.normalTexture,
          &material.occlusionTexture, &material.emissiveTexture, &layers.specularTexture,
          &layers.specularColorTexture, &layers.clearcoatTexture, &layers.clearcoatRoughnessTexture,
          &layers.clearcoatNormalTexture, &layers.sheenColorTexture, &layers.sheenRoughnessTexture,
          &layers.anisotropyTexture, &layers.transmissionTexture}) {
        if (!*slot) {
            continue;
        }
        faults.check((*slot)->texture >= 0 && (*slot)->texture < int(textures), what + " texture");
        faults.check((*slot)->uvSet == 0 || (*slot)->uvSet == 1, what + " uvSet");
        for (int column = 0; column < 3; ++column) {
            faults.checkFinite((*slot)->textureFromUv[column], what + " textureFromUv");
        }
    }
}

void checkFrame(const Frame& frame, const std::string& what, Faults& faults) {
    faults.checkFinite(frame.position, what + " position");
    const glm::dmat3 product = glm::transpose(frame.worldFromLocal) * frame.worldFromLocal;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            faults.check(std::abs(product[column][row] - (column == row ? 1.0 : 0.0)) < 1e-6,
                         what + " axes are not orthonormal");
        }
    }
}

void checkImage(const Image& image, const std::string& what, Faults& faults) {
    faults.check(image.width > 0 && image.height > 0, what + " is empty");
    faults.check(image.pixels.size() ==
                     std::size_t(image.width) * std::size_t(image.height) * image.bytesPerPixel(),
                 what + " has the wrong number of bytes");
}

void checkCamera(const Camera& camera, std::size_t nodes, Faults& faults) {
    const std::string what = "camera " + camera.name;
    faults.checkIndex(camera.node, nodes, what + " node");
    checkFrame(camera.frame, what, faults);
    faults.check(camera.farMetres > camera.nearMetres, what + " sees no depth");
    faults.check(camera.nearMetres >= 0.0 && std::isfinite(camera.nearMetres), what + " near");
    if (const auto* lens = std::get_if<PerspectiveLens>(&camera.lens)) {
        faults.check(camera.nearMetres > 0.0, what + " near");
        faults.check(lens->verticalFov > 0.0 && lens->verticalFov < 3.1415, what + " fov");
        faults.check(!lens->aspectRatio || (*lens->aspectRatio > 0.0 && *lens->aspectRatio < 1e6),
                     what + " aspect");
    } else {
        const auto& box = std::get<OrthographicLens>(camera.lens);
        faults.check(box.halfWidth > 0.0 && box.halfHeight > 0.0, what + " extent");
        faults.check(std::isfinite(box.halfWidth) && std::isfinite(box.halfHeight),
                     what + " extent");
    }
}

void checkLight(const glm::vec3& color, double intensity, const std::string& what, Faults& faults) {
    faults.checkFinite(color, what + " color");
    // What the renderer multiplies in single precision.
    faults.check(intensity >= 0.0 && std::isfinite(float(intensity * 1e6)), what + " intensity");
}

void checkLamps(const Scene& scene, Faults& faults) {
    for (const SpotLight& lamp : scene.spotLights) {
        const std::string what = "spot " + lamp.name;
        faults.checkIndex(lamp.node, scene.nodes.size(), what + " node");
        checkFrame(lamp.frame, what, faults);
        checkLight(lamp.color, lamp.intensityCandela, what, faults);
        faults.check(lamp.rangeMetres > 0.0, what + " range");
        faults.check(lamp.outerConeAngle >= kMinConeAngle && lamp.outerConeAngle <= kMaxConeAngle,
                     what + " outer angle");
        faults.check(lamp.innerConeAngle >= 0.0 && lamp.innerConeAngle <= lamp.outerConeAngle,
                     what + " inner angle");
        if (lamp.lightMap) {
            faults.check(
                lamp.lightMap->image >= 0 && lamp.lightMap->image < int(scene.images.size()),
                what + " light map");
            faults.check(std::isfinite(lamp.lightMap->rotationRadians), what + " rotation");
        }
    }
    for (const PointLight& lamp : scene.pointLights) {
        const std::string what = "point " + lamp.name;
        faults.checkIndex(lamp.node, scene.nodes.size(), what + " node");
        faults.checkFinite(lamp.position, what + " position");
        checkLight(lamp.color, lamp.intensityCandela, what, faults);
        faults.check(lamp.rangeMetres > 0.0, what + " range");
    }
    for (const DirectionalLight& lamp : scene.directionalLights) {
        const std::string what = "directional " + lamp.name;
        faults.checkIndex(lamp.node, scene.nodes.size(), what + " node");
        faults.check(std::abs(glm::length(lamp.direction) - 1.0) < 1e-6, what + " direction");
        checkLight(lamp.color, lamp.illuminanceLux, what, faults);
    }
}

void checkSampler(const AnimationSampler& sampler, const std::string& what, Faults& faults) {
    const bool cubic = sampler.interpolation == AnimationSampler::Interpolation::kCubicSpline;
    faults.check(!sampler.seconds.empty(), what + " has no keys");
    const std::size_t rows = (cubic ? 3 : 1) * sampler.seconds.size();
    faults.check(sampler.targets > 0
                     ? sampler.weights.size() == rows * sampler.targets && sampler.values.empty()
                     : sampler.values.size() == rows && sampler.weights.empty(),
                 what + " has the wrong number of values");
    for (const float weight : sampler.weights) {
        faults.check(std::isfinite(weight), what + " weight is not finite");
    }
    for (std::size_t i = 0; i < sampler.seconds.size(); ++i) {
        faults.check(std::isfinite(sampler.seconds[i]), what + " time is not finite");
        faults.check(i == 0 || sampler.seconds[i] > sampler.seconds[i - 1],
                     what + " times do not increase");
    }
    for (const glm::vec4& value : sampler.values) {
        faults.checkFinite(value, what + " value");
    }
}

void checkDial(const Scene& scene, const Dial& dial, Faults& faults) {
    const std::size_t count = dial.list == Dial::List::kNodes         ? scene.nodes.size()
                              : dial.list == Dial::List::kSpotLights  ? scene.spotLights.size()
                              : dial.list == Dial::List::kPointLights ? scene.pointLights.size()
                              : dial.list == Dial::List::kDirectionalLights
                                  ? scene.directionalLights.size()
                              : dial.list == Dial::List::kCameras ? scene.cameras.size()
                                                                  : scene.materials.size();
    faults.check(!dial.owners.empty(), "dial is nobody's");
    for (const int owner : dial.owners) {
        faults.check(owner >= 0 && owner < int(count), "dial's owner is out of range");
    }
    faults.check(dial.rest == dial.now, "dial does not rest");
}

void checkAnimations(const Scene& scene, Faults& faults) {
    for (const Mover& mover : scene.movers) {
        if (mover.node < 0 || mover.node >= int(scene.nodes.size())) {
            faults.check(false, "mover's node is out of range");
            continue;
        }
        faults.check(
            mover.rest.parentFromLocal() == scene.nodes[std::size_t(mover.node)].parentFromLocal,
            "mover's rest is not its node's");
    }
    for (const Dial& dial : scene.dials) {
        checkDial(scene, dial, faults);
    }
    for (std::size_t a = 0; a < scene.animations.size(); ++a) {
        const std::string what = "animation " + std::to_string(a);
        const Animation& animation = scene.animations[a];
        for (const AnimationSampler& sampler : animation.samplers) {
            checkSampler(sampler, what, faults);
        }
        for (const AnimationChannel& channel : animation.channels) {
            const std::size_t movers =
                channel.part == AnimationChannel::Part::kWeights ? scene.deformers.size()
                : channel.part == AnimationChannel::Part::kDial  ? scene.dials.size()
                                                                 : scene.movers.size();
            faults.check(channel.mover >= 0 && channel.mover < int(movers), what + " mover");
            faults.check(
                channel.first >= 0 && channel.count >= 0 && channel.first + channel.count <= 4,
                what + " numbers of a dial");
            faults.check((channel.part == AnimationChannel::Part::kDial) == (channel.count > 0),
                         what + " numbers of what is no dial");
            faults.check(channel.sampler >= 0 && channel.sampler < int(animation.samplers.size()),
                         what + " sampler");
        }
    }
}

void checkDeformation(const Primitive& primitive, const std::string& what, Faults& faults) {
    const std::size_t count = primitive.positions.size();
    const auto each = std::size_t(primitive.influencesPerVertex);
    faults.check(primitive.influences.size() == count * each, what + " influences' number");
    for (std::size_t v = 0; each > 0 && v < count; ++v) {
        double sum = 0.0;
        for (std::size_t i = 0; i < each; ++i) {
            const Influence& influence = primitive.influences[v * each + i];
            faults.check(influence.weight >= 0.0F && influence.weight <= 1.0F,
                         what + " influence's weight");
            faults.check(influence.weight == 0.0F || influence.joint < primitive.jointBounds.size(),
                         what + " has no box for a joint");
            sum += double(influence.weight);
        }
        faults.check(std::abs(sum - 1.0) < 1e-5, what + " weights do not add up to 1");
    }
    for (const MorphTarget& target : primitive.targets) {
        checkArray(target.positions, count, what + " target's positions", faults);
        checkArray(target.normals, primitive.normals.empty() ? 0 : count,
                   what + " target's normals", faults);
        checkArray(target.tangents, primitive.tangents.empty() ? 0 : count,
                   what + " target's tangents", faults);
    }
    faults.check(!primitive.flatNormals || (primitive.indices.size() == count && count % 3 == 0),
                 what + " is not flat triangle by triangle");
}

// Each vertex of a deformer's mesh is a finite point in the box that is told for it.
void checkShape(const Scene& scene, const Deformer& deformer, Faults& faults) {
    const Node& node = scene.nodes[std::size_t(deformer.node)];
    for (const Primitive& primitive : scene.meshes[std::size_t(node.mesh)].primitives) {
        const DeformedVertices vertices = deformVertices(primitive, deformer);
        const Bounds box = localBounds(scene, node, primitive);
        // Single precision is no longer relative to the smallest numbers.
        const double slack = 1e-5 * (glm::length(box.low) + glm::length(box.high)) +
                             double(std::numeric_limits<float>::min());
        for (const glm::vec3& position : vertices.positions) {
            faults.checkFinite(position, "deformed position");
            const glm::dvec3 p(position);
            faults.check(glm::all(glm::greaterThanEqual(p, box.low - slack)) &&
                             glm::all(glm::lessThanEqual(p, box.high + slack)),
                         "deformed position outside its box");
        }
        for (const glm::vec3& normal : vertices.normals) {
            faults.check(std::abs(glm::length(normal) - 1.0F) < 1e-3F, "deformed normal");
        }
    }
}

void checkDeformers(const Scene& scene, Faults& faults) {
    for (const Skin& skin : scene.skins) {
        faults.check(!skin.joints.empty(), "skin without joints");
        faults.check(skin.joints.size() == skin.jointFromMesh.size(), "skin's matrices");
        for (const int joint : skin.joints) {
            faults.check(joint >= 0 && joint < int(scene.nodes.size()), "joint is out of range");
        }
    }
    for (std::size_t i = 0; i < scene.deformers.size(); ++i) {
        const Deformer& deformer = scene.deformers[i];
        faults.checkIndex(deformer.skin, scene.skins.size(), "deformer's skin");
        if (deformer.node < 0 || deformer.node >= int(scene.nodes.size()) ||
            scene.nodes[std::size_t(deformer.node)].deformer != int(i) ||
            scene.nodes[std::size_t(deformer.node)].mesh < 0) {
            faults.check(false, "deformer and node do not name each other");
            continue;
        }
        faults.check(deformer.weights.size() == deformer.restWeights.size(), "weights' number");
        for (const float weight : deformer.restWeights) {
            faults.check(std::isfinite(weight), "weight is not finite");
        }
    }
    for (const Node& node : scene.nodes) {
        faults.checkIndex(node.deformer, scene.deformers.size(), "node's deformer");
    }
}

// Whatever the time, what is placed is finite.
void checkPoses(Scene scene, Faults& faults) {
    for (const Deformer& deformer : scene.deformers) {
        checkShape(scene, deformer, faults);
    }
    if (scene.animations.empty()) {
        return;
    }
    for (const double share : {0.0, 0.3, 0.99, 2.0}) {
        poseScene(scene, share * durationSeconds(scene));
        for (const Node& node : scene.nodes) {
            checkMatrix(node.worldFromLocal, "posed worldFromLocal", faults);
        }
        for (const Deformer& deformer : scene.deformers) {
            checkShape(scene, deformer, faults);
        }
        checkLamps(scene, faults);
        for (const Camera& camera : scene.cameras) {
            checkCamera(camera, scene.nodes.size(), faults);
        }
        for (const Material& material : scene.materials) {
            checkMaterial(material, scene.textures.size(), "posed material", faults);
        }
    }
}

}  // namespace

std::vector<std::string> sceneFaults(const Scene& scene) {
    Faults faults;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        const std::string what = "node " + std::to_string(i);
        faults.check(node.parent >= -1 && node.parent < int(i), what + " stands before its parent");
        faults.checkIndex(node.mesh, scene.meshes.size(), what + " mesh");
        checkMatrix(node.parentFromLocal, what + " parentFromLocal", faults);
        checkMatrix(node.worldFromLocal, what + " worldFromLocal", faults);
    }
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        for (std::size_t p = 0; p < scene.meshes[m].primitives.size(); ++p) {
            checkPrimitive(scene.meshes[m].primitives[p], scene.materials.size(),
                           "primitive " + std::to_string(m) + "/" + std::to_string(p), faults);
            checkDeformation(scene.meshes[m].primitives[p],
                             "primitive " + std::to_string(m) + "/" + std::to_string(p), faults);
        }
    }
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        checkMaterial(scene.materials[i], scene.textures.size(), "material " + std::to_string(i),
                      faults);
    }
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        faults.checkIndex(scene.textures[i].image, scene.images.size(),
                          "texture " + std::to_string(i) + " image");
    }
    for (const Image& image : scene.images) {
        checkImage(image, "image " + image.name, faults);
    }
    for (const Camera& camera : scene.cameras) {
        checkCamera(camera, scene.nodes.size(), faults);
    }
    if (scene.environment) {
        for (const glm::dmat4& form : scene.environment->lux) {
            checkMatrix(form, "environment", faults);
        }
    }
    checkLamps(scene, faults);
    checkDeformers(scene, faults);
    checkAnimations(scene, faults);
    if (!faults.any()) {
        checkPoses(scene, faults);
    }
    return faults.take();
}

}  // namespace ribalta::test
