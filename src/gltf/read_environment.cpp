#include "gltf/read_environment.h"

#include <cmath>
#include <optional>
#include <string>

#include <glm/gtc/quaternion.hpp>

#include "gltf/tally.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

constexpr const char* kExtension = "EXT_lights_image_based";
constexpr std::size_t kFaces = 6;

bool isNumbers(const json& list, std::size_t count) {
    if (!list.is_array() || list.size() != count) {
        return false;
    }
    for (const json& number : list) {
        if (!number.is_number() || !(std::abs(number.get<double>()) <= kMaxLampIntensity)) {
            return false;
        }
    }
    return true;
}

// Nothing where they are none, which is reported.
std::optional<IrradianceCoefficients> coefficientsOf(const json& light, const Place& place,
                                                     Report& report) {
    const json& list = member(light, "irradianceCoefficients");
    const Place here = place.at("irradianceCoefficients");
    constexpr const char* kLost = "; the light is left out";
    if (!list.is_array() || list.size() != 9) {
        report.ignored(here, (list.is_null()    ? std::string("is missing")
                              : list.is_array() ? "has " + counted(list.size(), "coefficients")
                                                : std::string("is no list")) +
                                 ", expected nine of three numbers each" + kLost);
        return std::nullopt;
    }
    IrradianceCoefficients coefficients;
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
        if (!isNumbers(list[i], 3)) {
            report.ignored(here.at(i), std::string("is no list of three finite numbers below ") +
                                           json(kMaxLampIntensity).dump() + kLost);
            return std::nullopt;
        }
        for (int c = 0; c < 3; ++c) {
            coefficients[i][c] = list[i][std::size_t(c)].get<double>();
        }
    }
    return coefficients;
}

glm::dmat3 rotationOf(const json& light, const Place& place, Report& report) {
    const json& rotation = member(light, "rotation");
    if (rotation.is_null()) {
        return glm::dmat3(1.0);
    }
    glm::dquat turn(0.0, 0.0, 0.0, 0.0);
    if (isNumbers(rotation, 4)) {
        turn = glm::dquat(rotation[3].get<double>(), rotation[0].get<double>(),
                          rotation[1].get<double>(), rotation[2].get<double>());
    }
    const double length = glm::length(turn);
    if (!(length > 1e-6)) {
        report.repaired(place.at("rotation"), "is no rotation; the light is not turned");
        return glm::dmat3(1.0);
    }
    if (std::abs(length - 1.0) > 1e-2) {
        report.repaired(place.at("rotation"), "has the length " + std::to_string(length) +
                                                  ", expected 1; it is brought to that");
    }
    return glm::mat3_cast(turn / length);
}

double intensityOf(const json& light, const Place& place, Report& report) {
    const json& intensity = member(light, "intensity");
    const double value = numberOr(light, "intensity", 1.0);
    const bool isUsable = intensity.is_null() || intensity.is_number();
    if (isUsable && value >= 0.0 && value <= kMaxLampIntensity) {
        return value;
    }
    report.repaired(place.at("intensity"),
                    "is " + intensity.dump() + ", expected a number of 0 and more; 1 is used");
    return 1.0;
}

// The pictures are not drawn; those that the file does not have are named all the same.
void tellOfPictures(const Import& import, const json& light, const Place& place, Report& report) {
    const json& mips = member(light, "specularImages");
    const Place here = place.at("specularImages");
    if (mips.is_null()) {
        report.hint(here, "is missing, which EXT_lights_image_based asks for");
        return;
    }
    report.ignored(here,
                   "holds the environment's pictures, which are not drawn: its light falls on "
                   "surfaces by the coefficients alone, and is not mirrored in them");
    const std::size_t images = member(import.json, "images").size();
    if (!mips.is_array()) {
        report.hint(here, "is no list of lists of six images");
        return;
    }
    for (std::size_t mip = 0; mip < mips.size(); ++mip) {
        if (!mips[mip].is_array() || mips[mip].size() != kFaces) {
            report.hint(here.at(mip), "is no list of six images, the faces of a cube");
            return;
        }
        for (std::size_t face = 0; face < kFaces; ++face) {
            const json& image = mips[mip][face];
            if (!image.is_number_integer() || image < 0 || image >= images) {
                report.hint(here.at(mip).at(face), "is " + image.dump() + ", but the file has " +
                                                       counted(images, "images"));
                return;
            }
        }
    }
}

}  // namespace

void readEnvironment(const Import& import, int index, Scene& scene, Report& report) {
    if (index < 0) {
        return;
    }
    const json& use = extension(element(import.json, "scenes", std::size_t(index)), kExtension);
    if (use.is_null()) {
        return;
    }
    const Place usePlace =
        import.file.at("scenes").at(std::size_t(index)).at("extensions").at(kExtension).at("light");
    const json& number = member(use, "light");
    const json& lights = member(extension(import.json, kExtension), "lights");
    const std::size_t count = lights.is_array() ? lights.size() : 0;
    if (!number.is_number_integer() || number < 0 || number >= count) {
        report.ignored(usePlace, "is " + number.dump() + ", but the file has " +
                                     counted(count, "image-based lights") +
                                     "; the scene is drawn without");
        return;
    }
    const json& light = lights[number.get<std::size_t>()];
    const Place place =
        import.file.at("extensions").at(kExtension).at("lights").at(number.get<std::size_t>());
    const std::optional<IrradianceCoefficients> given = coefficientsOf(light, place, report);
    if (!given) {
        return;
    }
    IrradianceCoefficients coefficients = *given;
    const double intensity = intensityOf(light, place, report);
    for (glm::dvec3& coefficient : coefficients) {
        coefficient *= intensity;
        // Both may be at their limits.
        coefficient = glm::clamp(coefficient, -kMaxLampIntensity, kMaxLampIntensity);
    }
    Environment environment;
    const json& name = member(light, "name");
    environment.name = name.is_string() ? name.get<std::string>() : "";
    environment.lux = irradianceForm(coefficients, rotationOf(light, place, report));
    tellOfPictures(import, light, place, report);
    scene.environment = std::move(environment);
}

}  // namespace ribalta::gltf
