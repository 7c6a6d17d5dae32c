#include "gltf/read_deformers.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gltf/bad_input.h"
#include "gltf/read_accessor.h"
#include "gltf/tally.h"
#include "gltf/where.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

// Of a glTF mesh: what there is to deform.
struct MeshShape {
    std::size_t vertices = 0;
    std::size_t targets = 0;
    bool hasJoints = false;  ///< some primitive's vertices hang on joints
};

MeshShape readShape(const Import& import, std::size_t mesh) {
    MeshShape shape;
    const json& primitives = element(import.json, "meshes", mesh)["primitives"];
    for (const json& primitive : primitives) {
        const json& attributes = primitive["attributes"];
        shape.targets = std::max(shape.targets, member(primitive, "targets").size());
        shape.hasJoints = shape.hasJoints ||
                          (attributes.contains("JOINTS_0") && attributes.contains("WEIGHTS_0"));
        if (attributes.contains("POSITION")) {
            shape.vertices +=
                import.model.accessors[attributes["POSITION"].get<std::size_t>()].count;
        }
    }
    return shape;
}

bool isUsable(const glm::mat4& matrix) {
    for (int i = 0; i < 16; ++i) {
        if (!(std::abs(double(matrix[i / 4][i % 4])) <= kMaxTransform)) {
            return false;
        }
    }
    return true;
}

class DeformerReader {
  public:
    DeformerReader(const Import& import, NodeList& list, Scene& scene, Report& report)
        : import_(import),
          list_(list),
          scene_(scene),
          report_(report),
          shapes_(import.model.meshes.size()),
          skins_(member(import.json, "skins").size(), kUnread) {}

    void readAll();

  private:
    static constexpr int kUnread = -2;
    static constexpr int kUnusable = -1;

    void readNode(std::size_t node, const FileNode& source);
    const MeshShape& shapeOf(std::size_t mesh);
    int skinOf(std::size_t node, const FileNode& source, const MeshShape& shape);
    int readSkin(std::size_t skin);
    std::vector<glm::dmat4> bindMatricesOf(const json& source, std::size_t joints,
                                           const Place& place);
    std::vector<float> weightsOf(const FileNode& node, const Place& place, std::size_t mesh,
                                 std::size_t targets);

    const Import& import_;
    NodeList& list_;
    Scene& scene_;
    Report& report_;
    std::optional<JointFinder> joints_;             ///< made when the first skin is read
    std::vector<std::optional<MeshShape>> shapes_;  ///< by the glTF's mesh, where one was asked for
    std::vector<int> skins_;  ///< by the glTF's index: into Scene::skins, or one of the above
    std::size_t jointsLeft_ = kMaxPosedJoints;
    std::size_t verticesLeft_ = kMaxDeformedVertices;
    Tally ignored_;
};

void DeformerReader::readAll() {
    for (std::size_t i = 0; i < list_.inScene; ++i) {
        const FileNode& source = import_.nodes[list_.gltfNodes[i]];
        if (list_.nodes[i].mesh >= 0) {
            readNode(i, source);
            continue;
        }
        const Where root(import_.file);
        const Where nodes(root, "nodes");
        const Where here(nodes, list_.gltfNodes[i]);
        for (const char* key : {"skin", "weights"}) {
            if (!source.other(key).is_null()) {
                ignored_.add("has no meaning for a node without a mesh", Where(here, key));
            }
        }
    }
    if (joints_) {
        joints_->finish();
    }
    ignored_.tell(Report::Kind::kIgnored, "", report_);
}

const MeshShape& DeformerReader::shapeOf(std::size_t mesh) {
    std::optional<MeshShape>& shape = shapes_[mesh];
    if (!shape) {
        shape = readShape(import_, mesh);
    }
    return *shape;
}

void DeformerReader::readNode(std::size_t node, const FileNode& source) {
    const auto mesh = std::size_t(list_.nodes[node].mesh);
    const MeshShape& shape = shapeOf(mesh);
    const int skin = skinOf(node, source, shape);
    if (skin < 0 && shape.targets == 0) {
        if (!source.other("weights").is_null()) {
            report_.ignored(import_.file.at("nodes").at(list_.gltfNodes[node]).at("weights"),
                            "has no meaning: the node's mesh has no morph targets");
        }
        return;
    }
    const Place place = import_.file.at("nodes").at(list_.gltfNodes[node]);
    const std::size_t joints = skin < 0 ? 0 : scene_.skins[std::size_t(skin)].joints.size();
    if (joints > jointsLeft_ || shape.vertices > verticesLeft_) {
        report_.ignored(place, "is deformed, with " + counted(joints, "joints") + " and " +
                                   std::to_string(shape.vertices) +
                                   " vertices, which is more than is left of the " +
                                   std::to_string(kMaxPosedJoints) + " joints and " +
                                   std::to_string(kMaxDeformedVertices) +
                                   " vertices that are deformed in all; it is drawn at rest");
        return;
    }
    jointsLeft_ -= joints;
    verticesLeft_ -= shape.vertices;
    Deformer deformer;
    deformer.skin = skin;
    deformer.restWeights = weightsOf(source, place, mesh, shape.targets);
    deformer.weights = deformer.restWeights;
    deformer.node = int(node);
    if (skin >= 0) {
        Node skinned;
        skinned.name = list_.nodes[node].name;
        skinned.mesh = int(mesh);
        skinned.parent = int(node);  // which hides it, but does not place it
        list_.nodes[node].mesh = -1;
        deformer.node = int(list_.nodes.size());
        list_.nodes.push_back(std::move(skinned));
        list_.gltfNodes.push_back(list_.gltfNodes[node]);
    }
    list_.nodes[std::size_t(deformer.node)].deformer = int(scene_.deformers.size());
    scene_.deformers.push_back(std::move(deformer));
}

