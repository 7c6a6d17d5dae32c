#include "gltf/bind_dials.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

namespace ribalta::gltf {
namespace {

using nlohmann::json;
using Owner = PointedAt::Owner;
using List = Dial::List;
using Numbers = Dial::Numbers;

constexpr int kUnbound = -2;
constexpr int kLeftOut = -1;

List listOf(const Import& import, const DialSource& source) {
    switch (source.owner) {
        case Owner::kNode:
            return List::kNodes;
        case Owner::kCamera:
            return List::kCameras;
        case Owner::kMaterial:
            return List::kMaterials;
        case Owner::kLight:
            break;
    }
    const json& type =
        member(extension(import.json, kLightsPunctual), "lights")[source.index]["type"];
    return type == "spot"    ? List::kSpotLights
           : type == "point" ? List::kPointLights
                             : List::kDirectionalLights;
}

// By the document's light, which of the scene's lamps it is; lamps of a light are of one kind.
using Lamps = std::map<std::size_t, std::vector<int>>;

template <typename Lamp>
void addLamps(const Import& import, const SceneUses& uses, const std::vector<Lamp>& lamps,
              Lamps& found) {
    for (std::size_t i = 0; i < lamps.size(); ++i) {
        const auto node = std::size_t(lamps[i].node);
        if (uses.isPunctual[node] != 0) {
            const json& use = import.nodes[uses.gltfNodes[node]].extension(kLightsPunctual);
            found[use["light"].get<std::size_t>()].push_back(int(i));
        }
    }
}

// Finds in the scene what is the document's.
class Owners {
  public:
    Owners(const Import& import, const SceneUses& uses, const Scene& scene) : uses_(uses) {
        addLamps(import, uses, scene.spotLights, lamps_);
        addLamps(import, uses, scene.pointLights, lamps_);
        addLamps(import, uses, scene.directionalLights, lamps_);
        for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
            const std::size_t node = uses.gltfNodes[std::size_t(scene.cameras[i].node)];
            cameras_[std::size_t(import.nodes[node].camera)].push_back(int(i));
        }
    }

    std::vector<int> find(const DialSource& source) const {
        const auto in = [&](const auto& map) {
            const auto found = map.find(source.index);
            return found == map.end() ? std::vector<int>() : found->second;
        };
        switch (source.owner) {
            case Owner::kNode:
                return {int(source.index)};
            case Owner::kLight:
                return in(lamps_);
            case Owner::kCamera:
                return in(cameras_);
            case Owner::kMaterial:
                break;
        }
        const int material = uses_.materials[source.index];
        return material < 0 ? std::vector<int>() : std::vector<int>{material};
    }

