#include "gltf/load_gltf.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <new>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "base/mapped_file.h"
#include "base/parse_json.h"
#include "gltf/add_instances.h"
#include "gltf/bind_dials.h"
#include "gltf/check_extensions.h"
#include "gltf/check_json.h"
#include "gltf/check_nodes.h"
#include "gltf/choose_scene.h"
#include "gltf/choose_variant.h"
#include "gltf/import.h"
#include "gltf/mesh_cache.h"
#include "gltf/parse_model.h"
#include "gltf/plain_nodes.h"
#include "gltf/read_animations.h"
#include "gltf/read_buffers.h"
#include "gltf/read_camera.h"
#include "gltf/read_container.h"
#include "gltf/read_deformers.h"
#include "gltf/read_environment.h"
#include "gltf/read_ies.h"
#include "gltf/read_images.h"
#include "gltf/read_light.h"
#include "gltf/read_material.h"
#include "gltf/read_mesh.h"
#include "gltf/read_nodes.h"
#include "gltf/report_oddities.h"
#include "gltf/report_shapes.h"
#include "gltf/report_unread.h"
#include "gltf/units.h"

namespace ribalta {
namespace {

using namespace gltf;

// Wall times of the steps, one after the other.
class Stopwatch {
  public:
    explicit Stopwatch(std::vector<LoadedScene::Stage>& stages) : stages_(stages) {}

    void lap(const char* stage) {
        const auto now = std::chrono::steady_clock::now();
        stages_.push_back({stage, std::chrono::duration<double, std::milli>(now - last_).count()});
        last_ = now;
    }

