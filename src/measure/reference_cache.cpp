#include "measure/reference_cache.h"

#include <optional>
#include <span>
#include <utility>

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

/// A reference as a file has it, kept or drawn now.
struct Obtained {
    FloatImage image;
    ReferenceFacts facts;
    std::filesystem::path file;
};

Obtained obtain(const std::filesystem::path& folder, const Scene& scene,
                const std::string& sceneName, const std::string& sceneHash,
                const ReferenceSettings& settings) {
    const ReferenceView view = describeReference(sceneName, settings);
    const std::filesystem::path file = folder / (keyOf(view, sceneHash, settings) + ".exr");
    if (std::filesystem::exists(file)) {
        logVerbose("reference: " + file.string() + " is kept from before");
        ReferenceFile kept = readReference(file, view);
        return {std::move(kept.image), kept.facts, file};
    }
    std::optional<Progress> progress(std::in_place, "reference by " + view.visibility,
                                     std::size_t(settings.height));
    const ReferencePicture picture = drawReference(scene, settings, &*progress);
    progress.reset();
    FloatImage image = referenceImage(picture, settings, view, {});
    refuseNonFinite(pickLayer(image, "beams", {file.string(), ""}), {file.string(), ""});
    refuseNonFinite(pickLayer(image, "", {file.string(), ""}), {file.string(), ""});
    writeExr(file, image);
    return {
        std::move(image), {view, picture.largestError, picture.rmsError, picture.skyError}, file};
}

}  // namespace

ReferenceBeams obtainReference(const std::filesystem::path& folder, const Scene& scene,
                               const std::string& sceneName, const std::string& sceneHash,
                               const ReferenceSettings& settings) {
    const Obtained found = obtain(folder, scene, sceneName, sceneHash, settings);
    logVerbose("reference: " + found.file.string() + ", relative error " +
               std::to_string(found.facts.rmsError));
    return {found.facts.view.visibility, pickLayer(found.image, "beams", {found.file.string(), ""}),
            found.facts.rmsError};
}

KeptReference obtainReferencePicture(const std::filesystem::path& folder, const Scene& scene,
                                     const std::string& sceneName, const std::string& sceneHash,
                                     const ReferenceSettings& settings) {
    const Obtained found = obtain(folder, scene, sceneName, sceneHash, settings);
    return {pickLayer(found.image, "", {found.file.string(), ""}), found.facts, found.file};
}

}  // namespace ribalta
