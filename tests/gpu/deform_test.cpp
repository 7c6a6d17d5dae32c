// Deformed meshes as they are drawn: the compute pass against the CPU's function, and what is done
// again when a shape changes, and what is not.
#include "render/passes/deform.h"

#include <random>

#include <shared/deform.h>

#include "gl/counters.h"
#include "gpu_test.h"
#include "reference/reference_picture.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

using Random = std::mt19937;

float number(Random& random, float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
}

glm::vec3 vector(Random& random, float size) {
    return {number(random, -size, size), number(random, -size, size), number(random, -size, size)};
}

// A primitive whose vertices hang on `joints` joints by `each` influences and have `targets`.
Primitive randomPrimitive(Random& random, std::size_t vertices, std::uint32_t joints, int each,
                          int targets) {
    Primitive primitive;
    for (std::uint32_t v = 0; v < vertices; ++v) {
        primitive.positions.push_back(vector(random, 2.0F));
        primitive.normals.push_back(glm::normalize(vector(random, 1.0F) + 0.01F));
        const glm::vec3 tangent = glm::normalize(vector(random, 1.0F) + 0.01F);
        primitive.tangents.emplace_back(tangent, v % 2 == 0 ? 1.0F : -1.0F);
        primitive.indices.push_back(v);
        float left = 1.0F;
        for (int i = 0; i < each; ++i) {
            const float weight = i + 1 == each ? left : number(random, 0.0F, left);
            primitive.influences.push_back({std::uint32_t(random() % joints), weight});
            left -= weight;
        }
    }
    primitive.influencesPerVertex = each;
    for (int t = 0; t < targets; ++t) {
        MorphTarget& target = primitive.targets.emplace_back();
        for (std::size_t v = 0; v < vertices; ++v) {
            target.positions.push_back(vector(random, 0.5F));
            target.normals.push_back(vector(random, 0.5F));
            target.tangents.push_back(vector(random, 0.5F));
        }
        if (t == 1) {
            target.normals.clear();
        }
    }
    return primitive;
}

// Joints that are turned, stretched and, the last, mirrored.
void addJoints(Random& random, std::size_t count, Scene& scene) {
    Skin skin;
    for (std::size_t j = 0; j < count; ++j) {
        Pose pose;
        pose.translation = glm::dvec3(vector(random, 3.0F));
        pose.rotation = glm::normalize(glm::dquat(number(random, -1, 1), number(random, -1, 1),
                                                  number(random, -1, 1), number(random, 0.1F, 1)));
        pose.scale = glm::dvec3(0.5, 1.0 + double(j), j + 1 == count ? -2.0 : 2.0);
        Node& node = scene.nodes.emplace_back();
        node.parentFromLocal = pose.parentFromLocal();
        skin.joints.push_back(int(j));
        skin.jointFromMesh.emplace_back(1.0);
    }
    scene.skins.push_back(skin);
}

void addDeformed(Scene& scene, Primitive primitive, int skin, std::vector<float> weights) {
    primitive.bounds = {};
    for (const glm::vec3& position : primitive.positions) {
        primitive.bounds.add(glm::dvec3(position));
    }
    for (MorphTarget& target : primitive.targets) {
        for (const glm::vec3& displacement : target.positions) {
            target.bounds.add(glm::dvec3(displacement));
        }
    }
    for (std::size_t i = 0; i < primitive.influences.size(); ++i) {
        const std::size_t joint = primitive.influences[i].joint;
        primitive.jointBounds.resize(std::max(primitive.jointBounds.size(), joint + 1));
        primitive.jointBounds[joint].add(
            glm::dvec3(primitive.positions[i / std::size_t(primitive.influencesPerVertex)]));
    }
    Node& node = scene.nodes.emplace_back();
    node.mesh = int(scene.meshes.size());
    node.deformer = int(scene.deformers.size());
    scene.meshes.push_back({"", {std::move(primitive)}});
    Deformer deformer;
    deformer.node = int(scene.nodes.size()) - 1;
    deformer.skin = skin;
    deformer.restWeights = weights;
    deformer.weights = std::move(weights);
    scene.deformers.push_back(std::move(deformer));
}

class Deform : public GpuTest {};

// The vertices of a deformer's only primitive, as they lie in the buffers that are drawn.
DeformedVertices readVertices(const GpuScene& gpuScene, const Deformer& deformer,
                              std::size_t count) {
    std::vector<float> positions(gpuScene.geometry().positions().size() / sizeof(float));
    std::vector<float> attributes(gpuScene.geometry().attributes().size() / sizeof(float));
    gpuScene.geometry().positions().read(std::as_writable_bytes(std::span(positions)));
    gpuScene.geometry().attributes().read(std::as_writable_bytes(std::span(attributes)));
    const auto first =
        std::size_t(gpuScene.geometry().deformedParts(deformer.node).at(0).baseVertex);
    DeformedVertices result;
    for (std::size_t v = first; v < first + count; ++v) {
        const float* p = &positions[3 * v];
        const float* a = &attributes[gpu::kAttributeFloats * v];
        result.positions.emplace_back(p[0], p[1], p[2]);
        result.normals.emplace_back(a[0], a[1], a[2]);
        result.tangents.emplace_back(a[3], a[4], a[5], a[6]);
    }
    return result;
}

