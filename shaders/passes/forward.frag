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
#include "lib/environment.glsl"
#ifdef LAYERS
#include "lib/layers.glsl"
#endif
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
layout(std140, binding = kMaterialSlot) uniform MaterialBlock { SurfaceMaterial material; };
#ifdef LAYERS
layout(std430, binding = kSurfaceLayersSlot) readonly buffer LayersBlock { SurfaceLayers layers[]; };
layout(binding = kLayerTexturesUnit) uniform sampler2D layerTextures[kLayerTextures];
#endif
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
#ifdef LAYERS
    LayeredSurface layered;
    vec3 tangent;    // of anisotropy
    vec3 bitangent;
    vec3 coatNormal;
#endif
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

#ifdef TEXTURES
/// The normal that a normal map's texel bends, within the vertex's tangent space.
vec3 bentNormal(vec3 normal, vec3 texel, float scale) {
    vec3 bump = 2.0 * texel - 1.0;
    bump.xy *= scale;
    vec3 tangent = viewTangent.xyz - normal * dot(normal, viewTangent.xyz);
    if (dot(tangent, tangent) <= 1.0e-12 || dot(bump, bump) <= 0.0) {
        return normal;
    }
    tangent = normalize(tangent);
    vec3 outside = gl_FrontFacing ? normal : -normal;
    vec3 bitangent = cross(outside, tangent) * viewTangent.w;
    return normalize(bump.x * tangent + bump.y * bitangent + bump.z * normal);
}
#endif

#ifdef LAYERS
vec4 sampleLayer(SurfaceLayers given, int index) {
    vec3 uv = vec3((given.flags.z & (1 << index)) != 0 ? secondUv : firstUv, 1.0);
    vec2 place = vec2(dot(given.uvRows[2 * index].xyz, uv),
                      dot(given.uvRows[2 * index + 1].xyz, uv));
    // The array is indexed by constants only, as OpenGL asks for.
    switch (index) {
        case kSpecularTexture: return texture(layerTextures[0], place);
        case kSpecularColorTexture: return texture(layerTextures[1], place);
        case kClearcoatTexture: return texture(layerTextures[2], place);
        case kClearcoatRoughnessTexture: return texture(layerTextures[3], place);
        case kClearcoatNormalTexture: return texture(layerTextures[4], place);
        case kSheenColorTexture: return texture(layerTextures[5], place);
        case kSheenRoughnessTexture: return texture(layerTextures[6], place);
        case kAnisotropyTexture: return texture(layerTextures[7], place);
        default: return texture(layerTextures[8], place);
    }
}

bool hasLayer(SurfaceLayers given, int index) { return (given.flags.y & (1 << index)) != 0; }

/// Turns the tangent to where the surface is rougher; without a tangent there is no such way.
void readAnisotropy(SurfaceLayers given, inout Surface surface) {
    surface.layered.anisotropy = given.anisotropy.x;
    vec2 way = given.anisotropy.yz;
    if (hasLayer(given, kAnisotropyTexture)) {
        vec3 texel = sampleLayer(given, kAnisotropyTexture).rgb;
        vec2 turned = 2.0 * texel.rg - 1.0;
        way = vec2(turned.x * way.x - turned.y * way.y, turned.x * way.y + turned.y * way.x);
        surface.layered.anisotropy *= texel.b;
    }
    vec3 tangent = viewTangent.xyz - surface.normal * dot(surface.normal, viewTangent.xyz);
    if (dot(tangent, tangent) <= 1.0e-12 || dot(way, way) <= 1.0e-12) {
        surface.layered.anisotropy = 0.0;
        surface.tangent = vec3(0.0);
        surface.bitangent = vec3(0.0);
        return;
    }
    tangent = normalize(tangent);
    vec3 outside = gl_FrontFacing ? surface.normal : -surface.normal;
    vec3 bitangent = cross(outside, tangent) * viewTangent.w;
    surface.tangent = normalize(way.x * tangent + way.y * bitangent);
    surface.bitangent = cross(surface.normal, surface.tangent);
}

