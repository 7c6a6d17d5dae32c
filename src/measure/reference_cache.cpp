#include "measure/reference_cache.h"

#include <cstdlib>

#include "base/error.h"
#include "base/log.h"
#include "image/write_image.h"
#include "measure/content_hash.h"
#include "reference/reference_file.h"

namespace ribalta {
namespace {

// Of all that beams depend on, by its content rather than by its name.
std::string keyOf(const ReferenceFacts& facts, const std::string& sceneHash,
                  const ReferenceSettings& settings) {
    ContentHash hash;
    hash.add(referenceRevision());
    hash.add(sceneHash);
    for (const auto& [name, value] : facts) {
        hash.add(name);
        hash.add(value);
    }
    hash.add(std::to_string(settings.relativeError));
    if (settings.drawn != nullptr) {
        hash.add(settings.drawn->depths);
        for (const auto& map : settings.drawn->shadowMaps) {
            hash.add(map ? map->depths : std::vector<float>());
        }
    }
    return hash.text();
}

// "largest 1e-06 rms 2e-07", as referenceImage writes it.
double rmsOf(const FloatImage& image) {
    const auto found = image.facts.find("error");
    const std::size_t at =
        found == image.facts.end() ? std::string::npos : found->second.find("rms ");
    return at == std::string::npos ? 0.0 : std::strtod(found->second.c_str() + at + 4, nullptr);
}

}  // namespace

ReferenceBeams obtainReference(const std::filesystem::path& folder, const Scene& scene,
                               const std::string& sceneName, const std::string& sceneHash,
                               const ReferenceSettings& settings) {
    const ReferenceFacts facts = describeReference(sceneName, settings);
    const std::filesystem::path file = folder / (keyOf(facts, sceneHash, settings) + ".exr");
    const Place place{file.string(), ""};
    const std::string& against = facts.at("visibility");
    if (std::filesystem::exists(file)) {
        logVerbose("reference: " + file.string() + " is kept from before");
        const FloatImage image = readReference(file, facts);
        return {against, pickLayer(image, "beams", place), rmsOf(image)};
    }
    FloatImage image;
    {
        Progress progress("reference by " + against, std::size_t(settings.height));
        const ReferencePicture picture = drawReference(scene, settings, &progress);
        image = referenceImage(picture, settings, facts, {});
    }
    ReferenceBeams reference{against, pickLayer(image, "beams", place), rmsOf(image)};
    refuseNonFinite(reference.beams, place);
    writeExr(file, image);
    logVerbose("reference: " + file.string() + ", relative error " +
               std::to_string(reference.relativeRms));
    return reference;
}

}  // namespace ribalta
