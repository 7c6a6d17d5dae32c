// Deformation: closed forms of one and two joints, of targets, and of what normals do.
#include "scene/deformer.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "scene/scene.h"
#include "support/expect_near.h"

namespace ribalta {
namespace {

// A mesh of listed vertices that hangs on the nodes before it.
struct Puppet {
    explicit Puppet(const std::vector<glm::vec3>& positions, int joints = 1) {
        scene.meshes.resize(1);
        Primitive& primitive = scene.meshes[0].primitives.emplace_back();
        primitive.positions = positions;
        for (std::uint32_t i = 0; i < positions.size(); ++i) {
            primitive.indices.push_back(i);
            primitive.bounds.add(glm::dvec3(positions[i]));
        }
        Skin skin;
        for (int j = 0; j < joints; ++j) {
            scene.nodes.emplace_back();
            skin.joints.push_back(j);
            skin.jointFromMesh.emplace_back(1.0);
        }
        scene.skins.push_back(skin);
        Node node;
        node.mesh = 0;
        node.deformer = 0;
        scene.nodes.push_back(node);
        Deformer deformer;
        deformer.node = joints;
        deformer.skin = 0;
        scene.deformers.push_back(deformer);
    }

    Primitive& primitive() { return scene.meshes[0].primitives[0]; }
    glm::dmat4& joint(int j) { return scene.nodes[std::size_t(j)].parentFromLocal; }

    // All vertices hang on the joints alike.
    void hang(const std::vector<Influence>& influences) {
        Primitive& mesh = primitive();
        mesh.influencesPerVertex = int(influences.size());
        for (const glm::vec3& position : mesh.positions) {
            for (const Influence& influence : influences) {
                mesh.influences.push_back(influence);
                mesh.jointBounds.resize(
                    std::max(mesh.jointBounds.size(), std::size_t(influence.joint) + 1));
                mesh.jointBounds[influence.joint].add(glm::dvec3(position));
            }
        }
    }

    void morph(const std::vector<glm::vec3>& displacements, float weight) {
        MorphTarget target;
        target.positions = displacements;
        for (const glm::vec3& displacement : displacements) {
            target.bounds.add(glm::dvec3(displacement));
        }
        primitive().targets.push_back(target);
        scene.deformers[0].restWeights.push_back(weight);
        scene.deformers[0].weights.push_back(weight);
    }

    DeformedVertices deformed() {
        placeNodes(scene);
        return deformVertices(primitive(), scene.deformers[0]);
    }

    glm::dmat4 worldFromLocal() const { return scene.nodes.back().worldFromLocal; }
    glm::dvec3 inWorld(const glm::vec3& local) const {
        return glm::dvec3(worldFromLocal() * glm::dvec4(glm::dvec3(local), 1.0));
    }

