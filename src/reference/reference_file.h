// References as files: an EXR that says of itself what it is a reference of, so that a picture of
// another view is not measured against it.
#pragma once

#include <filesystem>
#include <string>

#include "image/image.h"
#include "reference/reference_picture.h"

namespace ribalta {

/// What a reference was drawn of and how. Two pictures are of the same view where all of these are
/// equal: numbers stand in the texts with all their digits.
struct ReferenceView {
    std::string scene;  ///< the file's name without its folders
    std::string size;   ///< WxH
    std::string camera;
    std::string haze;
    std::string ambient;
    std::string visibility;       ///< "geometry" or "shadow-map"
    std::string sky = "none";     ///< as describeSky()
    std::string skyAir = "none";  ///< as describeAir()
};

/// What a reference says of itself.
struct ReferenceFacts {
    ReferenceView view;
    double largestError = 0.0;  ///< as ReferencePicture has them
    double rmsError = 0.0;
    SkyError skyError;
};

struct ReferenceFile {
    FloatImage image;
    ReferenceFacts facts;
};

/// Under this name a picture says which sky is over it; without one, a reference says "none".
inline constexpr const char* kSkyFact = "sky";
/// Its sun, altitude and orders, with all digits.
std::string describeSky(const SkyOverScene& sky);
/// Under this name, which air it is of.
inline constexpr const char* kSkyAirFact = "sky_air";
/// With all digits.
std::string describeAir(const Atmosphere& air);

/// What is known before anything is drawn. `scene` is the file's name without its folders.
ReferenceView describeReference(const std::string& scene, const ReferenceSettings& settings);

/// Layers besides R, G, B and beams.R, .G, .B.
struct ReferenceLayers {
    bool transmittance = false;  ///< of the haze before the surface
    bool depth = false;          ///< Z
};

/// The picture as `ribalta render` writes one, with the facts of it.
FloatImage referenceImage(const ReferencePicture& picture, const ReferenceSettings& settings,
                          const ReferenceView& view, const ReferenceLayers& layers);

/// Reads a reference that must be of the view that `wanted` describes. Throws Error(kBadInput) that
/// names the file and the first thing that differs, and how to draw it anew, or says that the
/// picture is no reference.
ReferenceFile readReference(const std::filesystem::path& path, const ReferenceView& wanted);

}  // namespace ribalta
