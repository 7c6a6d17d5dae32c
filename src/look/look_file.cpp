#include "look/look_file.h"

#include <cmath>
#include <span>

#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>

#include "base/angles.h"
#include "base/parse_json.h"
#include "base/read_file.h"
#include "base/temporary_file.h"
#include "look/json_object.h"

namespace ribalta {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kFarMetres = 1e12;
constexpr double kMostLight = 1e12;  ///< candela and lux
constexpr int kLongestSide = 16384;
constexpr int kMostSheets = 65536;
constexpr int kMostCells = 1024;
constexpr std::uint64_t kMostBytes = std::uint64_t(64) << 20;

[[noreturn]] void refuse(const Place& place, const std::string& message) {
    throw Error(ErrorKind::kBadInput, place, message);
}

// A text of a table's words; `otherwise` where the key is not there.
template <typename Value>
Value readNamed(JsonObject& object, const std::string& key, std::span<const Named<Value>> table,
                Value otherwise) {
    const std::optional<std::string> word = object.text(key);
    if (!word) {
        return otherwise;
    }
    const std::optional<Value> found = valueIn(table, *word);
    if (!found) {
        refuse(object.place(key), "is \"" + *word + "\", expected one of: " + listOf(table));
    }
    return *found;
}

glm::dvec3 vectorOf(const std::vector<double>& numbers) {
    return {numbers[0], numbers[1], numbers[2]};
}

// "position" and "rotation", a quaternion x, y, z, w as in glTF; both or neither.
std::optional<Frame> readFrameOf(JsonObject& object) {
    const auto position = object.numbers("position", 3, -kFarMetres, kFarMetres);
    const auto rotation = object.numbers("rotation", 4, -1.0, 1.0);
    if (position.has_value() != rotation.has_value()) {
        refuse(object.place(position ? "rotation" : "position"),
               "is missing; a place has both position and rotation");
    }
    if (!position) {
        return std::nullopt;
    }
    const glm::dquat turn((*rotation)[3], (*rotation)[0], (*rotation)[1], (*rotation)[2]);
    if (std::abs(glm::length(turn) - 1.0) > 1e-3) {
        refuse(object.place("rotation"),
               "has the length " + std::to_string(glm::length(turn)) + ", expected 1");
    }
    return Frame{vectorOf(*position), glm::mat3_cast(glm::normalize(turn))};
}

void writeFrameOf(const Frame& frame, Json& json) {
    const glm::dquat turn = glm::quat_cast(frame.worldFromLocal);
    json["position"] = {frame.position.x, frame.position.y, frame.position.z};
    json["rotation"] = {turn.x, turn.y, turn.z, turn.w};
}

Camera readCameraOf(JsonObject& object) {
    Camera camera;
    camera.name = object.text("name").value_or("");
    const std::optional<Frame> frame = readFrameOf(object);
    if (!frame) {
        refuse(object.place("position"), "is missing; a camera has position and rotation");
    }
    camera.frame = *frame;
    const auto fov = object.number("vertical_fov_degrees", 0.01, 179.9);
    const auto halfSize = object.numbers("half_size", 2, 1e-9, kFarMetres);
    const auto aspectRatio = object.number("aspect_ratio", 1e-6, 1e6);
    if (fov.has_value() == halfSize.has_value()) {
        refuse(object.place(), "needs either vertical_fov_degrees or half_size (orthographic)");
    }
    if (fov) {
        camera.lens = PerspectiveLens{*fov / kDegreesPerRadian, aspectRatio};
    } else {
        camera.lens = OrthographicLens{(*halfSize)[0], (*halfSize)[1]};
    }
    camera.nearMetres = object.number("near", 1e-9, kFarMetres).value_or(camera.nearMetres);
    camera.farMetres = object.number("far", 1e-9, kFarMetres).value_or(camera.farMetres);
    if (!(camera.farMetres > camera.nearMetres)) {
        refuse(object.place("far"), "is not beyond near");
    }
    if (camera.isOrthographic() && !std::isfinite(camera.farMetres)) {
        refuse(object.place("far"), "is missing; an orthographic camera has one");
    }
    object.refuseOthers();
    return camera;
}

Json writeCameraOf(const Camera& camera) {
    Json json;
    json["name"] = camera.name;
    writeFrameOf(camera.frame, json);
    if (const auto* lens = std::get_if<PerspectiveLens>(&camera.lens)) {
        json["vertical_fov_degrees"] = lens->verticalFov * kDegreesPerRadian;
        if (lens->aspectRatio) {
            json["aspect_ratio"] = *lens->aspectRatio;
        }
    } else {
        const auto& box = std::get<OrthographicLens>(camera.lens);
        json["half_size"] = {box.halfWidth, box.halfHeight};
    }
    json["near"] = camera.nearMetres;
    if (std::isfinite(camera.farMetres)) {
        json["far"] = camera.farMetres;
    }
    return json;
}

LightMapChange readLightMapOf(JsonObject& lamp, const std::filesystem::path& folder) {
    LightMapChange change;
    if (lamp.isNull("light_map")) {
        change.file.emplace();
        return change;
    }
    std::optional<JsonObject> object = lamp.object("light_map");
    if (!object) {
        return change;
    }
    if (const std::optional<std::string> file = object->text("file")) {
        if (file->empty()) {
            refuse(object->place("file"), "is empty; null takes the light map away");
        }
        change.file = (folder / *file).lexically_normal();
    }
    if (const auto degrees = object->number("rotation_degrees", -36000.0, 36000.0)) {
        change.rotationRadians = *degrees / kDegreesPerRadian;
    }
    object->refuseOthers();
    return change;
}

void writeLightMapOf(const LightMapChange& change, const std::filesystem::path& folder,
                     Json& lamp) {
    if (change.file && change.file->empty()) {
        lamp["light_map"] = nullptr;
        return;
    }
    if (change.file) {
        std::filesystem::path file =
            std::filesystem::absolute(*change.file).lexically_relative(folder);
        lamp["light_map"]["file"] = (file.empty() ? *change.file : file).generic_string();
    }
    if (change.rotationRadians) {
        lamp["light_map"]["rotation_degrees"] = *change.rotationRadians * kDegreesPerRadian;
    }
}

LampChange readLampOf(JsonObject& object, const std::filesystem::path& folder) {
    LampChange lamp;
    const std::optional<std::string> name = object.text("name");
    if (!name) {
        refuse(object.place("name"), "is missing; it says which lamp is meant");
    }
    lamp.name = *name;
    lamp.number = object.integer("number", 0, 1 << 30).value_or(0);
    lamp.off = !object.flag("on").value_or(true);
    lamp.solo = object.flag("solo").value_or(false);
    lamp.intensity = object.number("intensity", 0.0, kMostLight);
    if (const auto color = object.numbers("color", 3, 0.0, 1e6)) {
        lamp.color = glm::vec3(vectorOf(*color));
    }
    const auto inner = object.number("inner_cone_degrees", 0.0, 90.0);
    const auto outer = object.number("outer_cone_degrees", 0.01, 90.0);
    // Radians and back may cost the last digit.
    if (inner && outer && *inner > *outer + 1e-9) {
        refuse(object.place("inner_cone_degrees"), "is wider than the outer cone");
    }
    if (inner) {
        lamp.innerConeAngle = *inner / kDegreesPerRadian;
    }
    if (outer) {
        lamp.outerConeAngle = *outer / kDegreesPerRadian;
    }
    lamp.frame = readFrameOf(object);
    lamp.lightMap = readLightMapOf(object, folder);
    object.refuseOthers();
    return lamp;
}

// Refuses the last lamp where it is there before.
void refuseTwice(const std::vector<LampChange>& lamps, const JsonObject& object) {
    for (std::size_t i = 0; i + 1 < lamps.size(); ++i) {
        if (lamps[i].name == lamps.back().name && lamps[i].number == lamps.back().number) {
            refuse(object.place("name"), "is '" + lamps.back().name +
                                             "', which is there already; leave one of them out, or "
                                             "give a number where several lamps have this name");
        }
    }
}

Json writeLampOf(const LampChange& lamp, const std::filesystem::path& folder) {
    Json json;
    json["name"] = lamp.name;
    if (lamp.number > 0) {
        json["number"] = lamp.number;
    }
    if (lamp.off) {
        json["on"] = false;
    }
    if (lamp.solo) {
        json["solo"] = true;
    }
    if (lamp.intensity) {
        json["intensity"] = *lamp.intensity;
    }
    if (lamp.color) {
        json["color"] = {lamp.color->x, lamp.color->y, lamp.color->z};
    }
    if (lamp.innerConeAngle) {
        json["inner_cone_degrees"] = *lamp.innerConeAngle * kDegreesPerRadian;
    }
    if (lamp.outerConeAngle) {
        json["outer_cone_degrees"] = *lamp.outerConeAngle * kDegreesPerRadian;
    }
    if (lamp.frame) {
        writeFrameOf(*lamp.frame, json);
    }
    writeLightMapOf(lamp.lightMap, folder, json);
    return json;
}

Haze readHazeOf(JsonObject& object) {
    Haze haze;
    haze.scatteringPerMetre =
        object.number("scattering", 0.0, 1e6).value_or(haze.scatteringPerMetre);
    haze.absorptionPerMetre =
        object.number("absorption", 0.0, 1e6).value_or(haze.absorptionPerMetre);
    haze.phase.kind = readNamed(object, "phase", phaseFunctions(), haze.phase.kind);
    haze.phase.g = object.number("g", -0.999999, 0.999999).value_or(0.0);
    if (haze.phase.g != 0.0 && !haze.phase.hasG()) {
        refuse(object.place("g"), "belongs to the phase functions hg and cornette-shanks");
    }
    haze.phase.k = object.number("K", 1e-9, 1e9).value_or(haze.phase.k);
    object.refuseOthers();
    return haze;
}

Json writeHazeOf(const Haze& haze) {
    Json json;
    json["scattering"] = haze.scatteringPerMetre;
    json["absorption"] = haze.absorptionPerMetre;
    json["phase"] = name(haze.phase.kind);
    if (haze.phase.hasG()) {
        json["g"] = haze.phase.g;
    }
    if (haze.phase.k != PhaseFunction{}.k) {
        json["K"] = haze.phase.k;
    }
    return json;
}

BeamSettings readBeamsOf(JsonObject& object) {
    BeamSettings beams;
    beams.method = readNamed(object, "method", beamMethods(), beams.method);
    beams.planes = object.integer("planes", 1, kMostSheets).value_or(beams.planes);
    beams.tolerance = object.number("tolerance", 0.0, 1.0);
    if (const auto cells = object.numbers("cells", 2, 1.0, kMostCells)) {
        beams.cellsAcross = int((*cells)[0]);
        beams.cellsDown = int((*cells)[1]);
    }
    object.refuseOthers();
    return beams;
}

Json writeBeamsOf(const BeamSettings& beams) {
    Json json;
    json["method"] = name(beams.method);
    json["planes"] = beams.planes;
    if (beams.tolerance) {
        json["tolerance"] = *beams.tolerance;
    }
    if (beams.cellsAcross > 0) {
        json["cells"] = {beams.cellsAcross, beams.cellsDown};
    }
    return json;
}

SkyLook readSkyOf(JsonObject& object) {
    SkyLook sky;
    sky.model = readNamed(object, "model", skyKinds(), sky.model);
    const auto elevation = object.number("sun_elevation_degrees", -90.0, 90.0);
    const auto azimuth = object.number("sun_azimuth_degrees", -360.0, 360.0);
    if (elevation.has_value() != azimuth.has_value()) {
        refuse(object.place(elevation ? "sun_azimuth_degrees" : "sun_elevation_degrees"),
               "is missing; the sun's place has both");
    }
    if (elevation) {
        sky.sun = SunInSky{*elevation / kDegreesPerRadian, *azimuth / kDegreesPerRadian};
    }
    sky.altitudeMetres = object.number("altitude", 0.0, 1e9).value_or(0.0);
    object.refuseOthers();
    return sky;
}

Json writeSkyOf(const SkyLook& sky) {
    Json json;
    json["model"] = name(sky.model);
    if (sky.sun) {
        json["sun_elevation_degrees"] = sky.sun->elevation * kDegreesPerRadian;
        json["sun_azimuth_degrees"] = sky.sun->azimuth * kDegreesPerRadian;
    }
    json["altitude"] = sky.altitudeMetres;
    return json;
}

LookTime readTimeOf(JsonObject& object) {
    LookTime time;
    const auto seconds = object.number("seconds", 0.0, 1e9);
    if (!seconds) {
        refuse(object.place("seconds"), "is missing; it says when");
    }
    time.seconds = *seconds;
    time.animation = object.text("animation").value_or("");
    object.refuseOthers();
    return time;
}

Json writeTimeOf(const LookTime& time) {
    Json json;
    json["seconds"] = time.seconds;
    if (!time.animation.empty()) {
        json["animation"] = time.animation;
    }
    return json;
}

void checkVersion(JsonObject& object) {
    const auto version = object.integer("ribalta_look", 1, 1 << 30);
    if (!version) {
        refuse(object.place("ribalta_look"), "is missing; this is no look that ribalta wrote");
    }
    if (*version > kLookVersion) {
        refuse(object.place("ribalta_look"),
               "is " + std::to_string(*version) + ", expected at most " +
                   std::to_string(kLookVersion) + "; it was written by a newer ribalta");
    }
}

// "auto" or a number.
std::optional<double> readExposureOf(JsonObject& object) {
    const std::string key = "exposure";
    if (object.isText(key)) {
        if (object.text(key) != "auto") {
            refuse(object.place(key), "is a text, expected \"auto\" or an EV100");
        }
        return std::nullopt;
    }
    return object.number(key, -60.0, 60.0);
}

}  // namespace

