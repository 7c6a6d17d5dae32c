// What the tables of the literature's skies take.
#include "render/baseline_sky_settings.h"

namespace ribalta {
namespace {

std::uint64_t bytesOf(const SkyPlaneSize& size) {
    return 16 * std::uint64_t(size.across) * std::uint64_t(size.heights);
}

}  // namespace

SkyTableBytes skyTableBytes(const PrecomputedSkySettings& settings) {
    const SkyVolumeSize& size = settings.scattering;
    const std::uint64_t volume = (settings.halfFloats ? 8 : 16) * std::uint64_t(size.heights) *
                                 std::uint64_t(size.viewAngles) * std::uint64_t(size.suns) *
                                 std::uint64_t(size.sunAngles);
    const std::uint64_t irradiance = settings.simplified ? 0 : bytesOf(settings.irradiance);
    SkyTableBytes bytes;
    bytes.kept = 2 * volume + bytesOf(settings.transmittance) + irradiance;
    bytes.peak = bytes.kept + irradiance + (settings.orders > 1 ? 2 * volume : 0) +
                 (settings.exactTexels ? bytesOf(kExactTransmittance) : 0);
    return bytes;
}

}  // namespace ribalta
