// What can be set about the sky's models that the literature has, and what one costs; plain data.
#pragma once

#include <cstdint>

namespace ribalta {

/// Counts of texels.
struct SkyPlaneSize {
    int across = 0;
    int heights = 0;

    bool operator==(const SkyPlaneSize&) const = default;
};
struct SkyVolumeSize {
    int heights = 0;
    int viewAngles = 0;  ///< even: half of them hit the ground
    int suns = 0;
    int sunAngles = 0;  ///< between ray and sun; 1: none told from others

    bool operator==(const SkyVolumeSize&) const = default;
};

/// A table takes at most 4096 texels a side; its volume is suns * sunAngles texels wide.
struct PrecomputedSkySettings {
    /// Of the simplified variant, after the 2008 code: light scattered once alone, its mappings,
    /// no table of irradiance. Otherwise Bruneton & Neyret 2008 as described in 2017.
    bool simplified = false;
    /// Light scattered once integrated well at the texels, so that what is off is what their
    /// interpolation loses. Otherwise as the published code makes them: from its table of
    /// transmittance, in 50 steps.
    bool exactTexels = false;
    int orders = 4;          ///< how often light may have been scattered; 1 for `simplified`
    bool halfFloats = true;  ///< volumes of 16-bit floats, as published; otherwise of 32
    SkyPlaneSize transmittance{256, 64};
    SkyVolumeSize scattering{32, 128, 32, 8};
    SkyPlaneSize irradiance{64, 16};
    float lowestSun = -0.2079117F;  ///< cosine; 102 degrees from the zenith

    bool operator==(const PrecomputedSkySettings&) const = default;
};

/// Of the table of transmittance by which exact texels are made.
inline constexpr SkyPlaneSize kExactTransmittance{512, 128};

/// What the tables take in memory.
struct SkyTableBytes {
    std::uint64_t kept = 0;  ///< of those that pictures read
    std::uint64_t peak = 0;  ///< with those that only making them needs
};
SkyTableBytes skyTableBytes(const PrecomputedSkySettings& settings);

/// At the sizes of the thesis that proposed it.
inline PrecomputedSkySettings simplifiedSky() {
    PrecomputedSkySettings settings;
    settings.simplified = true;
    settings.exactTexels = true;
    settings.orders = 1;
    settings.scattering = {32, 64, 64, 4};
    return settings;
}

/// The sky without tables, after Schuler: Rayleigh alone, once scattered.
struct ChapmanSky {
    bool better = false;  ///< the better form of Chapman's function instead of Schuler's
    int segments = 64;    ///< of each ray, 1..4096

    bool operator==(const ChapmanSky&) const = default;
};

/// What making a sky's tables took, and what they hold.
struct SkyCost {
    std::uint64_t keptBytes = 0;  ///< of tables that pictures read
    std::uint64_t peakBytes = 0;  ///< with those that only making them needs
    double wallSeconds = 0.0;
    double cpuSeconds = 0.0;  ///< of all threads
    double gpuSeconds = 0.0;  ///< by the driver's time stamps
    int dispatches = 0;
};

}  // namespace ribalta
