#include "reference/reference_file.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>
#include <variant>

#include "base/error.h"
#include "image/read_image.h"
#include "optics/shader_lib.h"

namespace ribalta {
namespace {

struct ViewFact {
    const char* name;  // in the file
    std::string ReferenceView::*text;
};

// In the order in which they are compared.
constexpr std::array<ViewFact, 8> kView = {{{"scene", &ReferenceView::scene},
                                            {"size", &ReferenceView::size},
                                            {"camera", &ReferenceView::camera},
                                            {"haze", &ReferenceView::haze},
                                            {"ambient", &ReferenceView::ambient},
                                            {"visibility", &ReferenceView::visibility},
                                            {kSkyFact, &ReferenceView::sky},
                                            {kSkyAirFact, &ReferenceView::skyAir}}};
constexpr const char* kLargestError = "largest_error";
constexpr const char* kRmsError = "rms_error";
constexpr const char* kLargestSkyError = "largest_sky_error";
constexpr const char* kRmsSkyError = "rms_sky_error";

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

// Null where the picture does not say so.
template <typename Value>
const Value* findFact(const FloatImage& image, const char* name) {
    const auto found = image.facts.find(name);
    return found == image.facts.end() ? nullptr : std::get_if<Value>(&found->second);
}

// Nothing where the picture is no reference.
std::optional<ReferenceFacts> factsOf(const FloatImage& image) {
    ReferenceFacts facts;
    for (const ViewFact& fact : kView) {
        const auto* text = findFact<std::string>(image, fact.name);
        if (text == nullptr) {
            if (fact.text == &ReferenceView::sky || fact.text == &ReferenceView::skyAir) {
                continue;  // drawn before there were skies
            }
            return std::nullopt;
        }
        facts.view.*fact.text = *text;
    }
    const auto* largest = findFact<double>(image, kLargestError);
    const auto* rms = findFact<double>(image, kRmsError);
    if (largest == nullptr || rms == nullptr) {
        return std::nullopt;
    }
    facts.largestError = *largest;
    facts.rmsError = *rms;
    const auto* largestOfSky = findFact<double>(image, kLargestSkyError);
    const auto* rmsOfSky = findFact<double>(image, kRmsSkyError);
    facts.skyError = {largestOfSky != nullptr ? *largestOfSky : 0.0,
                      rmsOfSky != nullptr ? *rmsOfSky : 0.0};
    return facts;
}

}  // namespace

std::string describeSky(const SkyOverScene& sky) {
    return "sun " + numbers(sky.towardsSun) + " altitude " + number(sky.altitudeMetres) +
           " orders " + (sky.orders.closed ? "all" : std::to_string(sky.orders.count));
}

std::string describeAir(const Atmosphere& air) {
    return "ground " + number(air.groundRadiusMetres) + " top " + number(air.topMetres) +
           " rayleigh " + numbers(air.rayleighScatteringPerMetre) + " height " +
           number(air.rayleighScaleHeightMetres) + " mie " + numbers(air.mieScatteringPerMetre) +
           " of " + numbers(air.mieExtinctionPerMetre) + " height " +
           number(air.mieScaleHeightMetres) + " g " + number(air.mieG) + " albedo " +
           numbers(air.groundAlbedo) + " lux " + numbers(air.sunIlluminanceLux) + " radius " +
           number(air.sunAngularRadius);
}

ReferenceView describeReference(const std::string& scene, const ReferenceSettings& settings) {
    return {oneLine(scene),
            std::to_string(settings.width) + "x" + std::to_string(settings.height),
            describeCamera(settings.camera),
            describeHaze(settings.haze),
            number(settings.ambientLux),
            settings.drawn == nullptr ? "geometry" : "shadow-map",
            settings.sky ? describeSky(*settings.sky) : "none",
            settings.sky ? describeAir(settings.sky->air) : "none"};
}

FloatImage referenceImage(const ReferencePicture& picture, const ReferenceSettings& settings,
                          const ReferenceView& view, const ReferenceLayers& layers) {
    FloatImage image;
    image.width = picture.width;
    image.height = picture.height;
    for (const ViewFact& fact : kView) {
        image.facts[fact.name] = view.*fact.text;
    }
    image.facts[kLargestError] = picture.largestError;
    image.facts[kRmsError] = picture.rmsError;
    if (settings.sky) {
        image.facts[kLargestSkyError] = picture.skyError.largest;
        image.facts[kRmsSkyError] = picture.skyError.rms;
    }
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

ReferenceFile readReference(const std::filesystem::path& path, const ReferenceView& wanted) {
    FloatImage image = readFloatImage(path);
    const Place place{path.string(), ""};
    const std::optional<ReferenceFacts> facts = factsOf(image);
    if (!facts) {
        throw Error(ErrorKind::kBadInput, place,
                    "is no reference; draw one with ribalta reference SCENE -o FILE.exr");
    }
    for (const ViewFact& fact : kView) {
        const std::string& found = facts->view.*fact.text;
        const std::string& expected = wanted.*fact.text;
        if (found != expected) {
            throw Error(ErrorKind::kBadInput, place,
                        std::string("is a reference of another ") + fact.name + " (" + found +
                            "; expected " + expected + "); draw it anew with ribalta reference");
        }
    }
    return {std::move(image), *facts};
}

}  // namespace ribalta
