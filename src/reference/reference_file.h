// References as files: an EXR that says of itself what it is a reference of, so that a picture of
// another view is not measured against it.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "image/image.h"
#include "reference/reference_picture.h"

namespace ribalta {

/// What a reference was drawn of and how, by name: "scene", "size", "camera", "haze", "ambient",
/// "visibility" must be equal for two pictures to be of the same view; "error" and "version" tell
/// of the reference itself. As text, numbers with all their digits.
using ReferenceFacts = std::map<std::string, std::string>;

/// What is known before anything is drawn. `scene` is the file's name without its folders.
ReferenceFacts describeReference(const std::string& scene, const ReferenceSettings& settings);

/// Layers besides R, G, B and beams.R, .G, .B.
struct ReferenceLayers {
    bool transmittance = false;  ///< of the haze before the surface
    bool depth = false;          ///< Z
};

/// The picture as `ribalta render` writes one, with its facts, the error reached among them.
FloatImage referenceImage(const ReferencePicture& picture, const ReferenceSettings& settings,
                          ReferenceFacts facts, const ReferenceLayers& layers);

/// Reads a reference that must be of the view that `wanted` describes. Throws Error(kBadInput) that
/// names the file and the first fact that differs, and how to draw it anew, or says that the
/// picture is no reference.
FloatImage readReference(const std::filesystem::path& path, const ReferenceFacts& wanted);

}  // namespace ribalta