/// `smooth`: the normal without the normal map.
void readLayers(vec3 smoothNormal, inout Surface surface) {
    SurfaceLayers given = layers[material.flags.w];
    vec3 specularColor = given.specular.rgb;
    float specular = given.specular.w;
    float coat = given.coat.x;
    float coatRoughness = given.coat.y;
    vec3 sheenColor = given.sheen.rgb;
    float sheenRoughness = given.sheen.w;
    float transmission = given.anisotropy.w;
    surface.coatNormal = smoothNormal;
    if (hasLayer(given, kSpecularTexture)) {
        specular *= sampleLayer(given, kSpecularTexture).a;
    }
    if (hasLayer(given, kSpecularColorTexture)) {
        vec4 texel = sampleLayer(given, kSpecularColorTexture);
        specularColor *= texel.rgb;
        if ((given.flags.x & kGlossinessFlag) != 0) {
            surface.roughness = 1.0 - (1.0 - surface.roughness) * texel.a;
        }
    }
    if (hasLayer(given, kClearcoatTexture)) {
        coat *= sampleLayer(given, kClearcoatTexture).r;
    }
    if (hasLayer(given, kClearcoatRoughnessTexture)) {
        coatRoughness *= sampleLayer(given, kClearcoatRoughnessTexture).g;
    }
    if (hasLayer(given, kClearcoatNormalTexture)) {
        surface.coatNormal = bentNormal(
            smoothNormal, sampleLayer(given, kClearcoatNormalTexture).rgb, given.coat.z);
    }
    if (hasLayer(given, kSheenColorTexture)) {
        sheenColor *= sampleLayer(given, kSheenColorTexture).rgb;
    }
    if (hasLayer(given, kSheenRoughnessTexture)) {
        sheenRoughness *= sampleLayer(given, kSheenRoughnessTexture).a;
    }
    if (hasLayer(given, kTransmissionTexture)) {
        transmission *= sampleLayer(given, kTransmissionTexture).r;
    }
    surface.layered.baseColor = surface.baseColor;
    surface.layered.metallic = surface.metallic;
    surface.layered.roughness = surface.roughness;
    surface.layered.dielectricF0 = specular * min(given.coat.w * specularColor, vec3(1.0));
    surface.layered.specular = specular;
    surface.layered.sheenColor = sheenColor;
    surface.layered.sheenRoughness = sheenRoughness;
    surface.layered.coat = coat;
    surface.layered.coatRoughness = coatRoughness;
    surface.layered.transmission = transmission;
    readAnisotropy(given, surface);
}
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
    if (dot(viewNormal, viewNormal) > 0.0) {
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
#ifdef LAYERS
    vec3 smoothNormal = surface.normal;
#endif
    if (has(kNormalTexture)) {
        surface.normal = bentNormal(surface.normal, sampleTexture(kNormalTexture).rgb,
                                    material.factors.z);
    }
#ifdef LAYERS
    readLayers(smoothNormal, surface);
#endif
#endif
    return surface;
}

/// The light of one candela-lux from a direction that the surface sends to the eye, cosine included.
vec3 reflected(Surface surface, vec3 towardsLamp) {
#if defined(LAYERS) && !defined(ILLUMINANCE)
    return layeredReflection(surface.layered, surface.normal, surface.tangent, surface.bitangent,
                             surface.coatNormal, towardsLamp, surface.towardsEye);
#endif
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

/// Even light from all around, a little less from below; that of the environment, and of the sky.
vec3 ambientLight(Surface surface) {
    vec3 specular = mix(vec3(0.04), surface.baseColor, surface.metallic);
    vec3 albedo = surface.baseColor * (1.0 - surface.metallic) + specular;
    float fromAbove = 0.75 + 0.25 * dot(surface.normal, view.upAmbient.xyz);
    vec3 light = vec3(view.upAmbient.w * fromAbove);
    if (view.lampCounts.w != 0) {
        light += environmentLux(surface.normal, view.environment[0], view.environment[1],
                                view.environment[2]);
    }
#ifdef SKY
    light += daylight(surface.normal);
#endif
#ifdef ILLUMINANCE
    return light;
#endif
#ifdef LAYERS
    albedo = layeredAlbedo(surface.layered, max(dot(surface.normal, surface.towardsEye), 0.0),
                           max(dot(surface.coatNormal, surface.towardsEye), 0.0));
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

#ifdef SEEN_THROUGH
    vec3 kept = seenThrough(surface.layered, max(dot(surface.normal, surface.towardsEye), 0.0),
                            max(dot(surface.coatNormal, surface.towardsEye), 0.0));
    kept = mix(vec3(1.0), kept, surface.alpha);
    radiance = vec4(kept, 1.0 - (kept.r + kept.g + kept.b) / 3.0);
#ifdef NORMAL_OUTPUT
    normalOutput = vec4(1.0, 1.0, 1.0, 0.0);
#endif
    return;
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
#ifdef LAYERS
    // Added to what is seen through it, where anything is.
    if (layers[material.flags.w].anisotropy.w > 0.0) {
        radiance = vec4(radiance.rgb * surface.alpha, 0.0);
    }
#endif
#ifdef NORMAL_OUTPUT
    normalOutput = vec4(surface.normal, 1.0);
#ifdef LAYERS
    // What is seen through it keeps its own.
    if (layers[material.flags.w].anisotropy.w > 0.0) {
        normalOutput = vec4(0.0);
    }
#endif
#endif
}