void expectSame(const DeformedVertices& found, const DeformedVertices& expected) {
    ASSERT_EQ(found.positions.size(), expected.positions.size());
    for (std::size_t v = 0; v < found.positions.size(); ++v) {
        EXPECT_LT(glm::length(found.positions[v] - expected.positions[v]), 2e-5F) << v;
        EXPECT_LT(glm::length(found.normals[v] - expected.normals[v]), 2e-4F) << v;
        EXPECT_LT(glm::length(found.tangents[v] - expected.tangents[v]), 2e-4F) << v;
    }
}

TEST_F(Deform, AsTheProcessorDoes) {
    Random random(7);
    Scene scene;
    addJoints(random, 5, scene);
    addDeformed(scene, randomPrimitive(random, 700, 5, 6, 3), 0, {0.5F, -1.25F, 0.0F});
    addDeformed(scene, randomPrimitive(random, 1, 5, 1, 0), 0, {});
    addDeformed(scene, randomPrimitive(random, 129, 5, 2, 4), -1, {1.0F, 0.25F, 0.0F, 2.0F});
    Primitive flat = randomPrimitive(random, 300, 5, 3, 1);
    flat.flatNormals = true;
    addDeformed(scene, std::move(flat), 0, {0.75F});
    placeNodes(scene);
    const GpuScene gpuScene(scene);
    DeformPass pass;
    pass.draw({0, 1, 2, 3}, scene, gpuScene);
    for (const Deformer& deformer : scene.deformers) {
        const Primitive& primitive =
            scene.meshes[std::size_t(scene.nodes[std::size_t(deformer.node)].mesh)].primitives[0];
        expectSame(readVertices(gpuScene, deformer, primitive.positions.size()),
                   deformVertices(primitive, deformer));
    }
}

// A floor, and over it a panel in a spot's beam that a joint moves; the spot's shadow of it falls
// on the floor.
class DeformedStage : public GpuTest {
  protected:
    DeformedStage() {
        Random random(1);
        addJoints(random, 1, scene_);
        turn(0.0);
        addShape(scene_, makeQuad({0, 0, 0}, {5, 0, 0}, {0, 0, -5}), makeMaterial(glm::vec3(0.5F)));
        Primitive panel = makeQuad({0, 1, 0}, {1, 0, 0}, {0, 0, -1});
        panel.influencesPerVertex = 1;
        panel.influences.assign(panel.positions.size(), {0, 1.0F});
        addDeformed(scene_, std::move(panel), 0, {});
        scene_.spotLights.push_back(makeSpot({0, 6, 0}, {0, 0, 0}, 0.6));
        settings_.haze.scatteringPerMetre = 0.0;
        placeNodes(scene_);
    }

    void turn(double metresAside) {
        scene_.nodes[0].parentFromLocal = glm::dmat4(1.0);
        scene_.nodes[0].parentFromLocal[3].x = metresAside;
        placeNodes(scene_);
    }

    Scene scene_;
    Camera camera_ = makeCamera({0, 6, 0.5}, {0, 0, 0});
    FrameSettings settings_ = measuringSettings();
};

TEST_F(DeformedStage, IsDrawnAsTheSameMeshAtItsPlace) {
    turn(1.5);
    const Frame3 skinned = drawOnce(scene_, camera_, settings_);
    Scene rigid = scene_;
    rigid.deformers.clear();
    Node& node = rigid.nodes.back();
    node.deformer = -1;
    node.parentFromLocal = rigid.nodes[0].parentFromLocal;
    placeNodes(rigid);
    const Frame3 moved = drawOnce(rigid, camera_, settings_);
    double most = 0.0;
    for (int y = 0; y < settings_.height; ++y) {
        for (int x = 0; x < settings_.width; ++x) {
            const glm::dvec3 a = skinned.color(x, y);
            const glm::dvec3 b = moved.color(x, y);
            EXPECT_NEAR(a.x, b.x, 1e-3 * (1.0 + b.x)) << x << ' ' << y;
            most = std::max(most, b.x);
        }
    }
    EXPECT_GT(most, 0.1);
}