  private:
    std::vector<LoadedScene::Stage>& stages_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

void listExtensions(const nlohmann::json& json, LoadedScene& loaded) {
    for (const nlohmann::json& name : member(json, "extensionsUsed")) {
        loaded.extensionsUsed.push_back(name.get<std::string>());
        if (!isSupported(loaded.extensionsUsed.back())) {
            loaded.extensionsIgnored.push_back(loaded.extensionsUsed.back());
        }
    }
}

// The meshes that the nodes use, in the file's order; the nodes' indices become the scene's.
std::vector<std::size_t> chooseMeshes(std::vector<Node>& nodes, std::size_t meshCount) {
    std::vector<int> sceneMesh(meshCount, -1);
    for (const Node& node : nodes) {
        if (node.mesh >= 0) {
            sceneMesh[std::size_t(node.mesh)] = 0;
        }
    }
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < meshCount; ++i) {
        if (sceneMesh[i] == 0) {
            sceneMesh[i] = int(chosen.size());
            chosen.push_back(i);
        }
    }
    for (Node& node : nodes) {
        if (node.mesh >= 0) {
            node.mesh = sceneMesh[std::size_t(node.mesh)];
        }
    }
    return chosen;
}

// Returns the glTF's indices of the scene's meshes.
std::vector<std::size_t> loadMeshes(const Import& import, Scene& scene, Report& report) {
    TangentUvs tangentUvs;
    for (std::size_t i = 0; i < import.model.materials.size(); ++i) {
        tangentUvs.push_back(tangentUvOf(import, i));
    }
    tangentUvs.push_back(-1);
    std::vector<std::size_t> chosen = chooseMeshes(scene.nodes, import.model.meshes.size());
    std::vector<MeshUse> uses(chosen.size());
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        uses[i].mesh = chosen[i];
    }
    for (const Deformer& deformer : scene.deformers) {
        MeshUse& use = uses[std::size_t(scene.nodes[std::size_t(deformer.node)].mesh)];
        use.isMorphed = use.isMorphed || !deformer.restWeights.empty();
        if (deformer.skin >= 0) {
            use.joints =
                std::max(use.joints, scene.skins[std::size_t(deformer.skin)].joints.size());
        }
    }
    scene.meshes = readMeshes(import, uses, tangentUvs, report);
    return chosen;
}

// The materials that the meshes use, in the file's order; the primitives' indices become the
// scene's. Returns by the file's index the scene's, -1 where no mesh uses it.
std::vector<int> loadMaterials(const Import& import, TextureTable& textures, Scene& scene,
                               Report& report) {
    std::vector<int> sceneMaterial(import.model.materials.size(), -1);
    const auto forEachUse = [&](const auto& body) {
        for (Mesh& mesh : scene.meshes) {
            for (Primitive& primitive : mesh.primitives) {
                if (primitive.material >= 0) {
                    body(primitive.material);
                }
            }
        }
    };
    forEachUse([&](int material) { sceneMaterial[std::size_t(material)] = 0; });
    for (std::size_t i = 0; i < sceneMaterial.size(); ++i) {
        if (sceneMaterial[i] == 0) {
            sceneMaterial[i] = int(scene.materials.size());
            scene.materials.push_back(readMaterial(import, i, textures, report));
        }
    }
    forEachUse([&](int& material) { material = sceneMaterial[std::size_t(material)]; });
    return sceneMaterial;
}

// The Draco data of the meshes that nodes have, each once, in the file's order. What is wrong with
// it is said where it is decoded.
std::vector<std::span<const std::byte>> dracoViews(const Import& import,
                                                   const std::vector<Node>& nodes) {
    std::vector<char> isUsed(import.model.meshes.size(), 0);
    for (const Node& node : nodes) {
        if (node.mesh >= 0) {
            isUsed[std::size_t(node.mesh)] = 1;
        }
    }
    std::set<std::size_t> views;
    for (std::size_t mesh = 0; mesh < isUsed.size(); ++mesh) {
        if (isUsed[mesh] == 0) {
            continue;
        }
        for (const nlohmann::json& primitive :
             member(element(import.json, "meshes", mesh), "primitives")) {
            const nlohmann::json& view =
                member(extension(primitive, "KHR_draco_mesh_compression"), "bufferView");
            if (view.is_number_unsigned() && view < import.model.bufferViews.size() &&
                !isPacked(import, view.get<std::size_t>())) {
                views.insert(view.get<std::size_t>());
            }
        }
    }
    std::vector<std::span<const std::byte>> bytes;
    for (const std::size_t view : views) {
        const tinygltf::BufferView& place = import.model.bufferViews[view];
        const std::span<const std::byte> buffer = import.buffers[std::size_t(place.buffer)].bytes;
        if (place.byteOffset <= buffer.size() &&
            place.byteLength <= buffer.size() - place.byteOffset) {
            bytes.push_back(buffer.subspan(place.byteOffset, place.byteLength));
        }
    }
    return bytes;
}

void takeModel(const Import& import) {
    std::uint64_t bytes = 0;
    const auto add = [&](const char* array, std::size_t each) {
        bytes += member(import.json, array).size() * each;
    };
    add("nodes", sizeof(FileNode) + sizeof(Node));
    add("accessors", sizeof(tinygltf::Accessor));
    add("bufferViews", sizeof(tinygltf::BufferView));
    add("materials", sizeof(tinygltf::Material) + sizeof(Material));
    add("textures", sizeof(tinygltf::Texture) + sizeof(Texture));
    add("samplers", sizeof(tinygltf::Sampler));
    add("scenes", sizeof(tinygltf::Scene));
    for (const nlohmann::json& mesh : member(import.json, "meshes")) {
        bytes += sizeof(tinygltf::Mesh) + sizeof(Mesh);
        bytes +=
            member(mesh, "primitives").size() * (sizeof(tinygltf::Primitive) + sizeof(Primitive));
    }
    import.budget->takeNodes(member(import.json, "nodes").size(), import.file.at("nodes"));
    import.budget->takeMemory(bytes, import.file);
}

// What the libraries underneath throw leaves here as an Error, too.
template <typename Work>
auto withTypedErrors(const Place& file, const Work& work) {
    try {
        return work();
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw Error(ErrorKind::kJobFailed, file,
                    "needs more memory than there is; close other programs, or simplify it");
    } catch (const std::exception& error) {
        throw Error(ErrorKind::kBadInput, file,
                    std::string("cannot be read (") + error.what() + "); export it again");
    }
}

}  // namespace

struct GltfLoad::State {
    LoadedScene loaded;
    std::optional<MappedFile> glb;  // whose bytes the first buffer is
    Import import;
    ImageTable images{import};

    void read(const std::filesystem::path& path, const LoadOptions& options);
    void expectFilesUnchanged() const;
    template <typename Work>
    auto run(const Work& work) const;
};

void GltfLoad::State::expectFilesUnchanged() const {
    if (glb) {
        glb->expectUnchanged();
    }
    for (const Buffer& buffer : import.buffers) {
        if (buffer.file) {
            buffer.file->expectUnchanged();
        }
    }
}

// Faults that a file has because it is being written to are told as that.
template <typename Work>
auto GltfLoad::State::run(const Work& work) const {
    return withTypedErrors(import.file, [&] {
        try {
            return work();
        } catch (const Error&) {
            expectFilesUnchanged();
            throw;
        }
    });
}

