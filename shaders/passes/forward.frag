// Surfaces: metallic-roughness shading under all lamps, seen through the haze. Writes luminance in
// cd/m2 by channel; with ILLUMINANCE what falls on them in lux by channel instead. Beams are added by a
// pass of their own.
#include "shared/slots.h"
#include "shared/view.h"
#include "shared/lamp.h"
#include "shared/surface.h"
#ifdef SKY
#include "shared/sky.h"
#endif
#include "lib/pi.glsl"
#include "lib/brdf.glsl"
#include "lib/haze.glsl"
#include "lib/spot_light.glsl"
#include "lib/shadow_projection.glsl"

layout(std140, binding = kViewSlot) uniform ViewBlock { View view; };
layout(std430, binding = kLampsSlot) readonly buffer SpotLamps { SpotLamp spotLamps[]; };
layout(std430, binding = kSpotConesSlot) readonly buffer SpotCones { SpotCone spotCones[]; };
layout(std430, binding = kPointLampsSlot) readonly buffer PointLamps { PointLamp pointLamps[]; };
layout(std430, binding = kDirectionalLampsSlot) readonly buffer DirectionalLamps {
    DirectionalLamp directionalLamps[];
};
layout(std140, binding = kDrawSlot) uniform DrawBlock { Draw draw; };
layout(std140, binding = kMaterialSlot) uniform MaterialBlock { SurfaceMaterial material; };
#ifdef SKY
layout(std140, binding = kSkySlot) uniform SkyBlock { SkyFrame sky; };
#include "passes/sky_haze.glsl"
#endif
#ifdef SUN_SHADOW
#include "shared/sun_shadow.h"
#include "passes/sun_shadow.glsl"
#endif
layout(binding = kShadowMapsUnit) uniform sampler2DArrayShadow shadowMaps;
layout(binding = kLightMapsUnit) uniform sampler2DArray lightMaps;

in vec3 viewPosition;
in vec3 viewNormal;
in vec4 vertexColor;
#ifdef TEXTURES
layout(binding = kMaterialTexturesUnit) uniform sampler2D materialTextures[kMaterialTextures];
in vec4 viewTangent;
in vec2 firstUv;
in vec2 secondUv;
#endif

layout(location = 0) out vec4 radiance;
#ifdef NORMAL_OUTPUT
layout(location = 1) out vec4 normalOutput;
#endif

struct Surface {
    vec3 baseColor;
    float alpha;
    float metallic;
    float roughness;
    vec3 normal;     // shading, towards the eye
    vec3 geometric;  // of the triangle, towards the eye
    vec3 towardsEye;
    float occlusion;
    vec3 emission;
};

#ifdef TEXTURES
vec4 sampleTexture(int index) {
    vec3 uv = vec3((material.flags.z & (1 << index)) != 0 ? secondUv : firstUv, 1.0);
    vec2 place = vec2(dot(material.uvRows[2 * index].xyz, uv),
                      dot(material.uvRows[2 * index + 1].xyz, uv));
    // The array is indexed by constants only, as OpenGL asks for.
    if (index == kBaseColorTexture) {
        return texture(materialTextures[0], place);
    }
    if (index == kMetallicRoughnessTexture) {
        return texture(materialTextures[1], place);
    }
    if (index == kNormalTexture) {
        return texture(materialTextures[2], place);
    }
    if (index == kOcclusionTexture) {
        return texture(materialTextures[3], place);
    }
    return texture(materialTextures[4], place);
}

bool has(int index) { return (material.flags.y & (1 << index)) != 0; }
#endif

