#include "gltf/read_light.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "gltf/tally.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

// A lamp of the file: the light it is, the node it hangs on.
struct Lamp {
    const json& light;
    Place lightPlace;
    const FileNode& node;
    Place nodePlace;
};

// A custom property of a lamp: the light's own before its node's. Null where neither has it.
struct Property {
    const json& value;
    Place place;
};

Property propertyOf(const Lamp& lamp, const char* key) {
    const json& ofLight = member(member(lamp.light, "extras"), key);
    if (!ofLight.is_null()) {
        return {ofLight, lamp.lightPlace.at("extras").at(key)};
    }
    return {member(lamp.node.other("extras"), key), lamp.nodePlace.at("extras").at(key)};
}

std::string nameOf(const Lamp& lamp, const std::string& otherwise) {
    if (!lamp.node.name.empty()) {
        return std::string(lamp.node.name);
    }
    const json& name = member(lamp.light, "name");
    return name.is_string() && !name.get_ref<const std::string&>().empty() ? name.get<std::string>()
                                                                           : otherwise;
}

glm::vec3 colorOf(const Lamp& lamp) {
    const json& color = member(lamp.light, "color");
    return color.is_null()
               ? glm::vec3(1.0F)
               : glm::vec3(color[0].get<float>(), color[1].get<float>(), color[2].get<float>());
}

double rangeOf(const Lamp& lamp) {
    return numberOr(lamp.light, "range", std::numeric_limits<double>::infinity());
}

std::optional<int> lightMapImage(const Property& property, const Import& import, ImageTable& images,
                                 TextureTable& textures, Report& report) {
    const json& value = property.value;
    if (value.is_string() && !value.get_ref<const std::string&>().empty()) {
        return images.useFile(value.get<std::string>(), property.place, report);
    }
    const json& texture = member(value, "texture");
    if (texture.is_number_integer()) {
        if (texture >= 0 && texture < import.model.textures.size()) {
            const int image = textures.useImageOf(texture.get<std::size_t>());
            if (image >= 0) {
                return image;
            }
        }
        report.ignored(property.place.at("texture"),
                       "is " + texture.dump() +
                           ", no texture with an image in this file; the "
                           "lamp is drawn without a light map");
        return std::nullopt;
    }
    report.ignored(property.place,
                   "is neither the path of a picture nor {\"texture\": index}; the lamp is drawn "
                   "without a light map");
    return std::nullopt;
}

double rotationOf(const Lamp& lamp, Report& report) {
    const Property rotation = propertyOf(lamp, "light_map_rotation");
    if (rotation.value.is_null()) {
        return 0.0;
    }
    if (!rotation.value.is_number() || std::abs(rotation.value.get<double>()) > 1e9) {
        report.ignored(rotation.place, "is no angle in degrees; 0 is used");
        return 0.0;
    }
    return rotation.value.get<double>() * std::numbers::pi / 180.0;
}

BeamShape beamShapeOf(const Lamp& lamp, Report& report) {
    const Property shape = propertyOf(lamp, "beam_shape");
    if (shape.value == "pyramid") {
        return BeamShape::kPyramid;
    }
    if (!shape.value.is_null() && shape.value != "cone") {
        report.ignored(shape.place, R"(is neither "cone" nor "pyramid"; a cone is drawn)");
    }
    return BeamShape::kCone;
}

// `light_map` before its other name; both may be on the light or on the node.
std::optional<Property> lightMapOf(const Lamp& lamp) {
    const std::pair<const json&, const Place&> holders[] = {
        {member(lamp.light, "extras"), lamp.lightPlace},
        {lamp.node.other("extras"), lamp.nodePlace},
    };
    for (const auto& [extras, place] : holders) {
        for (const char* key : {"light_map", "gobo"}) {
            const json& value = member(extras, key);
            if (!value.is_null()) {
                return Property{value, place.at("extras").at(key)};
            }
        }
    }
    return std::nullopt;
}

void refuseLightMap(const Lamp& lamp, const std::string& kind, Report& report) {
    if (const auto property = lightMapOf(lamp)) {
        report.ignored(property->place,
                       "is on a " + kind + " light; light maps are drawn for spots only");
    }
}

}  // namespace

void addLamp(const Import& import, std::size_t gltfNode, int sceneNode, ImageTable& images,
             TextureTable& textures, Scene& scene, Report& report) {
    const FileNode& node = import.nodes[gltfNode];
    const json& use = node.extension(kLightsPunctual);
    if (use.is_null()) {
        return;
    }
    const Place nodePlace = import.file.at("nodes").at(gltfNode);
    const Place usePlace = nodePlace.at("extensions").at(kLightsPunctual).at("light");
    const json& index = member(use, "light");
    const json& lights = member(extension(import.json, kLightsPunctual), "lights");
    if (!index.is_number_integer() || index < 0 || index >= lights.size()) {
        report.ignored(usePlace, "is " + index.dump() + ", but the file has " +
                                     counted(lights.size(), "lights") + "; this lamp is left out");
        return;
    }
    const auto number = index.get<std::size_t>();
    if (lights[number].is_null()) {
        report.ignored(usePlace, "is light " + std::to_string(number) +
                                     ", which cannot be read; this lamp is left out");
        return;
    }
    const Lamp lamp{lights[number],
                    import.file.at("extensions").at(kLightsPunctual).at("lights").at(number), node,
                    nodePlace};
    const double intensity = numberOr(lamp.light, "intensity", 1.0);
    const auto defaultName = [](const char* kind, std::size_t count) {
        return std::string(kind) + "_" + std::to_string(count);
    };
    if (lamp.light["type"] == "spot") {
        SpotLight spot;
        spot.name = nameOf(lamp, defaultName("spot", scene.spotLights.size()));
        spot.node = sceneNode;
        spot.color = colorOf(lamp);
        spot.intensityCandela = intensity;
        spot.rangeMetres = rangeOf(lamp);
        spot.innerConeAngle = lamp.light["spot"]["innerConeAngle"].get<double>();
        spot.outerConeAngle = lamp.light["spot"]["outerConeAngle"].get<double>();
        spot.beamShape = beamShapeOf(lamp, report);
        const double rotation = rotationOf(lamp, report);
        if (const auto property = lightMapOf(lamp)) {
            if (const auto image = lightMapImage(*property, import, images, textures, report)) {
                spot.lightMap = LightMap{*image, rotation};
            }
        }
        scene.spotLights.push_back(std::move(spot));
    } else if (lamp.light["type"] == "point") {
        refuseLightMap(lamp, "point", report);
        PointLight point;
        point.name = nameOf(lamp, defaultName("point", scene.pointLights.size()));
        point.node = sceneNode;
        point.color = colorOf(lamp);
        point.intensityCandela = intensity;
        point.rangeMetres = rangeOf(lamp);
        scene.pointLights.push_back(std::move(point));
    } else {
        refuseLightMap(lamp, "directional", report);
        DirectionalLight sun;
        sun.name = nameOf(lamp, defaultName("directional", scene.directionalLights.size()));
        sun.node = sceneNode;
        sun.color = colorOf(lamp);
        sun.illuminanceLux = intensity;
        scene.directionalLights.push_back(std::move(sun));
    }
}

}  // namespace ribalta::gltf