    Scene scene;
};

glm::dmat4 turnedAboutZ(double degrees) {
    Pose pose;
    const double half = 0.5 * degrees * std::numbers::pi / 180.0;
    pose.rotation = {std::cos(half), 0.0, 0.0, std::sin(half)};
    return pose.parentFromLocal();
}

glm::dmat4 movedBy(const glm::dvec3& offset) {
    glm::dmat4 matrix(1.0);
    matrix[3] = glm::dvec4(offset, 1.0);
    return matrix;
}

glm::dmat4 scaledBy(const glm::dvec3& scale) {
    Pose pose;
    pose.scale = scale;
    return pose.parentFromLocal();
}

// Vertices are in single precision.
void expectNearly(const glm::dvec3& found, const glm::dvec3& expected, double tolerance = 2e-6) {
    test::expectNear(found, expected, tolerance);
}

TEST(DeformerTest, OneBoneTurnedByAQuarter) {
    Puppet puppet({{0, 1, 0}, {2, 0, 3}});
    puppet.primitive().normals = {{0, 1, 0}, {1, 0, 0}};
    puppet.primitive().tangents = {{1, 0, 0, 1}, {0, 0, 1, -1}};
    puppet.hang({{0, 1.0F}});
    puppet.joint(0) = turnedAboutZ(90);
    const DeformedVertices vertices = puppet.deformed();
    expectNearly(puppet.inWorld(vertices.positions[0]), {-1, 0, 0});
    expectNearly(puppet.inWorld(vertices.positions[1]), {0, 2, 3});
    expectNearly(glm::dvec3(vertices.normals[0]), {-1, 0, 0});
    expectNearly(glm::dvec3(vertices.normals[1]), {0, 1, 0});
    expectNearly(glm::dvec3(vertices.tangents[0]), {0, 1, 0});
    EXPECT_EQ(vertices.tangents[1].w, -1.0F);
}

TEST(DeformerTest, TwoBonesHalfAndHalf) {
    Puppet puppet({{1, 0, 0}}, 2);
    puppet.hang({{0, 0.5F}, {1, 0.5F}});
    puppet.joint(0) = movedBy({0, 4, 0});
    puppet.joint(1) = turnedAboutZ(90) * movedBy({0, 0, 2});
    // Half way between (1, 4, 0) and (0, 1, 2).
    expectNearly(puppet.inWorld(puppet.deformed().positions[0]), {0.5, 2.5, 1.0});
}

TEST(DeformerTest, BindPoseIsTheMeshItself) {
    Puppet puppet({{1, 2, 3}, {-4, 5, 0.5F}}, 2);
    puppet.primitive().normals = {{0, 0, 1}, {0.6F, 0, 0.8F}};
    puppet.hang({{0, 0.3F}, {1, 0.7F}});
    puppet.joint(0) = movedBy({3, 1, 0}) * turnedAboutZ(40) * scaledBy({1, 3, 0.5});
    puppet.joint(1) = turnedAboutZ(-70) * movedBy({0, -8, 2});
    placeNodes(puppet.scene);
    for (std::size_t j = 0; j < 2; ++j) {
        puppet.scene.skins[0].jointFromMesh[j] = glm::inverse(puppet.scene.nodes[j].worldFromLocal);
    }
    const DeformedVertices vertices = puppet.deformed();
    for (std::size_t v = 0; v < 2; ++v) {
        expectNearly(puppet.inWorld(vertices.positions[v]),
                     glm::dvec3(puppet.primitive().positions[v]), 1e-5);
        expectNearly(glm::dvec3(vertices.normals[v]), glm::dvec3(puppet.primitive().normals[v]),
                     1e-5);
    }
}

TEST(DeformerTest, TargetsAddUp) {
    Puppet puppet({{1, 1, 1}});
    puppet.scene.deformers[0].skin = -1;
    puppet.morph({{2, 0, 0}}, 0.25F);
    puppet.morph({{0, -4, 8}}, 1.5F);
    puppet.morph({{100, 100, 100}}, 0.0F);
    expectNearly(glm::dvec3(puppet.deformed().positions[0]), {1.5, -5, 13});
}

TEST(DeformerTest, MorphedThenSkinned) {
    Puppet puppet({{1, 0, 0}});
    puppet.hang({{0, 1.0F}});
    puppet.morph({{1, 0, 0}}, 1.0F);
    puppet.joint(0) = turnedAboutZ(90);
    expectNearly(puppet.inWorld(puppet.deformed().positions[0]), {0, 2, 0});
}

// A slope of 45 degrees, stretched twice as high, is steeper; its normal leans the other way.
TEST(DeformerTest, NormalsStandOnStretchedSurfaces) {
    Puppet puppet({{0, 0, 0}});
    const float half = std::sqrt(0.5F);
    puppet.primitive().normals = {{half, half, 0}};
    puppet.primitive().tangents = {{half, -half, 0, 1}};
    puppet.hang({{0, 1.0F}});
    puppet.joint(0) = scaledBy({1, 2, 1});
    const DeformedVertices vertices = puppet.deformed();
    expectNearly(glm::dvec3(vertices.normals[0]), glm::dvec3(2, 1, 0) / std::sqrt(5.0));
    const glm::vec4& t = vertices.tangents[0];
    expectNearly(glm::dvec3(t.x, t.y, t.z), glm::dvec3(1, -2, 0) / std::sqrt(5.0));
    // However small or large.
    for (const double size : {1e-18, 1e-7, 1e8}) {
        puppet.joint(0) = scaledBy(size * glm::dvec3(1, 2, 1));
        expectNearly(glm::dvec3(puppet.deformed().normals[0]),
                     glm::dvec3(2, 1, 0) / std::sqrt(5.0));
    }
    // Of a flattened bone, the direction in which it has no thickness is left.
    puppet.joint(0) = scaledBy({1, 1, 0});
    puppet.primitive().normals = {{0.6F, 0, 0.8F}};
    expectNearly(glm::dvec3(puppet.deformed().normals[0]), {0, 0, 1});
}

// A skeleton in a mirror turns front faces to the back, which the node's matrix says.
TEST(DeformerTest, MirroredSkeletonsAreMirroredByTheirNode) {
    Puppet puppet({{1, 2, 3}});
    puppet.primitive().normals = {{0, 0, 1}};
    puppet.hang({{0, 1.0F}});
    puppet.joint(0) = movedBy({5, 0, 0}) * scaledBy({1, 1, -1});
    const DeformedVertices vertices = puppet.deformed();
    EXPECT_LT(glm::determinant(glm::dmat3(puppet.worldFromLocal())), 0.0);
    expectNearly(puppet.inWorld(vertices.positions[0]), {6, 2, -3});
    const glm::dmat3 normals = glm::transpose(glm::inverse(glm::dmat3(puppet.worldFromLocal())));
    expectNearly(normals * glm::dvec3(vertices.normals[0]), {0, 0, -1});
}

TEST(DeformerTest, FarFromTheOriginNothingIsLost) {
    Puppet puppet({{0.001F, 0, 0}});
    puppet.hang({{0, 1.0F}});
    puppet.joint(0) = movedBy({1e6, 0, 0});
    expectNearly(puppet.inWorld(puppet.deformed().positions[0]), {1e6 + 0.001, 0, 0}, 1e-9);
}

TEST(DeformerTest, FlatNormalsFollowTheirTriangles) {
    Puppet puppet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    puppet.scene.deformers[0].skin = -1;
    puppet.primitive().flatNormals = true;
    puppet.primitive().normals.assign(3, {0, 0, 1});
    puppet.morph({{0, 0, 0}, {0, 0, 0}, {0, 0, 1}}, 1.0F);
    for (const glm::vec3& normal : puppet.deformed().normals) {
        expectNearly(glm::dvec3(normal), glm::dvec3(0, -1, 1) / std::sqrt(2.0));
    }
}

TEST(DeformerTest, ShapesAreToldApart) {
    Puppet puppet({{1, 0, 0}});
    puppet.hang({{0, 1.0F}});
    puppet.morph({{1, 0, 0}}, 0.0F);
    puppet.deformed();
    const std::uint64_t first = puppet.scene.deformers[0].shape;
    puppet.deformed();
    EXPECT_EQ(puppet.scene.deformers[0].shape, first);
    puppet.joint(0) = turnedAboutZ(1);
    puppet.deformed();
    EXPECT_NE(puppet.scene.deformers[0].shape, first);
    puppet.joint(0) = glm::dmat4(1.0);
    puppet.deformed();
    EXPECT_EQ(puppet.scene.deformers[0].shape, first);
    puppet.scene.deformers[0].weights[0] = 0.5F;
    puppet.deformed();
    EXPECT_NE(puppet.scene.deformers[0].shape, first);
}

TEST(DeformerTest, BoundsHoldWhatIsThere) {
    Puppet puppet({{1, 0, 0}, {0, 2, 0}, {-1, 0, 5}}, 2);
    puppet.hang({{0, 0.25F}, {1, 0.75F}});
    puppet.morph({{0, 0, 3}, {0, -3, 0}, {1, 1, 1}}, -0.5F);
    puppet.joint(0) = movedBy({7, 0, 0}) * turnedAboutZ(30);
    puppet.joint(1) = scaledBy({2, 2, 2});
    const DeformedVertices vertices = puppet.deformed();
    const Bounds box = localBounds(puppet.scene, puppet.scene.nodes.back(), puppet.primitive());
    Bounds tight;
    for (const glm::vec3& position : vertices.positions) {
        const glm::dvec3 p(position);
        EXPECT_TRUE(glm::all(glm::greaterThanEqual(p, box.low - 1e-6)));
        EXPECT_TRUE(glm::all(glm::lessThanEqual(p, box.high + 1e-6)));
        tight.add(puppet.inWorld(position));
    }
    expectNearly(tightSceneBounds(puppet.scene).low, tight.low);
    expectNearly(tightSceneBounds(puppet.scene).high, tight.high);
    EXPECT_TRUE(glm::all(glm::lessThanEqual(sceneBounds(puppet.scene).low, tight.low + 1e-6)));
}

AnimationSampler weightsSampler(AnimationSampler::Interpolation interpolation,
                                std::vector<float> weights) {
    AnimationSampler sampler;
    sampler.interpolation = interpolation;
    sampler.seconds = {0.0F, 2.0F};
    sampler.targets = 2;
    sampler.weights = std::move(weights);
    return sampler;
}

TEST(DeformerTest, WeightsArePlayedAndRest) {
    using Interpolation = AnimationSampler::Interpolation;
    Puppet puppet({{0, 0, 0}});
    puppet.scene.deformers[0].skin = -1;
    puppet.morph({{1, 0, 0}}, 0.125F);
    puppet.morph({{0, 1, 0}}, 0.25F);
    Animation animation;
    animation.samplers = {
        weightsSampler(Interpolation::kLinear, {0, 1, 1, 3}),
        weightsSampler(Interpolation::kStep, {0, 1, 1, 3}),
        // Rows: tangent in, value, tangent out.
        weightsSampler(Interpolation::kCubicSpline, {9, 9, 0, 1, 1, 0, 0, -1, 2, 5, 9, 9})};
    puppet.scene.animations.push_back(animation);
    const auto weightsAt = [&](int sampler, double seconds) {
        puppet.scene.animations[0].channels = {{0, sampler, AnimationChannel::Part::kWeights}};
        poseScene(puppet.scene, seconds);
        return puppet.scene.deformers[0].weights;
    };
    EXPECT_EQ(weightsAt(0, 0.5), (std::vector<float>{0.25F, 1.5F}));
    EXPECT_EQ(weightsAt(0, 9.0), (std::vector<float>{1, 3}));
    EXPECT_EQ(weightsAt(1, 1.9), (std::vector<float>{0, 1}));
    // Half way the values count a half each, the tangents an eighth of the 2 s, either sign.
    EXPECT_EQ(weightsAt(2, 1.0), (std::vector<float>{1.0F + 0.25F * 1, 3.0F + 0.25F * 1}));
    restScene(puppet.scene);
    EXPECT_EQ(puppet.scene.deformers[0].weights, (std::vector<float>{0.125F, 0.25F}));
}

}  // namespace
}  // namespace ribalta
