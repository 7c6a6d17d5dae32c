#include "measure/reference_cache.h"

#include <optional>
#include <span>

#include "base/content_hash.h"
#include "base/error.h"
#include "base/log.h"
#include "image/write_image.h"
#include "reference/reference_file.h"

namespace ribalta {
namespace {

// Of all that beams depend on, by its content rather than by its name.
std::string keyOf(const ReferenceView& view, const std::string& sceneHash,
                  const ReferenceSettings& settings) {
    ContentHash hash;
    hash.add(referenceRevision());
    hash.add(sceneHash);
    hash.add(view.scene);
    hash.add(view.size);
    hash.add(view.camera);
    hash.add(view.haze);
    hash.add(view.ambient);
    hash.add(view.visibility);
    hash.add(view.sky);
    hash.add(view.skyAir);
    hash.add(std::as_bytes(std::span(&settings.relativeError, 1)));
    if (settings.drawn != nullptr) {
        hash.add(settings.drawn->depths);
        for (const auto& map : settings.drawn->shadowMaps) {
            hash.add(map ? map->depths : std::vector<float>());
        }
    }
    return hash.text();
}

}  // namespace

ReferenceBeams obtainReference(const std::filesystem::path& folder, const Scene& scene,
                               const std::string& sceneName, const std::string& sceneHash,
                               const ReferenceSettings& settings) {
    const ReferenceView view = describeReference(sceneName, settings);
    const std::filesystem::path file = folder / (keyOf(view, sceneHash, settings) + ".exr");
    const Place place{file.string(), ""};
    if (std::filesystem::exists(file)) {
        logVerbose("reference: " + file.string() + " is kept from before");
        const ReferenceFile kept = readReference(file, view);
        return {view.visibility, pickLayer(kept.image, "beams", place), kept.facts.rmsError};
    }
    std::optional<Progress> progress(std::in_place, "reference by " + view.visibility,
                                     std::size_t(settings.height));
    const ReferencePicture picture = drawReference(scene, settings, &*progress);
    progress.reset();
    const FloatImage image = referenceImage(picture, settings, view, {});
    ReferenceBeams reference{view.visibility, pickLayer(image, "beams", place), picture.rmsError};
    refuseNonFinite(reference.beams, place);
    writeExr(file, image);
    logVerbose("reference: " + file.string() + ", relative error " +
               std::to_string(reference.relativeRms));
    return reference;
}

}  // namespace ribalta
