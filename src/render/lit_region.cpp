#include "render/lit_region.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "render/lamp_reach.h"
#include "render/upload_image.h"

namespace ribalta {
namespace {

// A texel's light reaches one texel beyond its centre through bilinear filtering, another where the
// picture is first stretched to its layer, and half of one where it is shrunk.
constexpr double kFilterTexels = 2.5;
// Between the sheets of a beam light maps are filtered over more than a texel: a margin of the
// cone's width in which that has faded, from two dozen sheets a beam on.
constexpr double kSheetShare = 0.06;

template <typename Channel>
bool isLit(const std::byte* pixel) {
    Channel channels[3];
    std::memcpy(channels, pixel, sizeof channels);
    // Not a number counts as lit: it is not ours to hide.
    return channels[0] != 0 || channels[1] != 0 || channels[2] != 0;
}

// First and last lit texel of a row; first > last where it is black.
struct Run {
    int first = 0;
    int last = -1;
};

template <typename Channel>
Run litRun(const Image& image, int y) {
    const std::size_t size = image.bytesPerPixel();
    const std::byte* row = &image.pixels[std::size_t(y) * std::size_t(image.width) * size];
    Run run{0, image.width - 1};
    while (run.first <= run.last && !isLit<Channel>(row + std::size_t(run.first) * size)) {
        ++run.first;
    }
    while (run.first < run.last && !isLit<Channel>(row + std::size_t(run.last) * size)) {
        --run.last;
    }
    return run;
}

}  // namespace

LitRegion litRegion(const Image& lightMap) {
    LitRegion region;
    if (lightMap.pixels.empty()) {
        return region;
    }
    region = {true, glm::dvec2(2.0), glm::dvec2(-2.0), 0.0};
    const glm::dvec2 size(lightMap.width, lightMap.height);
    const glm::dvec2 reach =
        2.0 * kFilterTexels / glm::min(size, glm::dvec2(double(kMaxLayerSide)));
    for (int y = 0; y < lightMap.height; ++y) {
        const Run run = lightMap.type == Image::Type::kUint8 ? litRun<std::uint8_t>(lightMap, y)
                                                             : litRun<float>(lightMap, y);
        if (run.first > run.last) {
            continue;
        }
        region.isDark = false;
        for (const int x : {run.first, run.last}) {
            const glm::dvec2 centre(2.0 * (x + 0.5) / size.x - 1.0, 1.0 - 2.0 * (y + 0.5) / size.y);
            region.low = glm::min(region.low, centre - reach);
            region.high = glm::max(region.high, centre + reach);
            region.radius = std::max(region.radius, glm::length(glm::abs(centre) + reach));
        }
    }
    region.low = glm::max(region.low, glm::dvec2(-1.0));
    region.high = glm::min(region.high, glm::dvec2(1.0));
    region.radius = std::min(region.radius, LitRegion().radius);
    return region;
}

void addLitRegions(const Scene& scene, LitRegions& regions) {
    for (const SpotLight& lamp : scene.spotLights) {
        if (lamp.lightMap && !regions.contains(lamp.lightMap->image)) {
            regions.emplace(lamp.lightMap->image,
                            litRegion(scene.images[std::size_t(lamp.lightMap->image)]));
        }
    }
}

LitRegions litRegions(const Scene& scene) {
    LitRegions regions;
    addLitRegions(scene, regions);
    return regions;
}

SpotLight litPart(const SpotLight& lamp, const LitRegions& regions) {
    const auto found = lamp.lightMap ? regions.find(lamp.lightMap->image) : regions.end();
    if (found == regions.end()) {
        return lamp;
    }
    SpotLight part = lamp;
    const LitRegion& region = found->second;
    if (region.isDark) {
        part.intensityCandela = 0.0;
        return part;
    }
    double share = region.radius;
    if (lamp.beamShape == BeamShape::kPyramid) {
        // A turned picture does not fill the pyramid: its outermost texels go on to the corners.
        const bool reachesEdge = region.low.x <= -1.0 || region.low.y <= -1.0 ||
                                 region.high.x >= 1.0 || region.high.y >= 1.0;
        const double c = std::cos(lamp.lightMap->rotationRadians);
        const double s = std::sin(lamp.lightMap->rotationRadians);
        share = reachesEdge ? 1.0 : 0.0;
        for (const double x : {region.low.x, region.high.x}) {
            for (const double y : {region.low.y, region.high.y}) {
                share = std::max({share, std::abs(c * x - s * y), std::abs(s * x + c * y)});
            }
        }
    }
    share += kSheetShare;
    if (share < 1.0) {
        part.outerConeAngle = std::atan(share * std::tan(drawnConeAngle(lamp)));
    }
    return part;
}

}  // namespace ribalta
