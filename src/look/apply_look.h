// A look brought to a scene: lamps are found by name, light maps are read.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "look/look.h"
#include "scene/scene.h"

namespace ribalta {

/// A lamp of a scene, whatever its kind, and the name that looks know it by.
struct LampId {
    enum class Kind { kSpot, kPoint, kDirectional };
    Kind kind = Kind::kSpot;
    int index = 0;  ///< into the scene's lamps of that kind
    std::string name;
    int number = 0;  ///< which of the lamps of that name, counted from 0

    bool is(const LampChange& change) const {
        return change.name == name && change.number == number;
    }
};

/// Calls `visit` with the lamp itself: a SpotLight, PointLight or DirectionalLight of the scene,
/// constant where the scene is.
template <typename SceneOrConst, typename Visit>
decltype(auto) visitLamp(SceneOrConst& scene, const LampId& lamp, Visit&& visit) {
    const auto index = std::size_t(lamp.index);
    switch (lamp.kind) {
        case LampId::Kind::kSpot:
            return visit(scene.spotLights[index]);
        case LampId::Kind::kPoint:
            return visit(scene.pointLights[index]);
        case LampId::Kind::kDirectional:
            break;
    }
    return visit(scene.directionalLights[index]);
}

/// What is changed of a lamp, null where nothing is; and the same, made where there is none.
const LampChange* findChange(const std::vector<LampChange>& changes, const LampId& lamp);
LampChange& findOrAddChange(std::vector<LampChange>& changes, const LampId& lamp);

/// All lamps: spots, then point lights, then directional ones.
std::vector<LampId> lampsOf(const Scene& scene);

/// What it gives, in candela, or in lux where it is directional.
double intensityOf(const Scene& scene, const LampId& lamp);

/// Pictures that looks give to lamps; each file is read once and becomes an image of the scene.
class LookLightMaps {
  public:
    /// Index into the scene's images. Throws Error(kBadInput) that names the file.
    int use(const std::filesystem::path& file, Scene& scene);
    bool uses(const std::filesystem::path& file) const { return images_.contains(file); }
    /// Reads a file anew, into another image of the scene, which is to be brought to the lamps
    /// next. Throws as use() does; the old image is kept then.
    void reload(const std::filesystem::path& file, Scene& scene);
    /// The files in use.
    std::vector<std::filesystem::path> files() const;

  private:
    std::map<std::filesystem::path, int> images_;
};

/// Changes the scene's lamps; to be called anew from the scene as it was loaded or posed. Throws
/// Error(kBadInput) where a light map cannot be read; the lamps before it are changed then.
void applyLamps(const std::vector<LampChange>& changes, LookLightMaps& lightMaps, Scene& scene);

/// The animation that is played: an index into the scene's, or kAllAnimations, also where it has
/// none of that name.
int animationOf(const std::optional<LookTime>& time, const Scene& scene);

/// Whether the scene has the animation that is named, if one is.
bool knowsAnimation(const LookTime& time, const Scene& scene);

/// Poses what is animated as the look has it, or puts it to rest. False where the look names an
/// animation that the scene does not have: all of them are played then.
bool poseAt(const std::optional<LookTime>& time, Scene& scene);

/// The changes whose lamp the scene does not have, as "name" or "name (number 2)".
std::vector<std::string> lampsNotThere(const std::vector<LampChange>& changes, const Scene& scene);

}  // namespace ribalta