Look readLook(const std::filesystem::path& path) {
    const Place file{path.string(), ""};
    const std::vector<std::byte> bytes = readFile(path, kMostBytes);
    const nlohmann::json json =
        parseJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, file,
                  {"a look", "correct it or save the look again"});
    JsonObject object(json, file);
    checkVersion(object);
    const std::filesystem::path folder =
        std::filesystem::absolute(path).lexically_normal().parent_path();
    Look look;
    look.scene = object.text("scene").value_or("");
    if (std::optional<JsonObject> camera = object.object("camera")) {
        look.camera = readCameraOf(*camera);
    }
    for (JsonObject& bookmark : object.objects("bookmarks")) {
        look.bookmarks.push_back(readCameraOf(bookmark));
    }
    if (const auto size = object.numbers("size", 2, 1.0, kLongestSide)) {
        look.size = glm::ivec2((*size)[0], (*size)[1]);
    }
    if (std::optional<JsonObject> time = object.object("time")) {
        look.time = readTimeOf(*time);
    }
    for (JsonObject& lamp : object.objects("lamps")) {
        look.lamps.push_back(readLampOf(lamp, folder));
        refuseTwice(look.lamps, lamp);
    }
    if (std::optional<JsonObject> haze = object.object("haze")) {
        look.haze = readHazeOf(*haze);
    }
    if (std::optional<JsonObject> beams = object.object("beams")) {
        look.beams = readBeamsOf(*beams);
    }
    if (std::optional<JsonObject> sky = object.object("sky")) {
        look.sky = readSkyOf(*sky);
    }
    look.ambientLux = object.number("ambient_lux", 0.0, 1e9).value_or(look.ambientLux);
    look.ev100 = readExposureOf(object);
    look.toneCurve = readNamed(object, "tone_curve", toneCurves(), look.toneCurve);
    object.refuseOthers();
    return look;
}

