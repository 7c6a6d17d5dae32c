// The air of the sky's uniform block as the library's functions take it.
#include "shared/slots.h"
#include "shared/atmosphere.h"
#include "lib/air.glsl"
#include "lib/air_shell.glsl"

layout(std140, binding = kAtmosphereSlot) uniform AtmosphereBlock { Atmosphere atmosphere; };

Air readAir() {
    Air air;
    air.groundRadius = atmosphere.shell.x;
    air.top = atmosphere.shell.y;
    air.rayleighHeight = atmosphere.rayleigh.w;
    air.mieHeight = atmosphere.mieScattering.w;
    air.rayleighScattering = atmosphere.rayleigh.rgb;
    air.mieScattering = atmosphere.mieScattering.rgb;
    air.mieExtinction = atmosphere.mieExtinction.rgb;
    air.mieG = atmosphere.mieExtinction.w;
    return air;
}
