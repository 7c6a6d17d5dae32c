#include "look/apply_look.h"

#include <algorithm>
#include <utility>

#include "base/read_file.h"
#include "image/read_image.h"
#include "scene/animation.h"

namespace ribalta {
namespace {

double& intensityIn(SpotLight& spot) {
    return spot.intensityCandela;
}

double& intensityIn(PointLight& point) {
    return point.intensityCandela;
}

double& intensityIn(DirectionalLight& light) {
    return light.illuminanceLux;
}

// A lamp changed but for its intensity and colour.
struct ChangeRest {
    const LampChange& change;
    LookLightMaps& lightMaps;
    Scene& scene;

    void operator()(PointLight& point) const {
        point.position = change.frame ? change.frame->position : point.position;
    }
    void operator()(DirectionalLight& light) const {
        light.direction = change.frame ? change.frame->forward() : light.direction;
    }
    void operator()(SpotLight& spot) const {
        spot.frame = change.frame.value_or(spot.frame);
        spot.outerConeAngle = change.outerConeAngle.value_or(spot.outerConeAngle);
        spot.innerConeAngle =
            std::min(change.innerConeAngle.value_or(spot.innerConeAngle), spot.outerConeAngle);
        changeLightMap(spot);
    }
    void changeLightMap(SpotLight& spot) const {
        if (change.lightMap.file && change.lightMap.file->empty()) {
            spot.lightMap.reset();
        } else if (change.lightMap.file) {
            const int image = lightMaps.use(*change.lightMap.file, scene);
            spot.lightMap = LightMap{image, spot.lightMap ? spot.lightMap->rotationRadians : 0.0};
        }
        if (spot.lightMap && change.lightMap.rotationRadians) {
            spot.lightMap->rotationRadians = *change.lightMap.rotationRadians;
        }
    }
};

void change(const LampId& lamp, const LampChange& change, LookLightMaps& lightMaps, Scene& scene) {
    visitLamp(scene, lamp, [&](auto& each) {
        intensityIn(each) = change.intensity.value_or(intensityIn(each));
        each.color = change.color.value_or(each.color);
    });
    visitLamp(scene, lamp, ChangeRest{change, lightMaps, scene});
}

}  // namespace

bool LampChange::isIdle() const {
    LampChange idle;
    idle.name = name;
    idle.number = number;
    return *this == idle;
}

std::vector<LampId> lampsOf(const Scene& scene) {
    std::vector<LampId> lamps;
    std::map<std::string, int> count;
    const auto add = [&](LampId::Kind kind, const auto& list) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            lamps.push_back({kind, int(i), list[i].name, count[list[i].name]++});
        }
    };
    add(LampId::Kind::kSpot, scene.spotLights);
    add(LampId::Kind::kPoint, scene.pointLights);
    add(LampId::Kind::kDirectional, scene.directionalLights);
    return lamps;
}

const LampChange* findChange(const std::vector<LampChange>& changes, const LampId& lamp) {
    const auto found = std::find_if(changes.begin(), changes.end(),
                                    [&](const LampChange& change) { return lamp.is(change); });
    return found == changes.end() ? nullptr : &*found;
}

LampChange& findOrAddChange(std::vector<LampChange>& changes, const LampId& lamp) {
    const LampChange* found = findChange(changes, lamp);
    if (found != nullptr) {
        return changes[std::size_t(found - changes.data())];
    }
    LampChange change;
    change.name = lamp.name;
    change.number = lamp.number;
    return changes.emplace_back(std::move(change));
}

double intensityOf(const Scene& scene, const LampId& lamp) {
    return visitLamp(scene, lamp, [](auto each) { return intensityIn(each); });
}

int LookLightMaps::use(const std::filesystem::path& file, Scene& scene) {
    if (const auto found = images_.find(file); found != images_.end()) {
        return found->second;
    }
    Image image = decodeImage(readFile(file), Place{file.string(), ""});
    image.name = file.filename().string();
    scene.images.push_back(std::move(image));
    const auto index = int(scene.images.size()) - 1;
    images_.emplace(file, index);
    return index;
}

void LookLightMaps::reload(const std::filesystem::path& file, Scene& scene) {
    const auto found = images_.find(file);
    const int old = found == images_.end() ? -1 : found->second;
    if (old >= 0) {
        images_.erase(found);
    }
    try {
        use(file, scene);
    } catch (...) {
        if (old >= 0) {
            images_.emplace(file, old);
        }
        throw;
    }
    if (old >= 0) {
        scene.images[std::size_t(old)].pixels = {};
    }
}

std::vector<std::filesystem::path> LookLightMaps::files() const {
    std::vector<std::filesystem::path> files;
    for (const auto& [file, image] : images_) {
        files.push_back(file);
    }
    return files;
}

void applyLamps(const std::vector<LampChange>& changes, LookLightMaps& lightMaps, Scene& scene) {
    const std::vector<LampId> lamps = lampsOf(scene);
    const bool anySolo = std::any_of(lamps.begin(), lamps.end(), [&](const LampId& lamp) {
        const LampChange* found = findChange(changes, lamp);
        return found != nullptr && found->solo;
    });
    for (const LampId& lamp : lamps) {
        const LampChange* found = findChange(changes, lamp);
        if (found != nullptr) {
            change(lamp, *found, lightMaps, scene);
        }
        const bool isOff = found != nullptr && found->off;
        const bool isSolo = found != nullptr && found->solo;
        if (isOff || (anySolo && !isSolo)) {
            visitLamp(scene, lamp, [](auto& each) { intensityIn(each) = 0.0; });
        }
    }
}

int animationOf(const std::optional<LookTime>& time, const Scene& scene) {
    if (time && !time->animation.empty()) {
        for (std::size_t i = 0; i < scene.animations.size(); ++i) {
            if (scene.animations[i].name == time->animation) {
                return int(i);
            }
        }
    }
    return kAllAnimations;
}

bool poseAt(const std::optional<LookTime>& time, Scene& scene) {
    if (!time) {
        restScene(scene);
        return true;
    }
    const int played = animationOf(time, scene);
    poseScene(scene, time->seconds, played);
    return knowsAnimation(*time, scene);
}

bool knowsAnimation(const LookTime& time, const Scene& scene) {
    return time.animation.empty() || animationOf(time, scene) != kAllAnimations;
}

std::vector<std::string> lampsNotThere(const std::vector<LampChange>& changes, const Scene& scene) {
    const std::vector<LampId> lamps = lampsOf(scene);
    std::vector<std::string> missing;
    for (const LampChange& change : changes) {
        const bool there = std::any_of(lamps.begin(), lamps.end(),
                                       [&](const LampId& lamp) { return lamp.is(change); });
        if (!there) {
            missing.push_back(change.number == 0 ? change.name
                                                 : change.name + " (number " +
                                                       std::to_string(change.number) + ")");
        }
    }
    return missing;
}

}  // namespace ribalta