void writeLook(const Look& look, const std::filesystem::path& path) {
    const std::filesystem::path folder =
        std::filesystem::absolute(path).lexically_normal().parent_path();
    Json json;
    json["ribalta_look"] = kLookVersion;
    json["scene"] = look.scene;
    if (look.camera) {
        json["camera"] = writeCameraOf(*look.camera);
    }
    for (const Camera& bookmark : look.bookmarks) {
        json["bookmarks"].push_back(writeCameraOf(bookmark));
    }
    if (look.size) {
        json["size"] = {look.size->x, look.size->y};
    }
    if (look.time) {
        json["time"] = writeTimeOf(*look.time);
    }
    json["lamps"] = Json::array();
    for (const LampChange& lamp : look.lamps) {
        json["lamps"].push_back(writeLampOf(lamp, folder));
    }
    json["haze"] = writeHazeOf(look.haze);
    json["beams"] = writeBeamsOf(look.beams);
    if (look.sky) {
        json["sky"] = writeSkyOf(*look.sky);
    }
    json["ambient_lux"] = look.ambientLux;
    if (look.ev100) {
        json["exposure"] = *look.ev100;
    } else {
        json["exposure"] = "auto";
    }
    json["tone_curve"] = name(look.toneCurve);
    writeFileAtomically(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace ribalta
