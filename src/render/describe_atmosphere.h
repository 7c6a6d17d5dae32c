// An atmosphere as the shaders take it (shared/atmosphere.h).
#pragma once

#include <shared/atmosphere.h>

#include "scene/atmosphere.h"

namespace ribalta {

gpu::Atmosphere describeAtmosphere(const Atmosphere& atmosphere);

}  // namespace ribalta
