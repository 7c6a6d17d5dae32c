#include "reference/reference_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>
#include <variant>

#include "base/error.h"
#include "image/read_image.h"
#include "optics/shader_lib.h"

namespace ribalta {
namespace {

/// The facts that make a view, in the order in which they are compared.
constexpr std::array<const char*, 6> kView = {"scene", "size",    "camera",
                                              "haze",  "ambient", "visibility"};

/// With all digits, so that equal texts are equal numbers.
std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}

std::string numbers(const glm::dvec3& values) {
    return number(values.x) + " " + number(values.y) + " " + number(values.z);
}

std::string describeCamera(const Camera& camera) {
    std::string text = oneLine(camera.name);
    text += " at " + numbers(camera.frame.position) + " towards " +
            numbers(camera.frame.forward()) + " up " + numbers(camera.frame.up());
    if (const auto* lens = std::get_if<PerspectiveLens>(&camera.lens)) {
        text += ", perspective " + number(lens->verticalFov);
        if (lens->aspectRatio) {
            text += " aspect " + number(*lens->aspectRatio);
        }
    } else {
        const auto& parallel = std::get<OrthographicLens>(camera.lens);
        text += ", orthographic " + number(parallel.halfWidth) + " " + number(parallel.halfHeight);
    }
    return text + ", near " + number(camera.nearMetres) + " far " + number(camera.farMetres);
}

std::string describeHaze(const Haze& haze) {
    static constexpr std::array<const char*, 5> kNames = {
        "gibbons", "isotropic", "henyey-greenstein", "cornette-shanks", "rayleigh"};
    return "scattering " + number(haze.scatteringPerMetre) + " absorption " +
           number(haze.absorptionPerMetre) + " " + kNames[std::size_t(haze.phase.kind)] + " g " +
           number(haze.phase.g) + " K " + number(haze.phase.k);
}

std::string factOf(const ReferenceFacts& facts, const char* name) {
    const auto found = facts.find(name);
    return found == facts.end() ? "" : found->second;
}

}  // namespace

ReferenceFacts describeReference(const std::string& scene, const ReferenceSettings& settings) {
    return {{"scene", oneLine(scene)},
            {"size", std::to_string(settings.width) + "x" + std::to_string(settings.height)},
            {"camera", describeCamera(settings.camera)},
            {"haze", describeHaze(settings.haze)},
            {"ambient", number(settings.ambientLux)},
            {"visibility", settings.drawn == nullptr ? "geometry" : "shadow-map"}};
}

FloatImage referenceImage(const ReferencePicture& picture, const ReferenceSettings& settings,
                          ReferenceFacts facts, const ReferenceLayers& layers) {
    facts["error"] = "largest " + number(picture.largestError) + " rms " + number(picture.rmsError);
    FloatImage image;
    image.width = picture.width;
    image.height = picture.height;
    image.facts = std::move(facts);
    image.channels = {"R", "G", "B", "beams.R", "beams.G", "beams.B"};
    if (layers.transmittance) {
        image.channels.insert(image.channels.end(),
                              {"transmittance.R", "transmittance.G", "transmittance.B"});
    }
    if (layers.depth) {
        image.channels.emplace_back("Z");
    }
    const glm::dvec2 half = viewHalfExtent(settings.camera, picture.width, picture.height);
    const double extinction = settings.haze.extinctionPerMetre();
    image.values.reserve(picture.beams.size() * image.channels.size());
    const auto append = [&](const glm::dvec3& color) {
        for (int c = 0; c < 3; ++c) {
            image.values.push_back(float(color[c]));
        }
    };
    for (std::size_t i = 0; i < picture.beams.size(); ++i) {
        append(picture.total(i));
        append(picture.beams[i]);
        if (layers.transmittance) {
            const std::size_t x = i % std::size_t(picture.width);
            const std::size_t y = i / std::size_t(picture.width);
            const glm::dvec2 slope =
                half * glm::dvec2((2.0 * double(x) + 1.0) / picture.width - 1.0,
                                  (2.0 * double(y) + 1.0) / picture.height - 1.0);
            const double metres =
                picture.depths[i] *
                (settings.camera.isOrthographic() ? 1.0 : std::sqrt(1.0 + glm::dot(slope, slope)));
            append(glm::dvec3(extinction > 0.0 ? shader::transmittance(extinction, metres) : 1.0));
        }
        if (layers.depth) {
            image.values.push_back(float(picture.depths[i]));
        }
    }
    return image;
}

FloatImage readReference(const std::filesystem::path& path, const ReferenceFacts& wanted) {
    FloatImage image = readFloatImage(path);
    const Place place{path.string(), ""};
    if (factOf(image.facts, "visibility").empty()) {
        throw Error(ErrorKind::kBadInput, place,
                    "is no reference; draw one with ribalta reference SCENE -o FILE.exr");
    }
    const auto* const differs = std::find_if(kView.begin(), kView.end(), [&](const char* name) {
        return factOf(image.facts, name) != factOf(wanted, name);
    });
    if (differs != kView.end()) {
        throw Error(ErrorKind::kBadInput, place,
                    std::string("is a reference of another ") + *differs + " (" +
                        factOf(image.facts, *differs) + "; expected " + factOf(wanted, *differs) +
                        "); draw it anew with ribalta reference");
    }
    return image;
}

}  // namespace ribalta
