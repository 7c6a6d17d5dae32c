#include "inspect_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/angles.h"
#include "base/error.h"
#include "base/log.h"
#include "base/progress.h"
#include "cache_options.h"
#include "gltf/load_gltf.h"
#include "loading_options.h"
#include "outcome_table.h"
#include "process.h"

namespace ribalta {
namespace {

struct InspectOptions {
    std::string scene;
    bool isSceneGiven = false;
    LoadingOptions loading;
    CacheOptions cache;
    bool all = false;
    bool strict = false;
    std::vector<std::string> table;
};

std::string quoted(const std::string& name) {
    return "'" + oneLine(name) + "'";
}

struct MeshTotals {
    std::size_t primitives = 0;
    std::size_t triangles = 0;  ///< in memory
    std::size_t drawn = 0;      ///< as placed by the nodes
};

std::size_t trianglesOf(const Mesh& mesh) {
    std::size_t triangles = 0;
    for (const Primitive& primitive : mesh.primitives) {
        triangles += primitive.topology == Topology::kTriangles ? primitive.indices.size() / 3 : 0;
    }
    return triangles;
}

MeshTotals totalsOf(const Scene& scene) {
    MeshTotals totals;
    for (const Mesh& mesh : scene.meshes) {
        totals.primitives += mesh.primitives.size();
        totals.triangles += trianglesOf(mesh);
    }
    for (const Node& node : scene.nodes) {
        totals.drawn += node.isDrawn() ? trianglesOf(scene.meshes[std::size_t(node.mesh)]) : 0;
    }
    return totals;
}

// The largest meshes, or all of them in the file's order.
void printMeshes(const Scene& scene, bool all) {
    constexpr std::size_t kShown = 10;
    std::vector<std::pair<std::size_t, const Mesh*>> meshes;
    for (const Mesh& mesh : scene.meshes) {
        meshes.emplace_back(trianglesOf(mesh), &mesh);
    }
    const std::size_t shown = all ? meshes.size() : std::min(kShown, meshes.size());
    if (!all) {
        std::stable_sort(meshes.begin(), meshes.end(),
                         [](const auto& a, const auto& b) { return a.first > b.first; });
    }
    for (std::size_t i = 0; i < shown; ++i) {
        const auto& [triangles, mesh] = meshes[i];
        std::printf("  %s %zu triangles", quoted(mesh->name).c_str(), triangles);
        if (mesh->primitives.size() > 1) {
            std::printf(" in %zu primitives", mesh->primitives.size());
        }
        std::printf("\n");
    }
    if (shown < meshes.size()) {
        std::printf("  and %zu smaller ones (--all lists them)\n", meshes.size() - shown);
    }
}

// What is uploaded once for several primitives.
void printSharing(const Scene& scene) {
    std::set<int> vertices;
    std::set<int> indices;
    std::size_t withVertices = 0;
    std::size_t withIndices = 0;
    for (const Mesh& mesh : scene.meshes) {
        for (const Primitive& primitive : mesh.primitives) {
            if (primitive.sharedVertices >= 0) {
                vertices.insert(primitive.sharedVertices);
                ++withVertices;
            }
            if (primitive.sharedIndices >= 0) {
                indices.insert(primitive.sharedIndices);
                ++withIndices;
            }
        }
    }
    if (withVertices + withIndices > 0) {
        std::printf("shared     %zu primitives have the vertices of another, %zu the indices\n",
                    withVertices - vertices.size(), withIndices - indices.size());
    }
}

void printDeformers(const Scene& scene) {
    if (scene.deformers.empty()) {
        return;
    }
    std::size_t joints = 0;
    for (const Skin& skin : scene.skins) {
        joints += skin.joints.size();
    }
    std::size_t morphed = 0;
    for (const Deformer& deformer : scene.deformers) {
        morphed += deformer.restWeights.empty() ? 0 : 1;
    }
    std::printf("deformed   %zu meshes as placed, %zu with morph targets; %zu skins, %zu joints\n",
                scene.deformers.size(), morphed, scene.skins.size(), joints);
}

void printMaterials(const Scene& scene) {
    std::printf("materials  %zu\n", scene.materials.size());
    for (const Material& material : scene.materials) {
        const int textures =
            material.baseColorTexture.has_value() + material.metallicRoughnessTexture.has_value() +
            material.normalTexture.has_value() + material.occlusionTexture.has_value() +
            material.emissiveTexture.has_value();
        std::printf("  %s %d textures%s%s%s%s\n", quoted(material.name).c_str(), textures,
                    material.alphaMode == Material::AlphaMode::kMask    ? ", masked"
                    : material.alphaMode == Material::AlphaMode::kBlend ? ", blended"
                                                                        : "",
                    material.doubleSided ? ", double-sided" : "", material.unlit ? ", unlit" : "",
                    material.emission == glm::vec3(0.0F) ? "" : ", shines");
    }
}

void printGeometry(const Scene& scene, bool allMeshes) {
    const MeshTotals totals = totalsOf(scene);
    const auto hidden = std::count_if(scene.nodes.begin(), scene.nodes.end(),
                                      [](const Node& node) { return !node.shown; });
    std::printf("nodes      %zu", scene.nodes.size());
    if (hidden > 0) {
        std::printf(", %zu hidden", std::size_t(hidden));
    }
    std::printf("\n");
    std::printf("meshes     %zu, %zu primitives\n", scene.meshes.size(), totals.primitives);
    printMeshes(scene, allMeshes);
    printSharing(scene);
    std::printf("triangles  %zu, %zu as placed\n", totals.triangles, totals.drawn);
    printDeformers(scene);
    const Bounds bounds = tightSceneBounds(scene);
    if (!bounds.isEmpty()) {
        std::printf("extent     %.3g x %.3g x %.3g m\n", bounds.high.x - bounds.low.x,
                    bounds.high.y - bounds.low.y, bounds.high.z - bounds.low.z);
    }
    printMaterials(scene);
    std::printf("images     %zu\n", scene.images.size());
    for (const Image& image : scene.images) {
        std::printf("  %s %dx%d%s\n", quoted(image.name).c_str(), image.width, image.height,
                    image.type == Image::Type::kFloat32 ? " float" : "");
    }
}

void printLightMap(const Scene& scene, const SpotLight& lamp) {
    if (!lamp.lightMap) {
        return;
    }
    const std::string& name = scene.images[std::size_t(lamp.lightMap->image)].name;
    std::printf(", light map %s", quoted(name).c_str());
    if (lamp.lightMap->rotationRadians != 0.0) {
        std::printf(" turned %.1f deg", lamp.lightMap->rotationRadians * kDegreesPerRadian);
    }
}

void printLamps(const Scene& scene) {
    std::printf("spots      %zu\n", scene.spotLights.size());
    for (const SpotLight& lamp : scene.spotLights) {
        std::printf("  %s %.0f cd, colour %.2f %.2f %.2f, half angle %.1f deg (inner %.1f)",
                    quoted(lamp.name).c_str(), lamp.intensityCandela, double(lamp.color.x),
                    double(lamp.color.y), double(lamp.color.z),
                    lamp.outerConeAngle * kDegreesPerRadian,
                    lamp.innerConeAngle * kDegreesPerRadian);
        if (std::isfinite(lamp.rangeMetres)) {
            std::printf(", range %.3g m", lamp.rangeMetres);
        }
        if (lamp.beamShape == BeamShape::kPyramid) {
            std::printf(", pyramid");
        }
        if (!lamp.shown) {
            std::printf(", hidden");
        }
        printLightMap(scene, lamp);
        std::printf("\n");
    }
    std::printf("points     %zu\n", scene.pointLights.size());
    for (const PointLight& lamp : scene.pointLights) {
        std::printf("  %s %.4g cd%s\n", quoted(lamp.name).c_str(), lamp.intensityCandela,
                    lamp.shown ? "" : ", hidden");
    }
    std::printf("directional %zu\n", scene.directionalLights.size());
    for (const DirectionalLight& lamp : scene.directionalLights) {
        std::printf("  %s %.4g lux%s\n", quoted(lamp.name).c_str(), lamp.illuminanceLux,
                    lamp.shown ? "" : ", hidden");
    }
    if (scene.spotLights.empty() && scene.pointLights.empty() && scene.directionalLights.empty()) {
        std::printf("  no lamps: only ambient light will be drawn\n");
    }
    if (scene.environment) {
        const glm::dvec3 floor = irradiance(*scene.environment, {0.0, 1.0, 0.0});
        const glm::dvec3 ceiling = irradiance(*scene.environment, {0.0, -1.0, 0.0});
        std::printf("environment %s %.4g %.4g %.4g lux from above, %.4g %.4g %.4g from below\n",
                    quoted(scene.environment->name).c_str(), floor.x, floor.y, floor.z, ceiling.x,
                    ceiling.y, ceiling.z);
    }
}

void printCameras(const Scene& scene) {
    std::printf("cameras    %zu\n", scene.cameras.size());
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
        const Camera& camera = scene.cameras[i];
        std::printf("  %zu %s ", i, quoted(camera.name).c_str());
        if (const auto* lens = std::get_if<PerspectiveLens>(&camera.lens)) {
            std::printf("perspective, %.1f deg high", lens->verticalFov * kDegreesPerRadian);
        } else {
            const auto& box = std::get<OrthographicLens>(camera.lens);
            std::printf("orthographic, %.3g x %.3g m", 2.0 * box.halfWidth, 2.0 * box.halfHeight);
        }
        std::printf(", near %.3g m, far %.3g m\n", camera.nearMetres, camera.farMetres);
    }
    if (scene.cameras.empty()) {
        std::printf("  none: one that frames the scene will be made\n");
    }
}

void printAnimations(const Scene& scene, bool all) {
    constexpr std::size_t kShown = 10;
    std::printf("animations %zu", scene.animations.size());
    if (!scene.animations.empty()) {
        std::printf(", %.4g s together, of %zu nodes", durationSeconds(scene), scene.movers.size());
        if (!scene.dials.empty()) {
            std::printf(" and %zu properties of lamps, cameras, materials and nodes",
                        scene.dials.size());
        }
    }
    std::printf("\n");
    const std::size_t count = scene.animations.size();
    const std::size_t shown = all ? count : std::min(kShown, count);
    for (std::size_t i = 0; i < shown; ++i) {
        const Animation& animation = scene.animations[i];
        std::printf("  %zu %s %.4g s, %zu channel%s\n", i, quoted(animation.name).c_str(),
                    durationSeconds(scene, int(i)), animation.channels.size(),
                    animation.channels.size() == 1 ? "" : "s");
    }
    if (shown < count) {
        std::printf("  and %zu more (--all lists them)\n", count - shown);
    }
}

void printExtensions(const LoadedScene& loaded) {
    const std::set<std::string> ignored(loaded.extensionsIgnored.begin(),
                                        loaded.extensionsIgnored.end());
    std::printf("extensions %zu used, %zu ignored\n", loaded.extensionsUsed.size(), ignored.size());
    for (const std::string& extension : loaded.extensionsUsed) {
        std::printf("  %s%s\n", oneLine(extension).c_str(),
                    ignored.contains(extension) ? " (ignored)" : "");
    }
}

// Only where there is something to choose from.
void printScenes(const LoadedScene& loaded) {
    const std::size_t count = loaded.sceneNames.size();
    if (count < 2) {
        return;
    }
    std::printf("scenes     %zu, one is drawn (--scene chooses)\n", count);
    for (std::size_t i = 0; i < count; ++i) {
        std::printf("  %zu %s%s\n", i, quoted(loaded.sceneNames[i]).c_str(),
                    int(i) == loaded.sceneIndex ? ", drawn" : "");
    }
}

void printVariants(const LoadedScene& loaded) {
    const std::size_t count = loaded.variantNames.size();
    if (count == 0) {
        return;
    }
    std::printf("variants   %zu of materials (--variant chooses)\n", count);
    for (std::size_t i = 0; i < count; ++i) {
        std::printf("  %zu %s\n", i, quoted(loaded.variantNames[i]).c_str());
    }
}

LoadedScene load(const std::string& path, const LoadOptions& options) {
    const Progress progress("loading");
    return loadGltf(path, options);
}

// With --strict nothing may be left to say of a file.
void refuseReported(const std::string& path, const Report& report) {
    const std::size_t count = report.entries().size();
    if (count == 0) {
        return;
    }
    for (const Report::Entry& entry : report.entries()) {
        logError(entry.place.text() + ": " + name(entry.kind) + ": " + entry.message);
    }
    throw Error(ErrorKind::kBadInput, {path, ""},
                "has " + std::to_string(count) + (count == 1 ? " fault" : " faults") +
                    ", and --strict allows none; mend the file, or leave the option out");
}

void inspectMany(const InspectOptions& options) {
    const OutcomeCounts counts = printOutcomes(options.table, options.loading.parsed());
    finishStdout();
    const std::size_t count = counts.loaded + counts.reported + counts.refused;
    const std::string summary = std::to_string(count) + (count == 1 ? " file: " : " files: ") +
                                std::to_string(counts.loaded) + " loaded, " +
                                std::to_string(counts.reported) + " with something to report, " +
                                std::to_string(counts.refused) + " refused";
    if (options.strict && counts.loaded < count) {
        throw Error(ErrorKind::kBadInput, {}, summary);
    }
    logNote(summary);
}

void inspect(const InspectOptions& options) {
    if (!options.table.empty()) {
        inspectMany(options);
        return;
    }
    if (!options.isSceneGiven) {
        throw CLI::RequiredError("scene");
    }
    const std::optional<FileCache> cache = options.cache.cache();
    LoadOptions loading = options.loading.parsed();
    loading.cache = cache ? &*cache : nullptr;
    const LoadedScene loaded = load(options.scene, loading);
    const bool all = options.all;
    std::printf("%s\n", options.scene.c_str());
    printScenes(loaded);
    printVariants(loaded);
    printGeometry(loaded.scene, all);
    printLamps(loaded.scene);
    printCameras(loaded.scene);
    printAnimations(loaded.scene, all);
    printExtensions(loaded);
    std::printf("report     %zu lines\n", loaded.report.entries().size());
    for (const Report::Entry& entry : loaded.report.entries()) {
        std::printf("  %s: %s: %s\n", name(entry.kind), oneLine(entry.place.pointer).c_str(),
                    oneLine(entry.message).c_str());
    }
    if (loaded.meshesFromCache > 0) {
        std::printf("cache      %zu meshes were found decoded\n", loaded.meshesFromCache);
    }
    for (const LoadedScene::Stage& stage : loaded.stages) {
        std::printf("load       %-10s %9.2f ms\n", stage.name.c_str(), stage.ms);
    }
    if (options.strict) {
        finishStdout();
        refuseReported(options.scene, loaded.report);
    }
}

}  // namespace

void addInspectCommand(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "inspect", "Says what a scene file holds, and what was ignored or repaired.");
    const auto options = std::make_shared<InspectOptions>();
    CLI::Option* const scene =
        command->add_option("scene", options->scene, "glTF scene, .gltf or .glb")
            ->type_name("FILE");
    command
        ->add_option("--table", options->table,
                     "instead of one scene: load all of these files, and the .gltf and .glb in "
                     "these folders and below; print path, outcome (loaded, reported, refused) "
                     "and first message of each, parted by tabs")
        ->type_name("FILE|FOLDER")
        ->excludes(scene);
    options->loading.addTo(*command);
    options->cache.addTo(*command);
    command->add_flag("--all", options->all, "list every mesh and animation, not only ten");
    command->add_flag("--strict", options->strict,
                      "make every line of the report an error on stderr, and end with exit code 3 "
                      "where there is one");
    command->callback([options, scene] {
        options->isSceneGiven = scene->count() > 0;
        inspect(*options);
    });
}

}  // namespace ribalta
