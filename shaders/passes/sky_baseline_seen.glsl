// The sky, and the air in front of surfaces, by a model of the literature: asked for at every pixel.
#include "passes/sky_baseline.glsl"

/// The ray in a view direction as the models take it; false where it passes the air by.
bool viewRayInAir(Air air, vec3 direction, OUT(vec4) ray, OUT(float) entry) {
    ray = vec4(sky.zenith.w, clamp(dot(direction, sky.zenith.xyz), -1.0, 1.0), sky.sun.w,
               clamp(dot(direction, sky.sun.xyz), -1.0, 1.0));
    return intoAir(air, ray, zenithSine(direction), entry);
}

/// For a sun of irradiance 1; nothing of it is left out.
vec3 seenSky(Air air, vec3 direction, OUT(bool) ground, OUT(bool) edge) {
    ground = false;
    edge = false;
    vec4 ray;
    float entry;
    if (!viewRayInAir(air, direction, ray, entry)) {
        return vec3(0.0);
    }
    ground = hitsGround(air, ray.x, ray.y);
    float way = distanceInAir(air, ray.x, ray.y, ground);
    vec3 through;
    vec3 light;
    skyAlong(air, ray, way, ground, false, through, light);
    if (ground) {
        float muS = sunCosineAlong(air, ray.x, ray.z, ray.w, way, 0.0);
        light += through * atmosphere.albedo.rgb * kInversePi * groundIrradiance(air, muS);
    }
    return light;
}

/// Dims `color` by the air in front of it and adds the air's light.
vec3 throughAir(Air air, vec3 color, vec2 uv, vec3 direction, float metres) {
    vec4 ray;
    float entry;
    if (!viewRayInAir(air, direction, ray, entry) || entry >= metres) {
        return color;
    }
    bool ground = hitsGround(air, ray.x, ray.y);
    float whole = distanceInAir(air, ray.x, ray.y, ground);
    float way = min(metres - entry, whole);
    vec3 through;
    vec3 light;
    skyAlong(air, ray, way, ground, way < whole, through, light);
    return color * through + light * atmosphere.sun.rgb;
}