// Into Scene::skins; -1 where the node has none that can be used.
int DeformerReader::skinOf(std::size_t node, const FileNode& source, const MeshShape& shape) {
    if (source.other("skin").is_null()) {
        return -1;
    }
    if (!shape.hasJoints) {
        const Where root(import_.file);
        const Where nodes(root, "nodes");
        const Where here(nodes, list_.gltfNodes[node]);
        ignored_.add(
            "is a skin for a mesh without JOINTS_0 and WEIGHTS_0, which is drawn unskinned",
            Where(here, "skin"));
        return -1;
    }
    const auto index = source.other("skin").get<std::size_t>();
    int& skin = skins_[index];
    if (skin == kUnread) {
        skin = readSkin(index);
    }
    return skin;
}

int DeformerReader::readSkin(std::size_t index) {
    const json& source = element(import_.json, "skins", index);
    if (source.is_null()) {
        return kUnusable;  // told already
    }
    const Place place = import_.file.at("skins").at(index);
    std::vector<std::size_t> joints;
    for (const json& joint : source["joints"]) {
        joints.push_back(joint.get<std::size_t>());
    }
    Skin skin;
    if (source.contains("name")) {
        skin.name = source["name"].get<std::string>();
    }
    skin.jointFromMesh = bindMatricesOf(source, joints.size(), place);
    const std::size_t before = list_.nodes.size();
    if (!joints_) {
        joints_.emplace(import_, list_, report_);
    }
    for (const std::size_t joint : joints) {
        skin.joints.push_back(joints_->find(joint));
    }
    if (list_.nodes.size() > before) {
        report_.hint(place.at("joints"),
                     "has joints that are not in the scene; they move the mesh "
                     "from where they stand in the file");
    }
    scene_.skins.push_back(std::move(skin));
    return int(scene_.skins.size()) - 1;
}

std::vector<glm::dmat4> DeformerReader::bindMatricesOf(const json& source, std::size_t joints,
                                                       const Place& place) {
    std::vector<glm::dmat4> matrices;
    const json& accessor = member(source, "inverseBindMatrices");
    const Place here = place.at("inverseBindMatrices");
    if (!accessor.is_null()) {
        try {
            std::size_t unusable = 0;
            for (const glm::mat4& matrix : readMat4(import_, accessor.get<std::size_t>())) {
                if (matrices.size() == joints) {
                    break;  // more than joints are allowed
                }
                const bool usable = isUsable(matrix);
                unusable += usable ? 0 : 1;
                glm::dmat4& own =
                    matrices.emplace_back(usable ? glm::dmat4(matrix) : glm::dmat4(1.0));
                own[0][3] = own[1][3] = own[2][3] = 0.0;
                own[3][3] = 1.0;
            }
            if (unusable > 0) {
                report_.repaired(
                    here, "has " + std::to_string(unusable) +
                              " matrices with numbers out of all bounds; the identity is used");
            }
            if (matrices.size() < joints) {
                report_.repaired(here, "has " + std::to_string(matrices.size()) + " matrices for " +
                                           counted(joints, "joints") +
                                           "; the identity is used for the others");
            }
        } catch (const Error& error) {
            report_.repaired(
                error.place(),
                reasonOf(error) + "; the identity is used for all joints of skin " + place.pointer);
            matrices.clear();
        }
    }
    matrices.resize(joints, glm::dmat4(1.0));
    return matrices;
}

// The node's, or else the mesh's, or else 0.
std::vector<float> DeformerReader::weightsOf(const FileNode& node, const Place& place,
                                             std::size_t mesh, std::size_t targets) {
    const bool own = !node.other("weights").is_null();
    const json& given =
        own ? node.other("weights") : member(element(import_.json, "meshes", mesh), "weights");
    std::vector<float> weights;
    for (const json& weight : given) {
        weights.push_back(weight.get<float>());
    }
    if (!given.is_null() && weights.size() != targets) {
        report_.repaired((own ? place : import_.file.at("meshes").at(mesh)).at("weights"),
                         "has " + counted(weights.size(), "weights") + " for " +
                             counted(targets, "morph targets") + "; " +
                             (weights.size() < targets ? "0 is used for the others"
                                                       : "the others are left out"));
    }
    weights.resize(targets, 0.0F);
    return weights;
}

}  // namespace

void readDeformers(const Import& import, NodeList& list, Scene& scene, Report& report) {
    DeformerReader(import, list, scene, report).readAll();
}

}  // namespace ribalta::gltf