// A sphere that two joints and a morph target bend: the renderer deforms it on the GPU, the
// reference on the processor, and each shades it by its own code.
TEST_F(Deform, LooksAsTheReferenceSeesIt) {
    Random random(3);
    Scene scene;
    addJoints(random, 2, scene);
    Primitive sphere = makeSphere({0, 0, 0}, 1.0F, 24);
    sphere.influencesPerVertex = 2;
    MorphTarget& target = sphere.targets.emplace_back();
    for (std::size_t v = 0; v < sphere.positions.size(); ++v) {
        const float upper = 0.5F + 0.5F * sphere.positions[v].y;
        sphere.influences.push_back({0, 1.0F - upper});
        sphere.influences.push_back({1, upper});
        target.positions.push_back(0.4F * sphere.normals[v]);
        target.normals.push_back(vector(random, 0.1F));
    }
    addDeformed(scene, std::move(sphere), 0, {0.75F});
    for (int joint = 0; joint < 2; ++joint) {
        Pose pose;
        pose.translation = {0.6 * joint - 0.3, 0.0, 0.0};
        pose.rotation = glm::angleAxis(0.5 * joint, glm::dvec3(0.6, 0.0, 0.8));
        pose.scale = glm::dvec3(1.0, 1.0 + 0.5 * joint, 1.0);
        scene.nodes[std::size_t(joint)].parentFromLocal = pose.parentFromLocal();
    }
    placeNodes(scene);
    scene.materials.push_back(makeMaterial({0.8F, 0.4F, 0.1F}, 0.0F, 0.5F));
    scene.meshes[0].primitives[0].material = 0;
    DirectionalLight light;
    light.direction = glm::normalize(glm::dvec3(-0.3, -1.0, -0.6));
    light.illuminanceLux = 30.0;
    scene.directionalLights.push_back(light);

    const Camera camera = makeCamera({0.0, 1.5, 4.5}, {0.0, 0.3, 0.0});
    const FrameSettings settings = measuringSettings(96, 72);
    const Frame3 frame = drawOnce(scene, camera, settings);
    ReferenceSettings reference;
    reference.camera = camera;
    reference.width = settings.width;
    reference.height = settings.height;
    reference.haze = settings.haze;
    reference.ambientLux = settings.ambientLux;
    const ReferencePicture truth = drawReference(scene, reference);
    int seen = 0;
    int others = 0;
    for (int y = 0; y < settings.height; ++y) {
        for (int x = 0; x < settings.width; ++x) {
            const auto pixel = std::size_t(y) * std::size_t(settings.width) + std::size_t(x);
            const glm::dvec3 expected = truth.surfaces[pixel];
            seen += std::isfinite(truth.depths[pixel]) ? 1 : 0;
            others +=
                glm::length(frame.color(x, y) - expected) > 0.005 * glm::length(expected) + 1e-4
                    ? 1
                    : 0;
        }
    }
    EXPECT_GT(seen, 1000);
    // Silhouettes, the fold's own included, may fall to either side of a pixel's middle.
    EXPECT_LT(others, seen / 200);
}

TEST_F(DeformedStage, ShapesAreMadeWhenTheyChangeAlone) {
    Renderer renderer(scene_);
    EXPECT_EQ(renderer.draw(camera_, settings_).describe(), "deform[1] shadow_map[1] forward");
    EXPECT_EQ(renderer.lastPlan().verticesDeformed, 4);
    EXPECT_EQ(renderer.draw(camera_, settings_).describe(), "kept");
    EXPECT_EQ(renderer.lastPlan().deformersKept, 1);
    // Another view of the same shape: neither it nor its shadow is made anew.
    camera_ = makeCamera({1, 6, 0.5}, {0, 0, 0});
    EXPECT_EQ(renderer.draw(camera_, settings_).describe(), "forward");
    turn(0.5);
    EXPECT_EQ(renderer.draw(camera_, settings_).describe(), "shadow_map[1] forward");
    // The node moves with its first joint, the shape in it is the same; turned it is another.
    scene_.nodes[0].parentFromLocal[0] = glm::dvec4(0, 1, 0, 0);
    scene_.nodes[0].parentFromLocal[1] = glm::dvec4(-1, 0, 0, 0);
    placeNodes(scene_);
    EXPECT_EQ(renderer.draw(camera_, settings_).describe(), "deform[1] shadow_map[1] forward");
}

TEST_F(DeformedStage, ShadowsFollow) {
    Renderer renderer(scene_);
    settings_.width = 65;
    settings_.height = 65;
    camera_ = makeCamera({4.5, 0.5, 0}, {2.2, 0, 0});
    renderer.draw(camera_, settings_);
    // A point of the floor that the panel's shadow reaches when it has moved aside.
    const double lit = readBack(renderer).color(32, 32).x;
    EXPECT_GT(lit, 1.0);
    turn(1.8);
    renderer.draw(camera_, settings_);
    EXPECT_LT(readBack(renderer).color(32, 32).x, 0.01 * lit);
}

TEST_F(DeformedStage, NothingIsMadeWithoutDeformers) {
    scene_.deformers.clear();
    scene_.nodes.back().deformer = -1;
    Renderer renderer(scene_);
    const std::uint64_t before = glCounters().programsBuilt;
    EXPECT_EQ(renderer.draw(camera_, settings_).describe(), "shadow_map[1] forward");
    EXPECT_EQ(glCounters().programsBuilt - before, 2U);
}

TEST_F(DeformedStage, WhatIsOutOfSightWaits) {
    scene_.spotLights.clear();
    camera_ = makeCamera({0, 6, 0.5}, {0, 12, 0.5});
    Renderer renderer(scene_);
    EXPECT_EQ(renderer.draw(camera_, settings_).describe(), "nothing");
    camera_ = makeCamera({0, 6, 0.5}, {0, 0, 0});
    EXPECT_EQ(renderer.draw(camera_, settings_).describe(), "deform[1] forward");
}

}  // namespace
}  // namespace ribalta::test
