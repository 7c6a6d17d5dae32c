#include "gltf/check_extensions.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>

#include "gltf/bad_input.h"
#include "gltf/import.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

// And which file reads it.
constexpr std::string_view kSupported[] = {
    "EXT_lights_ies",                       // read_ies
    "EXT_lights_image_based",               // read_environment
    "EXT_mesh_gpu_instancing",              // add_instances
    "EXT_meshopt_compression",              // read_packed_views
    "EXT_texture_webp",                     // read_images
    "KHR_animation_pointer",                // animation_pointer
    "KHR_draco_mesh_compression",           // read_attributes
    "KHR_lights_punctual",                  // read_light
    "KHR_materials_anisotropy",             // read_layers
    "KHR_materials_clearcoat",              // read_layers
    "KHR_materials_emissive_strength",      // read_material
    "KHR_materials_ior",                    // read_layers
    "KHR_materials_pbrSpecularGlossiness",  // read_layers
    "KHR_materials_sheen",                  // read_layers
    "KHR_materials_specular",               // read_layers
    "KHR_materials_transmission",           // read_layers
    "KHR_materials_unlit",                  // read_material
    "KHR_materials_variants",               // choose_variant
    "KHR_mesh_quantization",                // read_accessor
    "KHR_node_visibility",                  // read_nodes
    "KHR_texture_transform",                // read_material
};

struct Version {
    int major = 0;
    int minor = 0;
};

// "2.0" and the like; nothing else is a version.
std::optional<Version> parseVersion(const std::string& text) {
    const std::size_t dot = text.find('.');
    const auto isNumber = [](std::string_view digits) {
        return !digits.empty() && digits.size() <= 4 &&
               std::all_of(digits.begin(), digits.end(),
                           [](char c) { return c >= '0' && c <= '9'; });
    };
    if (dot == std::string::npos || !isNumber(std::string_view(text).substr(0, dot)) ||
        !isNumber(std::string_view(text).substr(dot + 1))) {
        return std::nullopt;
    }
    return Version{std::stoi(text.substr(0, dot)), std::stoi(text.substr(dot + 1))};
}

void checkVersion(const json& asset, const char* key, const Place& place) {
    const json& value = member(asset, key);
    if (value.is_null()) {
        return;
    }
    if (!value.is_string()) {
        badInput(place.at(key), "is no string, expected a version such as \"2.0\"");
    }
    const auto& text = value.get_ref<const std::string&>();
    const std::optional<Version> version = parseVersion(text);
    if (!version) {
        badInput(place.at(key), "is \"" + text + "\", expected a version such as 2.0");
    }
    const bool isMinimum = std::string_view(key) == "minVersion";
    if (version->major != 2 || (isMinimum && version->minor > 0)) {
        badInput(place.at(key), "is " + text +
                                    (isMinimum ? ", but this program reads glTF 2.0"
                                               : ", but this program reads glTF 2") +
                                    "; export the scene as glTF 2.0");
    }
}

}  // namespace

bool isSupported(std::string_view extension) {
    return std::find(std::begin(kSupported), std::end(kSupported), extension) !=
           std::end(kSupported);
}

void checkVersionAndExtensions(const json& root, const Place& file) {
    const json& asset = member(root, "asset");
    if (!member(asset, "version").is_string()) {
        badInput(file.at("asset"), "lacks its \"version\", which every glTF has; export it again");
    }
    checkVersion(asset, "version", file.at("asset"));
    checkVersion(asset, "minVersion", file.at("asset"));
    const json& required = member(root, "extensionsRequired");
    for (std::size_t i = 0; required.is_array() && i < required.size(); ++i) {
        if (!required[i].is_string()) {
            badInput(file.at("extensionsRequired").at(i), "is no extension's name");
        }
        const auto& name = required[i].get_ref<const std::string&>();
        if (!isSupported(name)) {
            badInput(file.at("extensionsRequired").at(i),
                     "the file requires the extension " + name +
                         ", which is not supported; export it " +
                         (name == "KHR_texture_basisu" || name == "GOOGLE_texture_basis"
                              ? "with PNG, JPEG or WebP textures"
                              : "without"));
        }
    }
}

}  // namespace ribalta::gltf