Surface readSurface() {
    Surface surface;
    surface.baseColor = material.baseColor.rgb * vertexColor.rgb;
    surface.alpha = material.baseColor.a * vertexColor.a;
    surface.metallic = material.factors.x;
    surface.roughness = material.factors.y;
    surface.occlusion = 1.0;
    surface.emission = material.emission.rgb;
    surface.towardsEye =
        view.halfExtent.z > 0.5 ? vec3(0.0, 0.0, 1.0) : normalize(-viewPosition);

    vec3 geometric = cross(dFdx(viewPosition), dFdy(viewPosition));
    float size = length(geometric);
    geometric = size > 0.0 ? geometric / size : surface.towardsEye;
    surface.geometric = dot(geometric, surface.towardsEye) < 0.0 ? -geometric : geometric;
    surface.normal = surface.geometric;
    if (draw.flags.x != 0 && dot(viewNormal, viewNormal) > 0.0) {
        vec3 normal = normalize(viewNormal);
        surface.normal = gl_FrontFacing ? normal : -normal;
    }
#ifdef TEXTURES
    if (has(kBaseColorTexture)) {
        vec4 texel = sampleTexture(kBaseColorTexture);
        surface.baseColor *= texel.rgb;
        surface.alpha *= texel.a;
    }
    if (has(kMetallicRoughnessTexture)) {
        vec4 texel = sampleTexture(kMetallicRoughnessTexture);
        surface.metallic *= texel.b;
        surface.roughness *= texel.g;
    }
    if (has(kOcclusionTexture)) {
        float occlusion = sampleTexture(kOcclusionTexture).r;
        surface.occlusion = 1.0 + material.factors.w * (occlusion - 1.0);
    }
    if (has(kEmissiveTexture)) {
        surface.emission *= sampleTexture(kEmissiveTexture).rgb;
    }
    if (has(kNormalTexture)) {
        vec3 bump = 2.0 * sampleTexture(kNormalTexture).rgb - 1.0;
        bump.xy *= material.factors.z;
        vec3 tangent = viewTangent.xyz - surface.normal * dot(surface.normal, viewTangent.xyz);
        if (dot(tangent, tangent) > 1.0e-12 && dot(bump, bump) > 0.0) {
            tangent = normalize(tangent);
            vec3 outside = gl_FrontFacing ? surface.normal : -surface.normal;
            vec3 bitangent = cross(outside, tangent) * viewTangent.w;
            vec3 bent = bump.x * tangent + bump.y * bitangent + bump.z * surface.normal;
            surface.normal = normalize(bent);
        }
    }
#endif
    return surface;
}

/// The light of one candela-lux from a direction that the surface sends to the eye, cosine included.
vec3 reflected(Surface surface, vec3 towardsLamp) {
    float nDotL = dot(surface.normal, towardsLamp);
    if (nDotL <= 0.0) {
        return vec3(0.0);
    }
#ifdef ILLUMINANCE
    return vec3(nDotL);
#else
    // A shading normal may look away from the eye near a silhouette; light it as if edge on.
    float nDotV = max(dot(surface.normal, surface.towardsEye), 1.0e-4);
    vec3 halfway = normalize(towardsLamp + surface.towardsEye);
    return nDotL * metallicRoughnessBrdf(surface.baseColor, surface.metallic, surface.roughness,
                                         nDotL, nDotV, clamp(dot(surface.normal, halfway), 0.0, 1.0),
                                         clamp(dot(surface.towardsEye, halfway), 0.0, 1.0));
#endif
}

