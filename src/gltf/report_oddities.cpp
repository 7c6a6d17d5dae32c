#include "gltf/report_oddities.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "gltf/tally.h"
#include "gltf/where.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

// Which accessors and buffer views drawn meshes use.
struct Used {
    std::vector<char> accessors;
    std::vector<char> views;
};

Used listUsed(const tinygltf::Model& model, const std::vector<std::size_t>& meshes) {
    Used used{std::vector<char>(model.accessors.size(), 0),
              std::vector<char>(model.bufferViews.size(), 0)};
    for (const std::size_t mesh : meshes) {
        for (const tinygltf::Primitive& primitive : model.meshes[mesh].primitives) {
            if (primitive.indices >= 0) {
                used.accessors[std::size_t(primitive.indices)] = 1;
            }
            for (const auto& [name, accessor] : primitive.attributes) {
                used.accessors[std::size_t(accessor)] = 1;
            }
        }
    }
    for (std::size_t i = 0; i < model.accessors.size(); ++i) {
        if (used.accessors[i] != 0 && model.accessors[i].bufferView >= 0) {
            used.views[std::size_t(model.accessors[i].bufferView)] = 1;
        }
    }
    return used;
}

// An element's bytes, and the distance to the next where none is given. A matrix's columns start at
// multiples of four bytes (glTF 2.0, section 3.6.2.4), and nothing follows the last.
struct ElementSize {
    std::size_t bytes = 0;
    std::size_t stride = 0;
};

ElementSize elementSize(const tinygltf::Accessor& accessor) {
    const auto component =
        std::size_t(tinygltf::GetComponentSizeInBytes(std::uint32_t(accessor.componentType)));
    const auto matrix = [&](std::size_t rows) {
        const std::size_t column = (rows * component + 3) / 4 * 4;
        return ElementSize{(rows - 1) * column + rows * component, rows * column};
    };
    switch (accessor.type) {
        case TINYGLTF_TYPE_MAT2:
            return matrix(2);
        case TINYGLTF_TYPE_MAT3:
            return matrix(3);
        case TINYGLTF_TYPE_MAT4:
            return matrix(4);
        default:
            break;
    }
    const std::size_t bytes =
        component * std::size_t(tinygltf::GetNumComponentsInType(std::uint32_t(accessor.type)));
    return {bytes, bytes};
}

void tallyUnfit(const Import& import, const Used& used, Tally& tally) {
    const tinygltf::Model& model = import.model;
    const Where root(import.file);
    const Where views(root, "bufferViews");
    for (std::size_t i = 0; i < model.bufferViews.size(); ++i) {
        const tinygltf::BufferView& view = model.bufferViews[i];
        const auto length = element(import.json, "buffers", std::size_t(view.buffer))["byteLength"]
                                .get<std::size_t>();
        if (used.views[i] == 0 &&
            (view.byteOffset > length || view.byteLength > length - view.byteOffset)) {
            tally.add("reaches past its buffer", Where(views, i));
        }
    }
    const Where accessors(root, "accessors");
    for (std::size_t i = 0; i < model.accessors.size(); ++i) {
        const tinygltf::Accessor& accessor = model.accessors[i];
        const Where here(accessors, i);
        if (accessor.bufferView < 0) {
            if (element(import.json, "accessors", i).contains("byteOffset")) {
                tally.add("has a byteOffset but no bufferView", here);
            }
            continue;
        }
        const tinygltf::BufferView& view = model.bufferViews[std::size_t(accessor.bufferView)];
        const auto [size, tight] = elementSize(accessor);
        const std::size_t stride = view.byteStride == 0 ? tight : view.byteStride;
        const std::size_t length = view.byteLength;
        if (used.accessors[i] == 0 &&
            (stride < size || accessor.byteOffset > length || size > length - accessor.byteOffset ||
             (length - accessor.byteOffset - size) / stride < accessor.count - 1)) {
            tally.add("reaches past its buffer view", here);
        }
    }
}

