#include "sweep_plan.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>
#include <utility>

#include <CLI/CLI.hpp>

#include "base/content_hash.h"
#include "base/error.h"
#include "base/log.h"
#include "base/read_file.h"
#include "load_scene.h"
#include "measure/pessoa2007.h"
#include "measure/scene_hash.h"
#include "parse_number.h"

namespace ribalta {
namespace {

constexpr int kMaxPlanes = 65536;
constexpr std::size_t kMaxCounts = 256;
constexpr std::size_t kMaxPoints = 100000;

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::size_t at = 0;
    for (std::size_t end = 0; end != std::string::npos; at = end + 1) {
        end = text.find(separator, at);
        parts.push_back(text.substr(at, end == std::string::npos ? end : end - at));
    }
    return parts;
}

[[noreturn]] void refusePlanes(const std::string& text) {
    throw CLI::ValidationError("--planes",
                               "'" + text +
                                   "' is not FIRST:LAST[:STEP or :FACTORx] or a list by comma, "
                                   "counts in 1..65536 that rise, at most 256 of them");
}

int planeCount(const std::string& part, const std::string& text) {
    const std::optional<int> count = parseNumber<int>(part);
    if (!count || *count < 1 || *count > kMaxPlanes) {
        refusePlanes(text);
    }
    return *count;
}

std::vector<int> planeRange(const std::vector<std::string>& parts, const std::string& text) {
    const int first = planeCount(parts[0], text);
    const int last = planeCount(parts[1], text);
    const std::string step = parts.size() > 2 ? parts[2] : "2x";
    const bool isFactor = step.ends_with('x');
    const auto by = parseNumber<double>(isFactor ? step.substr(0, step.size() - 1) : step);
    if (parts.size() > 3 || last < first || !by || (isFactor && *by < 1.01) ||
        (!isFactor && (*by < 1.0 || *by != std::floor(*by)))) {
        refusePlanes(text);
    }
    std::vector<int> counts;
    for (double value = first; value <= last + 1e-6; value = isFactor ? value * *by : value + *by) {
        const int count = int(std::lround(value));
        if (counts.empty() || count > counts.back()) {
            counts.push_back(count);
        }
        if (counts.size() > kMaxCounts) {
            refusePlanes(text);
        }
    }
    return counts;
}

/// A camera of a scene under the name that records give it.
struct NamedCamera {
    std::string name;
    Camera camera;
};

// Records tell cameras by it, so where several have one name each gets its number too.
std::string cameraName(const Scene& scene, std::size_t index) {
    const std::string& name = scene.cameras[index].name;
    if (name.empty()) {
        return std::to_string(index);
    }
    const auto namesakes = std::count_if(scene.cameras.begin(), scene.cameras.end(),
                                         [&](const Camera& camera) { return camera.name == name; });
    return oneLine(name) + (namesakes > 1 ? "#" + std::to_string(index) : "");
}

// The wanted cameras that the scene has, each once; `found` notes which of the wanted there were.
std::vector<NamedCamera> camerasOf(const Scene& scene, const std::vector<std::string>& wanted,
                                   double aspectRatio, std::set<std::string>& found) {
    std::vector<NamedCamera> cameras;
    if (wanted.empty()) {
        const Camera camera = chooseCamera(scene, std::nullopt, aspectRatio);
        return {{scene.cameras.empty() ? "framed" : cameraName(scene, 0), camera}};
    }
    std::set<std::size_t> taken;
    for (const std::string& name : wanted) {
        for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
            if (name == "all" || scene.cameras[i].name == name || std::to_string(i) == name) {
                found.insert(name);
                if (taken.insert(i).second) {
                    cameras.push_back({cameraName(scene, i), scene.cameras[i]});
                }
            }
        }
    }
    return cameras;
}

std::string listCameras(const Scene& scene) {
    std::string list;
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
        list += i == 0 ? "" : ", ";
        list += cameraName(scene, i);
    }
    return list.empty() ? "none" : list;
}

// All settings of one view, method by method.
std::vector<SweepPoint> pointsOfView(const SweepGrid& grid, const PictureSize& size) {
    std::vector<SweepPoint> points;
    if (grid.pessoa2007) {
        for (const ThesisFigure& figure : thesisFigures()) {
            for (const BeamMethod method : grid.methods) {
                points.push_back({"", "", figure.label,
                                  thesisSettings(figure, method, size.width, size.height)});
            }
        }
        return points;
    }
    const auto addSeries = [&](BeamSettings beams) {
        for (const int planes : grid.planes) {
            SweepPoint point{"", "", "", grid.settings};
            point.settings.width = size.width;
            point.settings.height = size.height;
            point.settings.beams = beams;
            point.settings.beams.planes = planes;
            points.push_back(std::move(point));
        }
    };
    for (const BeamMethod method : grid.methods) {
        BeamSettings beams;
        beams.method = method;
        if (method != BeamMethod::kAdaptive || grid.tolerances.empty()) {
            addSeries(beams);
            continue;
        }
        for (const double tolerance : grid.tolerances) {
            beams.tolerance = tolerance;
            addSeries(beams);
        }
    }
    return points;
}

}  // namespace

std::vector<int> parsePlaneCounts(const std::string& text) {
    const std::vector<std::string> range = split(text, ':');
    if (range.size() > 1) {
        return planeRange(range, text);
    }
    std::set<int> counts;
    for (const std::string& part : split(text, ',')) {
        counts.insert(planeCount(part, text));
    }
    if (counts.size() > kMaxCounts) {
        refusePlanes(text);
    }
    return {counts.begin(), counts.end()};
}