/// 0..1: how much of the lamp the point sees, over 3x3 texels with a smooth edge. The point is moved
/// off the surface by what a texel covers there, so that the surface does not shade itself.
float shadowOnSurface(SpotLamp lamp, vec3 place, Surface surface) {
    vec3 normal = mat3(lamp.lampFromView) * surface.geometric;
    vec3 towardsLamp = -normalize(place);
    float cosine = dot(normal, towardsLamp);
    // Lit from the side that faces the lamp, whichever the eye sees.
    normal = cosine < 0.0 ? -normal : normal;
    float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    float texel = lamp.shadow.z * place.z;
    vec3 moved = place + normal * (texel * (0.5 + 2.0 * sine)) + towardsLamp * texel;
    if (moved.z <= lamp.shadow.y) {
        return 1.0;
    }
    vec3 at = shadowCoordinates(moved.xy / moved.z, 1.0 / moved.z, lamp.shadow.x, lamp.shadow.y);
    float layer = float(lamp.layers.x);
    // Four bilinear taps half a texel out make a 3x3 tent.
    float step = 0.5 / lamp.shadow.w;
    float sum = 0.0;
    sum += texture(shadowMaps, vec4(at.x - step, at.y - step, layer, at.z));
    sum += texture(shadowMaps, vec4(at.x + step, at.y - step, layer, at.z));
    sum += texture(shadowMaps, vec4(at.x - step, at.y + step, layer, at.z));
    sum += texture(shadowMaps, vec4(at.x + step, at.y + step, layer, at.z));
    return 0.25 * sum;
}

/// Colour of the light map towards a point, filtered over what the pixel sees of it.
vec3 lightMapOnSurface(SpotLamp lamp, vec3 place, vec3 placeDx, vec3 placeDy) {
    vec2 slope = place.xy / place.z;
    vec2 slopeDx = (placeDx.xy - slope * placeDx.z) / place.z;
    vec2 slopeDy = (placeDy.xy - slope * placeDy.z) / place.z;
    float texels = 0.5 * lamp.projection.x * float(lamp.layers.z);
    float footprint = texels * texels * max(dot(slopeDx, slopeDx), dot(slopeDy, slopeDy));
    vec2 uv = lightMapUv(slope, lamp.projection.x, lamp.projection.y, lamp.projection.z);
    return textureLod(lightMaps, vec3(uv, float(lamp.layers.y)),
                      0.5 * log2(max(footprint, 1.0e-8))).rgb;
}

/// Whether the cone around a spot's beam holds the point.
bool inCone(int index) {
    vec3 place = viewPosition - spotCones[index].apex.xyz;
    float depth = dot(place, spotCones[index].axis.xyz);
    return depth > kLensMetres && depth * depth > spotCones[index].apex.w * dot(place, place);
}

vec3 litBySpot(SpotLamp lamp, Surface surface, vec3 positionDx, vec3 positionDy) {
    vec3 place = (lamp.lampFromView * vec4(viewPosition, 1.0)).xyz;
    float distanceMetres = length(place);
    bool inSquare = max(abs(place.x), abs(place.y)) * lamp.projection.x < place.z;
    float falloff = lamp.projection.w > 0.5
                        ? float(inSquare)
                        : coneFalloff(place.z / distanceMetres, lamp.cone.x, lamp.cone.y);
    vec3 towardsLamp = -normalize(transpose(mat3(lamp.lampFromView)) * place);
    vec3 light = reflected(surface, towardsLamp) * lamp.candela.rgb *
                 (falloff * rangeWindow(distanceMetres, lamp.candela.w) *
                  inverseSquare(distanceMetres) * transmittance(view.haze.y, distanceMetres));
    if (lamp.layers.x >= 0) {
        light *= shadowOnSurface(lamp, place, surface);
    }
    if (lamp.layers.y >= 0) {
        light *= lightMapOnSurface(lamp, place, mat3(lamp.lampFromView) * positionDx,
                                   mat3(lamp.lampFromView) * positionDy);
    }
    return light;
}

/// All spots. Most miss most points, so each point first looks for the next lamp that holds it: a
/// processor that runs both sides of a branch still spends nothing on the others.
vec3 litBySpots(Surface surface, vec3 positionDx, vec3 positionDy) {
    vec3 sum = vec3(0.0);
    int index = 0;
    while (true) {
        while (index < view.lampCounts.x && !inCone(index)) {
            ++index;
        }
        if (index >= view.lampCounts.x) {
            break;
        }
        sum += litBySpot(spotLamps[index], surface, positionDx, positionDy);
        ++index;
    }
    return sum;
}

