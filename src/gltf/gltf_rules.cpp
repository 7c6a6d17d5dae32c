// The rules of glTF 2.0 (section 5) and KHR_lights_punctual for what the import reads, as tables.
#include "base/angles.h"
#include "gltf/json_rules.h"
#include "scene/light.h"
#include "scene/material.h"

namespace ribalta::gltf {
namespace {

using Is = JsonRule::Is;
using On = JsonRule::OnFault;

// tinygltf holds the sizes of sparse accessors in this.
constexpr double kMaxInt = 2147483647;

const JsonRule kName{.key = "name", .is = Is::kString, .onFault = On::kRepair};

const JsonRule kExtensions{.key = "extensions", .is = Is::kObject, .onFault = On::kRepair};

// Of morph targets. A product with a displacement still fits single precision.
const JsonRule kWeights{
    .key = "weights", .is = Is::kNumbers, .onFault = On::kRepair, .low = -1e6, .high = 1e6};

const JsonRule kAssetRules[] = {
    {.key = "version", .is = Is::kString, .required = true},
    {.key = "minVersion", .is = Is::kString},
};
const JsonRule kSceneRules[] = {kName, {.key = "nodes", .is = Is::kIndices, .into = "nodes"}};
const JsonRule kVisibilityRules[] = {
    {.key = "visible", .is = Is::kBool, .onFault = On::kRepair},
};
const JsonRule kNodeExtensionRules[] = {
    {.key = "KHR_node_visibility",
     .is = Is::kObject,
     .onFault = On::kRepair,
     .members = kVisibilityRules},
};
const JsonRule kNodeRules[] = {
    kName,
    {.key = "extensions",
     .is = Is::kObject,
     .onFault = On::kRepair,
     .members = kNodeExtensionRules},
    {.key = "children", .is = Is::kIndices, .into = "nodes"},
    {.key = "mesh", .is = Is::kIndex, .into = "meshes"},
    {.key = "camera", .is = Is::kIndex, .into = "cameras"},
    {.key = "matrix", .is = Is::kNumbers, .length = 16},
    {.key = "translation", .is = Is::kNumbers, .length = 3},
    {.key = "rotation", .is = Is::kNumbers, .length = 4},
    {.key = "scale", .is = Is::kNumbers, .length = 3},
    {.key = "skin", .is = Is::kIndex, .onFault = On::kRepair, .into = "skins"},
    kWeights,
};
const JsonRule kPrimitiveRules[] = {
    kExtensions,
    {.key = "attributes", .is = Is::kIndexMap, .required = true, .into = "accessors"},
    {.key = "indices", .is = Is::kIndex, .into = "accessors"},
    {.key = "material", .is = Is::kIndex, .onFault = On::kRepair, .into = "materials"},
    {.key = "mode", .is = Is::kInteger, .values = {0, 1, 2, 3, 4, 5, 6}},
    {.key = "targets", .is = Is::kIndexMaps, .onFault = On::kRepair, .into = "accessors"},
};
const JsonRule kMeshRules[] = {
    kName,
    kWeights,
    {.key = "primitives", .is = Is::kObjects, .required = true, .members = kPrimitiveRules},
};
const JsonRule kSparseIndexRules[] = {
    {.key = "bufferView", .is = Is::kIndex, .required = true, .into = "bufferViews"},
    {.key = "byteOffset", .is = Is::kInteger, .low = 0, .high = kMaxInt},
    {.key = "componentType", .is = Is::kInteger, .required = true, .values = {5121, 5123, 5125}},
};
const JsonRule kSparseValueRules[] = {
    {.key = "bufferView", .is = Is::kIndex, .required = true, .into = "bufferViews"},
    {.key = "byteOffset", .is = Is::kInteger, .low = 0, .high = kMaxInt},
};
const JsonRule kSparseRules[] = {
    {.key = "count", .is = Is::kInteger, .required = true, .low = 1, .high = kMaxInt},
    {.key = "indices", .is = Is::kObject, .required = true, .members = kSparseIndexRules},
    {.key = "values", .is = Is::kObject, .required = true, .members = kSparseValueRules},
};
const JsonRule kAccessorRules[] = {
    {.key = "bufferView", .is = Is::kIndex, .into = "bufferViews"},
    {.key = "byteOffset", .is = Is::kInteger, .low = 0},
    {.key = "componentType",
     .is = Is::kInteger,
     .required = true,
     .values = {5120, 5121, 5122, 5123, 5125, 5126}},
    {.key = "count", .is = Is::kInteger, .required = true, .low = 1},
    {.key = "type",
     .is = Is::kString,
     .required = true,
     .words = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"}},
    {.key = "normalized", .is = Is::kBool, .onFault = On::kRepair},
    {.key = "sparse", .is = Is::kObject, .members = kSparseRules},
};
const JsonRule kBufferRules[] = {
    {.key = "uri", .is = Is::kString},
    {.key = "byteLength", .is = Is::kInteger, .required = true, .low = 1},
};
const JsonRule kBufferViewRules[] = {
    {.key = "buffer", .is = Is::kIndex, .required = true, .into = "buffers"},
    {.key = "byteOffset", .is = Is::kInteger, .low = 0},
    {.key = "byteLength", .is = Is::kInteger, .required = true, .low = 1},
    {.key = "byteStride", .is = Is::kInteger, .low = 4, .high = 252, .multipleOf = 4},
};

const JsonRule kTextureRules[] = {
    kExtensions,
    {.key = "index", .is = Is::kIndex, .required = true, .into = "textures"},
    {.key = "texCoord", .is = Is::kInteger, .low = 0, .high = 1000},
    {.key = "scale", .is = Is::kNumber, .onFault = On::kRepair, .low = -1e6, .high = 1e6},
    {.key = "strength", .is = Is::kNumber, .onFault = On::kRepair, .low = 0, .high = 1},
};
JsonRule textureSlot(std::string_view key) {
    return {.key = key, .is = Is::kObject, .onFault = On::kRepair, .members = kTextureRules};
}
JsonRule unitNumber(std::string_view key) {
    return {.key = key, .is = Is::kNumber, .onFault = On::kRepair, .low = 0, .high = 1};
}
JsonRule unitNumbers(std::string_view key, std::size_t length) {
    return {.key = key,
            .is = Is::kNumbers,
            .onFault = On::kRepair,
            .low = 0,
            .high = 1,
            .length = length};
}
const JsonRule kMetallicRoughnessRules[] = {
    unitNumbers("baseColorFactor", 4),       unitNumber("metallicFactor"),
    unitNumber("roughnessFactor"),           textureSlot("baseColorTexture"),
    textureSlot("metallicRoughnessTexture"),
};
const JsonRule kEmissiveStrengthRules[] = {
    {.key = "emissiveStrength",
     .is = Is::kNumber,
     .onFault = On::kRepair,
     .low = 0,
     .high = kMaxEmission},
};
const JsonRule kClearcoatRules[] = {
    unitNumber("clearcoatFactor"),         unitNumber("clearcoatRoughnessFactor"),
    textureSlot("clearcoatTexture"),       textureSlot("clearcoatRoughnessTexture"),
    textureSlot("clearcoatNormalTexture"),
};
const JsonRule kIorRules[] = {
    {.key = "ior", .is = Is::kNumber, .onFault = On::kRepair, .low = 0, .high = 1e3},
};
const JsonRule kSpecularRules[] = {
    unitNumber("specularFactor"),
    {.key = "specularColorFactor",
     .is = Is::kNumbers,
     .onFault = On::kRepair,
     .low = 0,
     .high = 1e3,
     .length = 3},
    textureSlot("specularTexture"),
    textureSlot("specularColorTexture"),
};
const JsonRule kSheenRules[] = {
    unitNumbers("sheenColorFactor", 3),
    unitNumber("sheenRoughnessFactor"),
    textureSlot("sheenColorTexture"),
    textureSlot("sheenRoughnessTexture"),
};
const JsonRule kAnisotropyRules[] = {
    unitNumber("anisotropyStrength"),
    {.key = "anisotropyRotation",
     .is = Is::kNumber,
     .onFault = On::kRepair,
     .low = -1e6,
     .high = 1e6},
    textureSlot("anisotropyTexture"),
};
const JsonRule kTransmissionRules[] = {
    unitNumber("transmissionFactor"),
    textureSlot("transmissionTexture"),
};
const JsonRule kSpecularGlossinessRules[] = {
    unitNumbers("diffuseFactor", 4),          unitNumbers("specularFactor", 3),
    unitNumber("glossinessFactor"),           textureSlot("diffuseTexture"),
    textureSlot("specularGlossinessTexture"),
};
JsonRule materialExtension(std::string_view name, std::span<const JsonRule> members) {
    return {.key = name, .is = Is::kObject, .onFault = On::kRepair, .members = members};
}
const JsonRule kMaterialExtensionRules[] = {
    materialExtension("KHR_materials_anisotropy", kAnisotropyRules),
    materialExtension("KHR_materials_clearcoat", kClearcoatRules),
    materialExtension("KHR_materials_ior", kIorRules),
    materialExtension("KHR_materials_pbrSpecularGlossiness", kSpecularGlossinessRules),
    materialExtension("KHR_materials_sheen", kSheenRules),
    materialExtension("KHR_materials_specular", kSpecularRules),
    materialExtension("KHR_materials_transmission", kTransmissionRules),
    {.key = "KHR_materials_emissive_strength",
     .is = Is::kObject,
     .onFault = On::kRepair,
     .members = kEmissiveStrengthRules},
    {.key = "KHR_materials_unlit", .is = Is::kObject, .onFault = On::kRepair},
};
const JsonRule kMaterialRules[] = {
    kName,
    {.key = "pbrMetallicRoughness",
     .is = Is::kObject,
     .onFault = On::kRepair,
     .members = kMetallicRoughnessRules},
    textureSlot("normalTexture"),
    textureSlot("occlusionTexture"),
    textureSlot("emissiveTexture"),
    unitNumbers("emissiveFactor", 3),
    {.key = "alphaMode",
     .is = Is::kString,
     .onFault = On::kRepair,
     .words = {"OPAQUE", "MASK", "BLEND"}},
    {.key = "alphaCutoff", .is = Is::kNumber, .onFault = On::kRepair, .low = 0, .high = 1e6},
    {.key = "doubleSided", .is = Is::kBool, .onFault = On::kRepair},
    {.key = "extensions",
     .is = Is::kObject,
     .onFault = On::kRepair,
     .members = kMaterialExtensionRules},
};

const JsonRule kTextureObjectRules[] = {
    kName,
    kExtensions,
    {.key = "sampler", .is = Is::kIndex, .onFault = On::kRepair, .into = "samplers"},
    {.key = "source", .is = Is::kIndex, .onFault = On::kRepair, .into = "images"},
};
const std::vector<int> kWrap = {33071, 33648, 10497};
const JsonRule kSamplerRules[] = {
    kName,
    {.key = "magFilter", .is = Is::kInteger, .onFault = On::kRepair, .values = {9728, 9729}},
    {.key = "minFilter",
     .is = Is::kInteger,
     .onFault = On::kRepair,
     .values = {9728, 9729, 9984, 9985, 9986, 9987}},
    {.key = "wrapS", .is = Is::kInteger, .onFault = On::kRepair, .values = kWrap},
    {.key = "wrapT", .is = Is::kInteger, .onFault = On::kRepair, .values = kWrap},
};
const JsonRule kImageRules[] = {
    kName,
    {.key = "uri", .is = Is::kString, .onFault = On::kRepair},
    {.key = "bufferView", .is = Is::kIndex, .onFault = On::kRepair, .into = "bufferViews"},
    {.key = "mimeType", .is = Is::kString, .onFault = On::kRepair},
};

const JsonRule kPerspectiveRules[] = {
    {.key = "aspectRatio", .is = Is::kNumber, .onFault = On::kRepair},
    {.key = "yfov", .is = Is::kNumber, .onFault = On::kRepair, .required = true},
    {.key = "zfar", .is = Is::kNumber, .onFault = On::kRepair},
    {.key = "znear", .is = Is::kNumber, .onFault = On::kRepair, .required = true},
};
const JsonRule kOrthographicRules[] = {
    {.key = "xmag", .is = Is::kNumber, .onFault = On::kRepair, .required = true},
    {.key = "ymag", .is = Is::kNumber, .onFault = On::kRepair, .required = true},
    {.key = "zfar", .is = Is::kNumber, .onFault = On::kRepair, .required = true},
    {.key = "znear", .is = Is::kNumber, .onFault = On::kRepair, .required = true},
};
const JsonRule kCameraRules[] = {
    kName,
    {.key = "type", .is = Is::kString, .required = true, .words = {"perspective", "orthographic"}},
    {.key = "perspective", .is = Is::kObject, .members = kPerspectiveRules},
    {.key = "orthographic", .is = Is::kObject, .members = kOrthographicRules},
};

const JsonRule kGltfRules[] = {
    kExtensions,
    {.key = "asset", .is = Is::kObject, .required = true, .members = kAssetRules},
    {.key = "extensionsUsed", .is = Is::kStrings, .onFault = On::kRepair},
    {.key = "extensionsRequired", .is = Is::kStrings},
    // What is pointed into comes before what points.
    {.key = "buffers", .is = Is::kObjects, .members = kBufferRules},
    {.key = "bufferViews", .is = Is::kObjects, .members = kBufferViewRules},
    {.key = "accessors", .is = Is::kObjects, .members = kAccessorRules},
    {.key = "images", .is = Is::kObjects, .members = kImageRules},
    {.key = "samplers", .is = Is::kObjects, .members = kSamplerRules},
    {.key = "textures", .is = Is::kObjects, .members = kTextureObjectRules},
    {.key = "materials", .is = Is::kObjects, .members = kMaterialRules},
    {.key = "meshes", .is = Is::kObjects, .members = kMeshRules},
    {.key = "cameras", .is = Is::kObjects, .members = kCameraRules},
    {.key = "nodes", .is = Is::kObjects, .members = kNodeRules},
    {.key = "scenes", .is = Is::kObjects, .members = kSceneRules},
    {.key = "scene", .is = Is::kIndex, .onFault = On::kRepair, .into = "scenes"},
};

const JsonRule kSpotRules[] = {
    {.key = "innerConeAngle", .is = Is::kNumber, .onFault = On::kRepair, .low = 0, .high = kPi / 2},
    {.key = "outerConeAngle", .is = Is::kNumber, .onFault = On::kRepair, .low = 0, .high = kPi / 2},
};
const JsonRule kLightRules[] = {
    kName,
    {.key = "type", .is = Is::kString, .required = true, .words = {"directional", "point", "spot"}},
    {.key = "color",
     .is = Is::kNumbers,
     .onFault = On::kRepair,
     .low = 0,
     .high = kMaxLampColor,
     .length = 3},
    {.key = "intensity",
     .is = Is::kNumber,
     .onFault = On::kRepair,
     .low = 0,
     .high = kMaxLampIntensity},
    {.key = "range", .is = Is::kNumber, .onFault = On::kRepair},
    {.key = "spot", .is = Is::kObject, .onFault = On::kRepair, .members = kSpotRules},
};

const JsonRule kSkinRules[] = {
    kName,
    {.key = "inverseBindMatrices", .is = Is::kIndex, .onFault = On::kRepair, .into = "accessors"},
    {.key = "skeleton", .is = Is::kIndex, .onFault = On::kRepair, .into = "nodes"},
    {.key = "joints", .is = Is::kIndices, .required = true, .into = "nodes"},
};

const JsonRule kAnimationSamplerRules[] = {
    {.key = "input", .is = Is::kIndex, .required = true, .into = "accessors"},
    {.key = "output", .is = Is::kIndex, .required = true, .into = "accessors"},
    {.key = "interpolation", .is = Is::kString, .words = {"STEP", "LINEAR", "CUBICSPLINE"}},
};
const JsonRule kAnimationTargetRules[] = {
    {.key = "node", .is = Is::kIndex, .into = "nodes"},
    {.key = "path", .is = Is::kString, .required = true},
};
const JsonRule kAnimationChannelRules[] = {
    {.key = "sampler", .is = Is::kInteger, .required = true, .low = 0},
    {.key = "target", .is = Is::kObject, .required = true, .members = kAnimationTargetRules},
};

}  // namespace

std::span<const JsonRule> gltfRules() {
    return kGltfRules;
}

std::span<const JsonRule> lightRules() {
    return kLightRules;
}

std::span<const JsonRule> skinRules() {
    return kSkinRules;
}

std::span<const JsonRule> animationSamplerRules() {
    return kAnimationSamplerRules;
}

std::span<const JsonRule> animationChannelRules() {
    return kAnimationChannelRules;
}

}  // namespace ribalta::gltf