std::vector<BeamMethod> parseMethods(const std::string& text) {
    std::vector<BeamMethod> methods;
    if (text == "all") {
        for (const Named<BeamMethod>& each : beamMethods()) {
            methods.push_back(each.value);
        }
        return methods;
    }
    for (const std::string& part : split(text, ',')) {
        const std::optional<BeamMethod> method = valueIn(beamMethods(), part);
        if (!method) {
            throw CLI::ValidationError(
                "--beams", "'" + part + "' is none of the methods: all, " + listOf(beamMethods()));
        }
        if (std::find(methods.begin(), methods.end(), *method) == methods.end()) {
            methods.push_back(*method);
        }
    }
    return methods;
}

std::vector<double> parseTolerances(const std::string& text) {
    std::vector<double> tolerances;
    for (const std::string& part : text.empty() ? std::vector<std::string>() : split(text, ',')) {
        const std::optional<double> tolerance = parseNumber<double>(part);
        if (!tolerance || !(*tolerance >= 0.0 && *tolerance <= 1.0)) {
            throw CLI::ValidationError("--tolerance", "'" + part + "' is not a number in 0..1");
        }
        if (std::find(tolerances.begin(), tolerances.end(), *tolerance) == tolerances.end()) {
            tolerances.push_back(*tolerance);
        }
    }
    return tolerances;
}

std::vector<PictureSize> parseSizes(const std::string& text) {
    std::vector<PictureSize> sizes;
    for (const std::string& part : split(text, ',')) {
        const PictureSize size = parseSize(part);
        const bool isNew = std::none_of(sizes.begin(), sizes.end(), [&](const PictureSize& other) {
            return other.width == size.width && other.height == size.height;
        });
        if (isNew) {
            sizes.push_back(size);
        }
    }
    return sizes;
}

void refuseNamesakes(const std::vector<std::string>& paths) {
    std::set<std::string> names;
    for (const std::string& path : paths) {
        const std::string name = std::filesystem::path(path).stem().string();
        if (!names.insert(name).second) {
            throw Error(
                ErrorKind::kUsage, {path, ""},
                "is the second scene called '" + name +
                    "', and records tell scenes by their names; give it once, or rename it");
        }
    }
}

namespace {

// The look's own bytes go into the hash: what it says of lamps is part of what is measured.
void bringLook(const LookOptions& options, SweepScene& scene) {
    const Look look = options.read();
    if (!poseAt(look.time, scene.loaded->scene)) {
        logWarning("look: the scene has no animation '" + oneLine(look.time->animation) +
                   "'; all of them are at its moment");
    }
    const BroughtLook brought(look, *scene.loaded);
    ContentHash hash;
    hash.add(scene.hash);
    const std::vector<std::byte> bytes = readFile(*options.file);
    hash.add(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    scene.hash = hash.text();
}

}  // namespace

SweepScene loadSweepScene(const std::string& path, const LoadOptions& options,
                          const LookOptions& look) {
    SweepScene scene;
    scene.path = path;
    try {
        scene.loaded = loadScene(path, options);
        scene.hash = hashScene(readFile(path), scene.loaded->scene);
        if (options.scene) {
            // What hangs in it is all the same, and only stands elsewhere.
            scene.hash += "-" + std::to_string(scene.loaded->sceneIndex);
        }
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::kUsage) {
            throw;
        }
        scene.loaded.reset();
        scene.wrong = error.what();
    }
    if (scene.loaded && look.file) {
        bringLook(look, scene);
    }
    return scene;
}

SweepPlan planSweep(std::vector<SweepScene> scenes, const SweepGrid& grid) {
    SweepPlan plan;
    std::set<std::string> found;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const SweepScene& scene = scenes[i];
        for (const PictureSize& size : grid.sizes) {
            std::vector<NamedCamera> cameras;
            if (scene.loaded) {
                cameras = grid.ownCamera && grid.cameras.empty()
                              ? std::vector<NamedCamera>{{"look", *grid.ownCamera}}
                              : camerasOf(scene.loaded->scene, grid.cameras,
                                          double(size.width) / size.height, found);
                if (cameras.empty()) {
                    throw Error(ErrorKind::kUsage, {scene.path, ""},
                                "has none of the cameras asked for; it has: " +
                                    listCameras(scene.loaded->scene));
                }
            } else {
                cameras.push_back({"?", {}});
            }
            for (const NamedCamera& camera : cameras) {
                for (SweepPoint& point : pointsOfView(grid, size)) {
                    point.scene = scene.path;
                    point.camera = camera.name;
                    plan.points.push_back({std::move(point), i, camera.camera});
                }
            }
            if (plan.points.size() > kMaxPoints) {
                throw Error(ErrorKind::kUsage, {},
                            "over " + std::to_string(kMaxPoints) +
                                " points; give fewer scenes, cameras, sizes, methods or planes");
            }
        }
    }
    const bool allLoaded = std::all_of(scenes.begin(), scenes.end(),
                                       [](const SweepScene& scene) { return scene.loaded; });
    for (const std::string& name : grid.cameras) {
        if (allLoaded && !found.contains(name)) {
            throw Error(ErrorKind::kUsage, {"--camera", ""},
                        "no scene has a camera '" + name + "'");
        }
    }
    plan.scenes = std::move(scenes);
    return plan;
}

}  // namespace ribalta
