// ReferenceCache: reference pictures kept as files, so that a sweep draws each one once.
#pragma once

#include <filesystem>
#include <string>

#include "base/progress.h"
#include "measure/sweep_view.h"
#include "reference/reference_file.h"
#include "reference/reference_picture.h"

namespace ribalta {

/// The reference's beams, from `folder` where they were drawn before of the very same content by
/// the same code, otherwise drawn now on all cores and kept there. `sceneName` is the file's name,
/// `sceneHash` tells its content. Throws Error(kBadInput) where the file that is kept is of another
/// view or broken, Error(kJobFailed) where it cannot be written.
ReferenceBeams obtainReference(const std::filesystem::path& folder, const Scene& scene,
                               const std::string& sceneName, const std::string& sceneHash,
                               const ReferenceSettings& settings);

/// The same, the whole picture: R, G, B.
struct KeptReference {
    RgbPicture picture;  ///< cd/m2
    ReferenceFacts facts;
    std::filesystem::path file;
};
KeptReference obtainReferencePicture(const std::filesystem::path& folder, const Scene& scene,
                                     const std::string& sceneName, const std::string& sceneHash,
                                     const ReferenceSettings& settings);

/// Changes whenever the code changes that references are drawn by.
const char* referenceRevision();

}  // namespace ribalta
