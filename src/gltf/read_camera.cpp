#include "gltf/read_camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "gltf/bad_input.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

// The value where it makes a picture, or else a stand-in that the report names.
class Mender {
  public:
    Mender(Place place, Report& report) : place_(std::move(place)), report_(report) {}

    double keepIf(bool usable, double value, const char* key, double otherwise) const {
        if (usable) {
            return value;
        }
        report_.repaired(place_.at(key), "is " + json(value).dump() + ", of which no picture can " +
                                             "be made; " + json(otherwise).dump() + " is used");
        return otherwise;
    }

  private:
    Place place_;
    Report& report_;
};

void readPerspective(const json& source, const Mender& mend, Camera& camera) {
    PerspectiveLens lens;
    const double fov = numberOr(source, "yfov", lens.verticalFov);
    lens.verticalFov = mend.keepIf(fov > kMinVerticalFov && fov <= kMaxVerticalFov, fov, "yfov",
                                   fov > kMaxVerticalFov ? kMaxVerticalFov : 0.8);
    if (source.contains("aspectRatio")) {
        const double aspect = numberOr(source, "aspectRatio", 1.0);
        if (mend.keepIf(aspect > 1.0 / kMaxAspectRatio && aspect < kMaxAspectRatio, aspect,
                        "aspectRatio", 0.0) > 0.0) {
            lens.aspectRatio = aspect;
        }
    }
    camera.lens = lens;
    const double near = numberOr(source, "znear", 0.1);
    camera.nearMetres =
        mend.keepIf(near >= kMinNearMetres && near < kMaxCameraMetres, near, "znear", 0.1);
    if (source.contains("zfar")) {
        const double far = numberOr(source, "zfar", 0.0);
        const double unlimited = std::numeric_limits<double>::infinity();
        camera.farMetres = far > camera.nearMetres && far < kMaxCameraMetres
                               ? far
                               : (mend.keepIf(false, far, "zfar", 0.0), unlimited);
    }
}

void readOrthographic(const json& source, const Mender& mend, Camera& camera) {
    OrthographicLens lens;
    const auto extent = [&](const char* key) {
        const double value = numberOr(source, key, 1.0);
        // A negative magnification mirrors; glTF advises against it and none is drawn so.
        const double size = std::abs(value);
        const bool usable = size > kMinExtentMetres && size < kMaxCameraMetres;
        return mend.keepIf(usable && value > 0.0, value, key, usable ? size : 1.0);
    };
    lens.halfWidth = extent("xmag");
    lens.halfHeight = extent("ymag");
    camera.lens = lens;
    const double near = numberOr(source, "znear", 0.0);
    camera.nearMetres = mend.keepIf(near >= 0.0 && near < kMaxCameraMetres, near, "znear", 0.0);
    const double far = numberOr(source, "zfar", camera.nearMetres + kUsualBoxDepth);
    camera.farMetres = mend.keepIf(far > camera.nearMetres && far < kMaxCameraMetres, far, "zfar",
                                   camera.nearMetres + kUsualBoxDepth);
}

Camera readCamera(const Import& import, std::size_t index, Report& report) {
    const json& source = element(import.json, "cameras", index);
    const Place place = import.file.at("cameras").at(index);
    Camera camera;
    const bool isOrthographic = source["type"] == "orthographic";
    const char* kind = isOrthographic ? "orthographic" : "perspective";
    const json& lens = member(source, kind);
    if (lens.is_null()) {
        report.repaired(place, std::string("lacks its \"") + kind + "\"; a usual lens is used");
        if (isOrthographic) {
            camera.lens = OrthographicLens();
            camera.farMetres = 1000.0;
        }
        return camera;
    }
    const Mender mend(place.at(kind), report);
    if (isOrthographic) {
        readOrthographic(lens, mend, camera);
    } else {
        readPerspective(lens, mend, camera);
    }
    return camera;
}

std::string nameOf(const json& object) {
    const json& name = member(object, "name");
    return name.is_string() ? name.get<std::string>() : std::string();
}

// Whether `name` is `plain` with Blender's suffix, .001 and so on.
bool isSuffixed(const std::string& name, const std::string& plain) {
    return name.size() == plain.size() + 4 && name.starts_with(plain) &&
           name[plain.size()] == '.' &&
           std::all_of(name.end() - 3, name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::string chooseName(const std::string& node, const std::string& own,
                       const std::set<std::string>& nodeNames, std::size_t number) {
    if (!own.empty() && isSuffixed(node, own) && !nodeNames.contains(own)) {
        return own;
    }
    return !node.empty() ? node : !own.empty() ? own : "camera_" + std::to_string(number);
}

}  // namespace

std::vector<Camera> readCameras(const Import& import, const std::vector<std::size_t>& gltfNodes,
                                Report& report) {
    std::set<std::string> taken;  // names of nodes with cameras, then of cameras
    for (const std::size_t node : gltfNodes) {
        if (import.nodes[node].camera >= 0) {
            taken.emplace(import.nodes[node].name);
        }
    }
    std::map<std::size_t, Camera> known;
    std::vector<Camera> cameras;
    for (std::size_t i = 0; i < gltfNodes.size(); ++i) {
        const FileNode& node = import.nodes[gltfNodes[i]];
        if (node.camera < 0) {
            continue;
        }
        const auto index = std::size_t(node.camera);
        if (!known.contains(index)) {
            known.emplace(index, readCamera(import, index, report));
        }
        Camera camera = known.at(index);
        camera.name =
            chooseName(std::string(node.name), nameOf(element(import.json, "cameras", index)),
                       taken, cameras.size());
        camera.node = int(i);
        taken.insert(camera.name);
        cameras.push_back(std::move(camera));
    }
    return cameras;
}

}  // namespace ribalta::gltf