void tallyMisaligned(const Import& import, Tally& tally) {
    const tinygltf::Model& model = import.model;
    const Where root(import.file);
    const Where accessors(root, "accessors");
    std::vector<char> isAttribute(model.accessors.size(), 0);
    for (const tinygltf::Mesh& mesh : model.meshes) {
        for (const tinygltf::Primitive& primitive : mesh.primitives) {
            for (const auto& [name, accessor] : primitive.attributes) {
                isAttribute[std::size_t(accessor)] = 1;
            }
        }
    }
    for (std::size_t i = 0; i < model.accessors.size(); ++i) {
        const tinygltf::Accessor& accessor = model.accessors[i];
        if (accessor.bufferView < 0) {
            continue;
        }
        const tinygltf::BufferView& view = model.bufferViews[std::size_t(accessor.bufferView)];
        const auto component =
            std::size_t(tinygltf::GetComponentSizeInBytes(std::uint32_t(accessor.componentType)));
        const std::size_t stride =
            view.byteStride == 0 ? elementSize(accessor).stride : view.byteStride;
        const bool vertexMisaligned =
            isAttribute[i] != 0 && (accessor.byteOffset % 4 != 0 || stride % 4 != 0);
        if ((view.byteOffset + accessor.byteOffset) % component != 0 || vertexMisaligned) {
            tally.add("is not aligned as glTF 2.0 (section 3.6.2.4) asks", Where(accessors, i));
        }
    }
}

// The types of section 3.7.2.1; others need the extension.
bool isPlainType(std::string_view attribute, const tinygltf::Accessor& accessor) {
    const bool isFloat = accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT;
    if (attribute == "POSITION" || attribute == "NORMAL" || attribute == "TANGENT") {
        return isFloat;
    }
    const bool isUnsigned = accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                            accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    if (attribute.starts_with("TEXCOORD_") || attribute.starts_with("COLOR_")) {
        return isFloat || (isUnsigned && accessor.normalized);
    }
    return true;
}

void tallyQuantized(const Import& import, Tally& tally) {
    const json& required = member(import.json, "extensionsRequired");
    if (std::find(required.begin(), required.end(), "KHR_mesh_quantization") != required.end()) {
        return;
    }
    const Where root(import.file);
    const Where meshes(root, "meshes");
    for (std::size_t m = 0; m < import.model.meshes.size(); ++m) {
        const Where mesh(meshes, m);
        const Where primitives(mesh, "primitives");
        const auto& list = import.model.meshes[m].primitives;
        for (std::size_t p = 0; p < list.size(); ++p) {
            const Where primitive(primitives, p);
            const Where attributes(primitive, "attributes");
            for (const auto& [name, accessor] : list[p].attributes) {
                if (!isPlainType(name, import.model.accessors[std::size_t(accessor)])) {
                    tally.add(
                        "has a type that needs KHR_mesh_quantization in extensionsRequired; "
                        "it is read all the same",
                        Where(attributes, name));
                }
            }
        }
    }
}

// The first texture of a material that is looked up with coordinates which a primitive lacks.
std::optional<int> missingUvSet(const Material& material, const Primitive& primitive) {
    for (const auto* slot :
         {&material.baseColorTexture, &material.metallicRoughnessTexture, &material.normalTexture,
          &material.occlusionTexture, &material.emissiveTexture}) {
        if (*slot && ((*slot)->uvSet == 0 ? primitive.uv0 : primitive.uv1).empty()) {
            return (*slot)->uvSet;
        }
    }
    return std::nullopt;
}

}  // namespace

void reportDataOddities(const Import& import, const std::vector<std::size_t>& meshes,
                        Report& report) {
    Tally tally;
    tallyUnfit(import, listUsed(import.model, meshes), tally);
    tallyMisaligned(import, tally);
    tallyQuantized(import, tally);
    tally.tell(Report::Kind::kHint, "", report);
}

void reportSceneOddities(const Import& import, const std::vector<std::size_t>& meshes,
                         const Scene& scene, Report& report) {
    Tally tally;
    const Where root(import.file);
    const Where list(root, "meshes");
    bool isEmpty = true;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        const Where where(list, meshes[m]);
        for (const Primitive& primitive : scene.meshes[m].primitives) {
            isEmpty = false;
            if (primitive.material < 0) {
                continue;
            }
            const Material& material = scene.materials[std::size_t(primitive.material)];
            if (const auto uvSet = missingUvSet(material, primitive)) {
                tally.add("lacks TEXCOORD_" + std::to_string(*uvSet) +
                              " for a texture of its material, which shows one colour",
                          where);
            }
        }
    }
    tally.tell(Report::Kind::kHint, "", report);
    if (isEmpty) {
        report.hint(import.file, "holds nothing to draw: no mesh hangs in its scene");
    }
}

}  // namespace ribalta::gltf
