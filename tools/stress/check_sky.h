// What is checked of the sky under one set-up: the light of listed rays and small pictures, finite,
// not negative and without seams that the double-precision reference does not have.
#pragma once

#include <string>
#include <vector>

#include "sky_set_up.h"

namespace ribalta::stress {

struct SkyFindings {
    std::vector<std::string> faults;
    long long rays = 0;         ///< looked at
    double worstRays = 0.0;     ///< step of neighbouring rays, as a share of its bound
    double worstPicture = 0.0;  ///< the same of neighbouring pixels
    double worstSun = 0.0;      ///< the same of what the scene is lit with, as the sun rises
};

/// Needs a current context.
SkyFindings checkSky(const SkySetUp& setUp);

}  // namespace ribalta::stress
