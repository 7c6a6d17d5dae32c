#include "gltf/read_camera.h"

#include <cmath>

#include "gltf/bad_input.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

constexpr double kMaxFov = 3.1;  // radians, short of a half space

double numberOr(const json& object, const char* key, double otherwise) {
    const json& value = member(object, key);
    return value.is_number() ? value.get<double>() : otherwise;
}

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
    lens.verticalFov =
        mend.keepIf(fov > 1e-4 && fov <= kMaxFov, fov, "yfov", fov > kMaxFov ? kMaxFov : 0.8);
    if (source.contains("aspectRatio")) {
        const double aspect = numberOr(source, "aspectRatio", 1.0);
        if (mend.keepIf(aspect > 1e-4 && aspect < 1e4, aspect, "aspectRatio", 0.0) > 0.0) {
            lens.aspectRatio = aspect;
        }
    }
    camera.lens = lens;
    const double near = numberOr(source, "znear", 0.1);
    camera.nearMetres = mend.keepIf(near >= 1e-9 && near < 1e30, near, "znear", 0.1);
    if (source.contains("zfar")) {
        const double far = numberOr(source, "zfar", 0.0);
        const double unlimited = std::numeric_limits<double>::infinity();
        camera.farMetres = far > camera.nearMetres && far < 1e30
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
        const bool usable = size > 1e-9 && size < 1e30;
        return mend.keepIf(usable && value > 0.0, value, key, usable ? size : 1.0);
    };
    lens.halfWidth = extent("xmag");
    lens.halfHeight = extent("ymag");
    camera.lens = lens;
    const double near = numberOr(source, "znear", 0.0);
    camera.nearMetres = mend.keepIf(near >= 0.0 && near < 1e30, near, "znear", 0.0);
    const double far = numberOr(source, "zfar", camera.nearMetres + 100.0);
    camera.farMetres =
        mend.keepIf(far > camera.nearMetres && far < 1e30, far, "zfar", camera.nearMetres + 100.0);
}

}  // namespace

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

}  // namespace ribalta::gltf