  private:
    const SceneUses& uses_;
    Lamps lamps_;
    std::map<std::size_t, std::vector<int>> cameras_;
};

template <typename Lamp>
glm::dvec4 restOfLamp(const Lamp& lamp, double intensity, Numbers numbers) {
    return numbers == Numbers::kColor ? glm::dvec4(glm::dvec3(lamp.color), 0.0)
                                      : glm::dvec4(intensity, 0.0, 0.0, 0.0);
}

glm::dvec4 restOfCamera(const Camera& camera, Numbers numbers) {
    if (numbers == Numbers::kDepth || numbers == Numbers::kBoxDepth) {
        return {camera.nearMetres, camera.farMetres, 0.0, 0.0};
    }
    if (const auto* box = std::get_if<OrthographicLens>(&camera.lens)) {
        return {box->halfWidth, box->halfHeight, 0.0, 0.0};
    }
    const auto& lens = std::get<PerspectiveLens>(camera.lens);
    return {numbers == Numbers::kFov ? lens.verticalFov : lens.aspectRatio.value_or(0.0), 0.0, 0.0,
            0.0};
}

glm::dvec4 restOfEmission(const json& material) {
    const json& factor = member(material, "emissiveFactor");
    glm::dvec4 rest(0.0);
    for (int c = 0; c < 3 && !factor.is_null(); ++c) {
        rest[c] = factor[std::size_t(c)].get<double>();
    }
    rest.w =
        numberOr(extension(material, "KHR_materials_emissive_strength"), "emissiveStrength", 1.0);
    return rest;
}

// As the scene has it of the first owner; all of them are read from one.
glm::dvec4 restOf(const Import& import, const DialSource& source, const Dial& dial,
                  const Scene& scene) {
    const auto owner = std::size_t(dial.owners.front());
    switch (dial.list) {
        case List::kNodes:
            return glm::dvec4(scene.nodes[owner].visible ? 1.0 : 0.0);
        case List::kSpotLights: {
            const SpotLight& lamp = scene.spotLights[owner];
            return dial.numbers == Numbers::kCone
                       ? glm::dvec4(lamp.innerConeAngle, lamp.outerConeAngle, 0.0, 0.0)
                   : dial.numbers == Numbers::kRange
                       ? glm::dvec4(lamp.rangeMetres, 0.0, 0.0, 0.0)
                       : restOfLamp(lamp, lamp.intensityCandela, dial.numbers);
        }
        case List::kPointLights: {
            const PointLight& lamp = scene.pointLights[owner];
            return dial.numbers == Numbers::kRange
                       ? glm::dvec4(lamp.rangeMetres, 0.0, 0.0, 0.0)
                       : restOfLamp(lamp, lamp.intensityCandela, dial.numbers);
        }
        case List::kDirectionalLights: {
            const DirectionalLight& lamp = scene.directionalLights[owner];
            return restOfLamp(lamp, lamp.illuminanceLux, dial.numbers);
        }
        case List::kCameras:
            return restOfCamera(scene.cameras[owner], dial.numbers);
        case List::kMaterials:
            break;
    }
    return dial.numbers == Numbers::kEmission
               ? restOfEmission(element(import.json, "materials", source.index))
               : glm::dvec4(scene.materials[owner].baseColor);
}

// The lowest and the highest value that one of a dial's numbers has at any key.
struct Span {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

// Of the first two numbers of every dial.
using Spans = std::vector<std::array<Span, 2>>;

Spans spansOf(const Scene& scene) {
    Spans spans(scene.dials.size());
    for (const Animation& animation : scene.animations) {
        for (const AnimationChannel& channel : animation.channels) {
            if (channel.part != AnimationChannel::Part::kDial) {
                continue;
            }
            auto& span = spans[std::size_t(channel.mover)];
            forEachKeyValue(animation.samplers[std::size_t(channel.sampler)],
                            [&](const glm::vec4& value) {
                                for (int c = 0; c < channel.count && channel.first + c < 2; ++c) {
                                    const int number = channel.first + c;
                                    span[std::size_t(number)].add(double(value[c]));
                                }
                            });
        }
    }
    for (std::size_t i = 0; i < spans.size(); ++i) {
        for (int c = 0; c < 2; ++c) {
            Span& span = spans[i][std::size_t(c)];
            if (span.low > span.high) {
                span.add(scene.dials[i].rest[c]);
            }
        }
    }
    return spans;
}

// Of pairs the first is to stay below the second, whatever the time.
void checkPair(const Dial& dial, const std::array<Span, 2>& spans, const Place& place,
               Report& report) {
    const bool isCone = dial.numbers == Numbers::kCone;
    if (!isCone && dial.numbers != Numbers::kDepth && dial.numbers != Numbers::kBoxDepth) {
        return;
    }
    if (spans[0].high >= spans[1].low) {
        report.hint(place, isCone ? "may let the inner cone reach the outer one, where the cone "
                                    "has a hard edge"
                                  : "may let the near plane reach the far one, where another far "
                                    "plane is used");
    }
}

}  // namespace

void bindDials(const Import& import, const std::vector<DialSource>& sources, const SceneUses& uses,
               Scene& scene, Report& report) {
    if (sources.empty()) {
        return;
    }
    const Owners owners(import, uses, scene);
    std::vector<int> dials(sources.size(), kUnbound);
    const auto bind = [&](std::size_t index) {
        const DialSource& source = sources[index];
        Dial dial;
        dial.numbers = source.numbers;
        dial.list = listOf(import, source);
        dial.owners = owners.find(source);
        if (dial.owners.empty()) {
            report.ignored(source.place,
                           "names what nothing in the drawn scene uses; its channels are left out");
            return kLeftOut;
        }
        dial.rest = restOf(import, source, dial, scene);
        dial.now = dial.rest;
        scene.dials.push_back(std::move(dial));
        return int(scene.dials.size()) - 1;
    };
    for (Animation& animation : scene.animations) {
        for (AnimationChannel& channel : animation.channels) {
            if (channel.part != AnimationChannel::Part::kDial) {
                continue;
            }
            const auto index = std::size_t(channel.mover);
            dials[index] = dials[index] == kUnbound ? bind(index) : dials[index];
            channel.mover = dials[index];
        }
        std::erase_if(animation.channels,
                      [](const AnimationChannel& channel) { return channel.mover == kLeftOut; });
    }
    const Spans spans = spansOf(scene);
    for (std::size_t i = 0; i < sources.size(); ++i) {
        if (dials[i] >= 0) {
            const auto dial = std::size_t(dials[i]);
            checkPair(scene.dials[dial], spans[dial], sources[i].place, report);
        }
    }
}

}  // namespace ribalta::gltf