vec3 litByPoint(PointLamp lamp, Surface surface) {
    vec3 towardsLamp = lamp.position.xyz - viewPosition;
    float distanceMetres = length(towardsLamp);
    if (distanceMetres <= 0.0) {
        return vec3(0.0);
    }
    float attenuation = rangeWindow(distanceMetres, lamp.position.w) * inverseSquare(distanceMetres) *
                        transmittance(view.haze.y, distanceMetres);
    return reflected(surface, towardsLamp / distanceMetres) * lamp.candela.rgb * attenuation;
}

#ifdef SKY
/// Irradiance by sky and ground: exact along the axes up, to the sun and across, in between by the
/// squares of the cosines, which sum up to 1.
vec3 daylight(vec3 normal) {
    float up = dot(normal, view.upAmbient.xyz);
    float sunward = dot(normal, sky.sunward.xyz);
    float across = max(1.0 - up * up - sunward * sunward, 0.0);
    return up * up * sky.irradiance[up > 0.0 ? 0 : 1].rgb +
           sunward * sunward * sky.irradiance[sunward > 0.0 ? 2 : 3].rgb +
           across * sky.irradiance[4].rgb;
}
#endif

/// Even light from all around, a little less from below; and that of the sky.
vec3 ambientLight(Surface surface) {
    vec3 specular = mix(vec3(0.04), surface.baseColor, surface.metallic);
    vec3 albedo = surface.baseColor * (1.0 - surface.metallic) + specular;
    float fromAbove = 0.75 + 0.25 * dot(surface.normal, view.upAmbient.xyz);
    vec3 light = vec3(view.upAmbient.w * fromAbove);
#ifdef SKY
    light += daylight(surface.normal);
#endif
#ifdef ILLUMINANCE
    return light;
#endif
    return albedo * light * (kInversePi * surface.occlusion);
}

void main() {
    vec3 positionDx = dFdx(viewPosition);
    vec3 positionDy = dFdy(viewPosition);
    Surface surface = readSurface();
#ifdef ALPHA_MASK
    if (surface.alpha < material.emission.w) {
        discard;
    }
    surface.alpha = 1.0;
#endif

#ifdef ILLUMINANCE
    surface.emission = vec3(0.0);
    surface.alpha = 1.0;
    bool unlit = false;
#else
    bool unlit = (material.flags.x & kUnlitFlag) != 0;
#endif

    vec3 sum;
    if (unlit) {
        sum = surface.baseColor;
    } else {
        sum = surface.emission + ambientLight(surface) +
              litBySpots(surface, positionDx, positionDy);
        for (int i = 0; i < view.lampCounts.y; ++i) {
            sum += litByPoint(pointLamps[i], surface);
        }
        for (int i = 0; i < view.lampCounts.z; ++i) {
            vec3 light = reflected(surface, directionalLamps[i].towardsLamp.xyz) *
                         directionalLamps[i].lux.rgb;
#ifdef SUN_SHADOW
            // The sun is the last one.
            if (i == view.lampCounts.z - 1 && light != vec3(0.0)) {
                light *= sunOnSurface(viewPosition, surface.geometric);
            }
#endif
            sum += light;
        }
    }
    float eyeMetres = view.halfExtent.z > 0.5 ? -viewPosition.z : length(viewPosition);
#ifdef SKY
    vec3 origin = view.halfExtent.z > 0.5 ? vec3(viewPosition.xy, 0.0) : vec3(0.0);
    eyeMetres = metresOfHaze(origin, -surface.towardsEye, eyeMetres);
#endif
#ifdef ILLUMINANCE
    radiance = vec4(sum, 1.0);
#else
    radiance = vec4(sum * transmittance(view.haze.y, eyeMetres), surface.alpha);
#endif
#ifdef NORMAL_OUTPUT
    normalOutput = vec4(surface.normal, 1.0);
#endif
}