void GltfLoad::State::read(const std::filesystem::path& path, const LoadOptions& options) {
    Scene& scene = loaded.scene;
    Report& report = loaded.report;
    Stopwatch watch(loaded.stages);

    import.folder = path.parent_path();
    import.allowOutside = options.allowOutside;
    import.budget = std::make_unique<Budget>(options.limits);
    glb.emplace(path, import.budget->memoryLeft());
    const Container container = readContainer(glb->bytes(), import.file);
    import.budget->takeMemory(glb->bytes().size(), import.file);
    std::string text(container.json);
    glb->expectUnchanged();
    if (!container.bin) {
        glb.reset();
    }
    watch.lap("read");

    const auto takeMemory = [&](std::uint64_t kept, std::uint64_t peak) {
        import.budget->expectMemory(peak, import.file);
        import.budget->takeMemory(kept, import.file);
    };
    const auto expectNodes = [&](std::size_t count) {
        import.budget->expectMemory(count * sizeof(FileNode), import.file);
    };
    const auto readPlain = [&](const simdjson::dom::element& document) {
        return readPlainNodes(document, expectNodes, import.nodeMemory, import.nodes);
    };
    import.json = parseJson(text, import.file, {"a glTF", "export the file again"},
                            {std::min(options.limits.nesting, kMaxNesting), UINT64_MAX, takeMemory},
                            {"nodes", plainMembers(), readPlain});
    text = {};
    checkVersionAndExtensions(import.json, import.file);
    checkJson(import.json, import.file, report);
    readOtherNodes(import.json, import.nodeMemory, import.nodes);
    checkNodes(import.nodes, import.json, import.file, report);
    listExtensions(import.json, loaded);
    takeModel(import);
    loaded.variantNames = chooseVariant(import.json, options.variant, import.file, report);
    import.model = parseModel(import.json);
    reportUnread(import, report);
    reportShapes(import, report);
    const ChosenScene chosen = chooseScene(import, options.scene, report);
    loaded.sceneNames = chosen.allNames;
    loaded.sceneIndex = chosen.index;
    NodeList list = readNodes(import, chosen.roots, report);
    scene.name = chosen.index < 0 ? "" : chosen.allNames[std::size_t(chosen.index)];
    watch.lap("parse");

    import.buffers = readBuffers(import, container.bin, report);
    import.packed = findPackedViews(import.json);
    watch.lap("buffers");

    readDeformers(import, list, scene, report);
    const std::vector<DialSource> dials = readAnimations(import, list, scene, report);
    leaveOutVanished(list, scene.movers, import, report);
    addInstances(import, list, report);
    scene.nodes = std::move(list.nodes);
    watch.lap("animations");

    import.meshCache = std::make_unique<MeshCache>(options.cache, dracoViews(import, scene.nodes));
    const std::vector<std::size_t> meshes = loadMeshes(import, scene, report);
    loaded.meshesFromCache = import.meshCache->found();
    expectFilesUnchanged();
    import.meshCache->keep();
    reportDataOddities(import, meshes, report);
    watch.lap("meshes");

    TextureTable textures(import, images);
    SceneUses uses;
    uses.materials = loadMaterials(import, textures, scene, report);
    list.gltfNodes.resize(list.inScene);
    scene.cameras = readCameras(import, list.gltfNodes, report);
    IesLamps iesLamps(import);
    uses.isPunctual.resize(list.inScene, 0);
    for (std::size_t i = 0; i < list.gltfNodes.size(); ++i) {
        if (!iesLamps.add(list.gltfNodes[i], int(i), images, scene, report)) {
            uses.isPunctual[i] = 1;
            addLamp(import, list.gltfNodes[i], int(i), images, textures, scene, report);
        }
    }
    uses.gltfNodes = std::move(list.gltfNodes);
    bindDials(import, dials, uses, scene, report);
    readEnvironment(import, chosen.index, scene, report);
    report.append(images.takeNotes());
    scene.textures = textures.textures();
    scene.images = images.undecoded();
    loaded.files.assign(images.files().begin(), images.files().end());
    loaded.files.push_back(path);
    reportSceneOddities(import, meshes, scene, report);
    scaleUnits(options, scene);
    placeNodes(scene);
    hintAtUnits(options, import.file, scene, report);
    watch.lap("place");
}

GltfLoad::GltfLoad(const std::filesystem::path& path, const LoadOptions& options)
    : state_(std::make_unique<State>()) {
    state_->import.file = {path.string(), ""};
    state_->run([&] { state_->read(path, options); });
}

GltfLoad::~GltfLoad() = default;

LoadedScene GltfLoad::takeScene() {
    return std::move(state_->loaded);
}

Report GltfLoad::decodeImages(const std::function<bool(std::size_t, Image)>& take) const {
    return state_->run([&] {
        Report report = state_->images.decode(take);
        state_->expectFilesUnchanged();
        return report;
    });
}

LoadedScene loadGltf(const std::filesystem::path& path, const LoadOptions& options) {
    GltfLoad load(path, options);
    LoadedScene loaded = load.takeScene();
    Stopwatch watch(loaded.stages);
    loaded.report.append(load.decodeImages([&](std::size_t index, Image image) {
        loaded.scene.images[index] = std::move(image);
        return true;
    }));
    watch.lap("images");
    return loaded;
}

}  // namespace ribalta
