// How much of the stage's haze a view ray meets: under a sky it does not reach on for ever, but is a
// cloud around the lamps' beams. The including file declares the block `sky`.
#include "lib/haze_cloud.glsl"

const float kEndOfHaze = 1.0e6;  // metres

/// Metres as dense as at the stage on so many of a ray's metres, in view space.
float metresOfHaze(vec3 origin, vec3 direction, float metres) {
    if (sky.hazePerMetre.w < 0.5) {
        return 0.0;
    }
    vec3 from = (sky.worldFromView * vec4(origin, 1.0)).xyz - sky.hazeMiddle.xyz;
    return hazeCloudMetres(from, mat3(sky.worldFromView) * direction, sky.hazePerMetre.xyz, metres);
}
