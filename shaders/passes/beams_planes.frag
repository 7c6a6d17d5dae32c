// Beams, method `planes`: one lamp's light on one sampling plane, added to what is there.
#include "shared/slots.h"
#include "shared/view.h"
#include "shared/lamp.h"
#include "shared/beams.h"
#include "lib/haze.glsl"
#include "lib/spot_light.glsl"
#include "lib/phase_function.glsl"
#include "lib/beam_radiance.glsl"
#include "lib/shadow_projection.glsl"
#include "passes/beams_planes_factor.glsl"

layout(binding = kShadowMapsUnit) uniform sampler2DArrayShadow shadowMaps;
layout(binding = kLightMapsUnit) uniform sampler2DArray lightMaps;

in vec3 viewPosition;
#ifdef CELLS
in float smoothFactor;
#endif
#ifdef EIGHT_BIT
layout(location = 1) uniform float fullScale;  // cd/m2 that count as the highest code value
#endif
layout(location = 0) out vec4 radiance;
#if defined(BEAMS_OUTPUT) && !defined(EIGHT_BIT)
layout(location = 1) out vec4 beamsOutput;
#endif

vec3 sheetLight() {
    SpotLamp lamp = spotLamps[lampIndex];
    vec3 place = (lamp.lampFromView * vec4(viewPosition, 1.0)).xyz;
    float lampMetres = length(place);
    bool pyramid = lamp.projection.w > 0.5;
    if (place.z <= kLensMetres ||
        (pyramid ? max(abs(place.x), abs(place.y)) * lamp.projection.x > place.z
                 : place.z <= lamp.cone.y * lampMetres)) {
        return vec3(0.0);
    }
#ifdef CELLS
    float factor = smoothFactor;
#else
    float factor = sheetFactor(viewPosition);
#endif
    factor *= rangeWindow(lampMetres, lamp.candela.w);
    if (!pyramid) {
        factor *= coneFalloff(place.z / lampMetres, lamp.cone.x, lamp.cone.y);
    }
    vec2 slope = place.xy / place.z;
    if (lamp.layers.x >= 0) {
        vec3 at = shadowCoordinates(slope, 1.0 / place.z, lamp.shadow.x, lamp.shadow.y);
        factor *= texture(shadowMaps, vec4(at.xy, float(lamp.layers.x), at.z));
    }
    vec3 light = lamp.candela.rgb * lamp.towardsEye.rgb * factor;
#ifdef LIGHT_MAPS
    if (lamp.layers.y >= 0) {
        vec2 uv = lightMapUv(slope, lamp.projection.x, lamp.projection.y, lamp.projection.z);
        light *= textureLod(lightMaps, vec3(uv, float(lamp.layers.y)), 0.0).rgb;
    }
#endif
    return light;
}

void main() {
    vec3 light = sheetLight();
#ifdef EIGHT_BIT
    radiance = vec4(light / fullScale, 0.0);
#else
    radiance = vec4(light, 0.0);
#ifdef BEAMS_OUTPUT
    beamsOutput = vec4(light, 0.0);
#endif
#endif
}
