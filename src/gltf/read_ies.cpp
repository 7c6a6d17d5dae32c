#include "gltf/read_ies.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/read_file.h"
#include "gltf/bad_input.h"
#include "gltf/parse_ies.h"
#include "gltf/read_buffers.h"
#include "gltf/read_uri.h"
#include "gltf/tally.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

constexpr const char* kPhotometric = "EXT_lights_ies";
// The largest that are published have some hundred thousand values.
constexpr std::uint64_t kMaxFileBytes = 64'000'000;
constexpr double kMaxMultiplier = 1e9;
constexpr double kFadeFrom = kMaxConeAngle - 5.0 * std::numbers::pi / 180.0;

std::string percent(double share) {
    const std::string text = std::to_string(100.0 * share);
    return text.substr(0, text.find('.') + 2) + " %";
}

// Of a file beside the scene, its own name and line come first.
IesProfile readProfile(const Import& import, const json& source, const Place& place,
                       ImageTable& images) {
    const json& uri = member(source, "uri");
    const json& view = member(source, "bufferView");
    if (uri.is_string()) {
        const auto& text = uri.get_ref<const std::string&>();
        const Place here = place.at("uri");
        if (isDataUri(text)) {
            return parseIes(textOf(decodeDataUri(text, here)), here);
        }
        const std::filesystem::path file = images.find(text, here);
        images.noteFile(file);
        const std::uint64_t limit = std::min(kMaxFileBytes, import.budget->memoryLeft());
        try {
            return parseIes(textOf(readFile(file, limit)), {file.string(), ""});
        } catch (const Error& error) {
            badInput(here, error.what());
        }
    }
    if (view.is_number_integer() && view >= 0 && view < import.model.bufferViews.size()) {
        return parseIes(textOf(copyOfView(import, view.get<std::size_t>())), place);
    }
    badInput(place, "has neither a uri nor the index of a bufferView; export the file again");
}

double multiplierOf(const json& use, const Place& place, Report& report) {
    const json& multiplier = member(use, "multiplier");
    if (multiplier.is_null()) {
        return 1.0;
    }
    if (!multiplier.is_number() || !(multiplier.get<double>() >= 0.0) ||
        multiplier.get<double>() > kMaxMultiplier) {
        report.repaired(place.at("multiplier"), "is no number of 0 and more; 1 is used");
        return 1.0;
    }
    return multiplier.get<double>();
}

glm::vec3 colorOf(const json& use, const Place& place, Report& report) {
    const json& color = member(use, "color");
    if (color.is_null()) {
        return glm::vec3(1.0F);
    }
    const bool isColor = color.is_array() && color.size() == 3 &&
                         std::all_of(color.begin(), color.end(), [](const json& value) {
                             return value.is_number() && std::isfinite(value.get<double>());
                         });
    if (!isColor) {
        report.repaired(place.at("color"), "is no list of three numbers; white is used");
        return glm::vec3(1.0F);
    }
    glm::vec3 result;
    for (int c = 0; c < 3; ++c) {
        result[c] = float(std::clamp(color[std::size_t(c)].get<double>(), 0.0, 1.0));
    }
    return result;
}

}  // namespace

const std::optional<IesLamps::Profile>& IesLamps::profile(std::size_t index, ImageTable& images,
                                                          Report& report) {
    const auto [entry, isNew] = profiles_.try_emplace(index);
    if (!isNew) {
        return entry->second;
    }
    const Place place = import_.file.at("extensions").at(kPhotometric).at("lights").at(index);
    const json& source = member(extension(import_.json, kPhotometric), "lights")[index];
    try {
        const IesProfile profile = readProfile(import_, source, place, images);
        for (const std::string& remark : profile.remarks) {
            report.ignored(place, remark);
        }
        import_.budget->takeMemory(std::uint64_t(kWebMapSide) * kWebMapSide * 16, place);
        ProjectedWeb projected = projectWeb(profile.web);
        constexpr double kWorthTelling = 0.01;
        if (projected.lostShare > kWorthTelling) {
            report.ignored(place, "sends " + percent(projected.lostShare) +
                                      " of its light farther than 80 degrees off its axis, where "
                                      "spots are not drawn");
        }
        const json& name = member(source, "name");
        projected.lightMap.name = name.is_string() && !name.get_ref<const std::string&>().empty()
                                      ? name.get<std::string>()
                                      : "ies_" + std::to_string(index);
        const int image =
            images.useMade("ies " + std::to_string(index), std::move(projected.lightMap));
        entry->second = Profile{projected.halfAngle, projected.candela, image};
    } catch (const LimitError&) {
        throw;
    } catch (const Error& error) {
        report.ignored(error.place(), reasonOf(error) + "; the lamps that use it are left out");
    }
    return entry->second;
}

bool IesLamps::add(std::size_t gltfNode, int sceneNode, ImageTable& images, Scene& scene,
                   Report& report) {
    const FileNode& node = import_.nodes[gltfNode];
    const json& use = node.extension(kPhotometric);
    if (use.is_null()) {
        return false;
    }
    const Place nodePlace = import_.file.at("nodes").at(gltfNode);
    const Place place = nodePlace.at("extensions").at(kPhotometric);
    const json& index = member(use, "light");
    const json& lights = member(extension(import_.json, kPhotometric), "lights");
    const std::size_t count = lights.is_array() ? lights.size() : 0;
    if (!index.is_number_integer() || index < 0 || index >= count) {
        report.ignored(place.at("light"), "is " + index.dump() + ", but the file has " +
                                              counted(count, "light profiles") +
                                              "; this lamp is left out");
        return false;
    }
    const std::optional<Profile>& its = profile(index.get<std::size_t>(), images, report);
    if (!its) {
        return false;
    }
    if (!node.extension(kLightsPunctual).is_null()) {
        report.hint(nodePlace.at("extensions").at(kLightsPunctual),
                    "stands on a node with a light profile, which is drawn in its place");
    }
    SpotLight spot;
    spot.name = !node.name.empty() ? std::string(node.name)
                                   : "ies_" + std::to_string(scene.spotLights.size());
    spot.node = sceneNode;
    spot.color = colorOf(use, place, report);
    spot.intensityCandela = its->candela * multiplierOf(use, place, report);
    spot.outerConeAngle = its->halfAngle;
    // Where the web goes on past the cone it fades over the last degrees, not to end in a line.
    spot.innerConeAngle = its->halfAngle < kMaxConeAngle ? its->halfAngle : kFadeFrom;
    spot.lightMap = LightMap{its->image, 0.0};
    scene.spotLights.push_back(std::move(spot));
    return true;
}

}  // namespace ribalta::gltf
