#include "reference/surface_light.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "optics/shader_lib.h"

namespace ribalta {
namespace {

using Meaning = MaterialTextures::Meaning;

/// The normal that a normal map bends, `outside` being the front side's.
glm::dvec3 bentNormal(const glm::dvec3& normal, const glm::dvec3& outside,
                      const glm::dvec3& surfaceTangent, double handedness, glm::dvec3 bump,
                      double scale) {
    bump.x *= scale;
    bump.y *= scale;
    glm::dvec3 tangent = surfaceTangent - normal * glm::dot(normal, surfaceTangent);
    if (!(glm::dot(tangent, tangent) > 1e-12) || !(glm::dot(bump, bump) > 0.0)) {
        return normal;
    }
    tangent = glm::normalize(tangent);
    const glm::dvec3 bitangent = glm::cross(outside, tangent) * handedness;
    return glm::normalize(bump.x * tangent + bump.y * bitangent + bump.z * normal);
}

/// The light map at `place` in beam coordinates, filtered over what the pixel sees of the surface.
glm::dvec3 lightMapOn(const BeamLamp& lamp, const glm::dvec3& place, const ShadedPoint& point) {
    const glm::dvec2 slope = glm::dvec2(place) / place.z;
    double footprint = 0.0;
    for (const glm::dvec3& step : {point.acrossPixel, point.upPixel}) {
        const glm::dvec3 moved = lamp.toBeam(step);
        const glm::dvec2 change = (glm::dvec2(moved) - slope * moved.z) / place.z;
        footprint = std::max(footprint, glm::length(change));
    }
    return lamp.lightMap->at(lamp.lightMapUv(slope),
                             std::log2(std::max(lamp.lightMapTexels() * footprint, 1e-4)));
}

glm::dvec3 vertexNormal(const PlacedSurface& surface, const SurfaceHit& hit,
                        const glm::dvec3& geometric) {
    const Primitive& primitive = *surface.primitive;
    if (!primitive.normals.empty()) {
        const glm::dvec3 given =
            surface.worldFromNormal *
            blended(primitive.normals, surface.corners(hit.triangle), hit.weights);
        if (glm::dot(given, given) > 0.0) {
            return glm::normalize(given) * (hit.front ? 1.0 : -1.0);
        }
    }
    return geometric;
}

glm::dvec3 mappedNormal(const PlacedSurface& surface, const MaterialTextures& textures,
                        const SurfaceHit& hit, glm::dvec3 normal) {
    const Primitive& primitive = *surface.primitive;
    const auto corners = surface.corners(hit.triangle);
    const Material& material = *surface.material;
    if (material.normalTexture && !primitive.tangents.empty()) {
        const glm::dvec4 tangent = blended(primitive.tangents, corners, hit.weights);
        const glm::dvec3 bump =
            2.0 * glm::dvec3(textures.sample(*material.normalTexture, Meaning::kData, surface,
                                             hit.triangle, hit.weights)) -
            1.0;
        normal = bentNormal(normal, hit.front ? normal : -normal,
                            glm::dmat3(surface.worldFromLocal) * glm::dvec3(tangent), tangent.w,
                            bump, material.normalScale);
    }
    return normal;
}

shader::LayeredSurface layeredSurface(const ShadedPoint& point) {
    const PointLayers& layers = *point.layers;
    return {point.baseColor, point.metallic,       point.roughness,    layers.dielectricF0,
            layers.specular, layers.anisotropy,    layers.sheenColor,  layers.sheenRoughness,
            layers.coat,     layers.coatRoughness, layers.transmission};
}

double facing(const glm::dvec3& normal, const ShadedPoint& point) {
    return std::max(glm::dot(normal, point.towardsEye), 0.0);
}

/// Turns the tangent to where the surface is rougher; without a tangent there is no such way.
void readAnisotropy(const Material& material, const PlacedSurface& surface, const SurfaceHit& hit,
                    const std::optional<glm::dvec4>& texel, const glm::dvec3& normal,
                    PointLayers& layers) {
    const double angle = material.layers->anisotropyRotation;
    glm::dvec2 way(std::cos(angle), std::sin(angle));
    layers.anisotropy = material.layers->anisotropy;
    if (texel) {
        const glm::dvec2 turned(2.0 * texel->x - 1.0, 2.0 * texel->y - 1.0);
        way = {turned.x * way.x - turned.y * way.y, turned.x * way.y + turned.y * way.x};
        layers.anisotropy *= texel->z;
    }
    glm::dvec4 given(0.0);
    if (!surface.primitive->tangents.empty()) {
        given = blended(surface.primitive->tangents, surface.corners(hit.triangle), hit.weights);
    }
    glm::dvec3 tangent = glm::dmat3(surface.worldFromLocal) * glm::dvec3(given);
    tangent -= normal * glm::dot(normal, tangent);
    if (!(glm::dot(tangent, tangent) > 1e-12) || !(glm::dot(way, way) > 1e-12)) {
        layers.anisotropy = 0.0;
        return;
    }
    tangent = glm::normalize(tangent);
    const glm::dvec3 bitangent = glm::cross(hit.front ? normal : -normal, tangent) * given.w;
    layers.tangent = glm::normalize(way.x * tangent + way.y * bitangent);
    layers.bitangent = glm::cross(normal, layers.tangent);
}

/// `smoothNormal`: the point's without its normal map. Changes the roughness where it is
/// glossiness.
PointLayers pointLayers(const PlacedSurface& surface, const MaterialTextures& textures,
                        const SurfaceHit& hit, const glm::dvec3& smoothNormal, ShadedPoint& point) {
    const MaterialLayers& given = *surface.material->layers;
    const auto sample = [&](const std::optional<TextureSlot>& slot, Meaning meaning) {
        return slot ? textures.sample(*slot, meaning, surface, hit.triangle, hit.weights)
                    : glm::dvec4(1.0);
    };
    const glm::dvec4 color = sample(given.specularColorTexture, Meaning::kColors);
    if (given.glossinessInSpecular) {
        point.roughness = 1.0 - (1.0 - point.roughness) * color.w;
    }
    PointLayers layers;
    layers.specular = given.specular * sample(given.specularTexture, Meaning::kData).w;
    layers.dielectricF0 =
        layers.specular *
        glm::min(shader::f0FromIor(given.ior) * glm::dvec3(given.specularColor) * glm::dvec3(color),
                 glm::dvec3(1.0));
    layers.coat = given.clearcoat * sample(given.clearcoatTexture, Meaning::kData).x;
    layers.coatRoughness =
        given.clearcoatRoughness * sample(given.clearcoatRoughnessTexture, Meaning::kData).y;
    layers.sheenColor = glm::dvec3(given.sheenColor) *
                        glm::dvec3(sample(given.sheenColorTexture, Meaning::kColors));
    layers.sheenRoughness =
        given.sheenRoughness * sample(given.sheenRoughnessTexture, Meaning::kData).w;
    layers.transmission = given.transmission * sample(given.transmissionTexture, Meaning::kData).x;
    layers.coatNormal = smoothNormal;
    if (given.clearcoatNormalTexture && !surface.primitive->tangents.empty()) {
        const glm::dvec4 tangent =
            blended(surface.primitive->tangents, surface.corners(hit.triangle), hit.weights);
        layers.coatNormal =
            bentNormal(smoothNormal, hit.front ? smoothNormal : -smoothNormal,
                       glm::dmat3(surface.worldFromLocal) * glm::dvec3(tangent), tangent.w,
                       2.0 * glm::dvec3(sample(given.clearcoatNormalTexture, Meaning::kData)) - 1.0,
                       given.clearcoatNormalScale);
    }
    std::optional<glm::dvec4> texel;
    if (given.anisotropyTexture) {
        texel = sample(given.anisotropyTexture, Meaning::kData);
    }
    readAnisotropy(*surface.material, surface, hit, texel, point.normal, layers);
    return layers;
}

/// What the surface sends to the eye of one candela-lux from a direction, cosine included.
glm::dvec3 reflected(const ShadedPoint& point, const glm::dvec3& towardsLamp) {
    if (point.layers) {
        return shader::layeredReflection(layeredSurface(point), point.normal, point.layers->tangent,
                                         point.layers->bitangent, point.layers->coatNormal,
                                         towardsLamp, point.towardsEye);
    }
    const double nDotL = glm::dot(point.normal, towardsLamp);
    if (nDotL <= 0.0) {
        return glm::dvec3(0.0);
    }
    // A shading normal may look away from the eye near a silhouette; light it as if edge on.
    const double nDotV = std::max(glm::dot(point.normal, point.towardsEye), 1e-4);
    const glm::dvec3 halfway = glm::normalize(towardsLamp + point.towardsEye);
    return nDotL * shader::metallicRoughnessBrdf(
                       point.baseColor, point.metallic, point.roughness, nDotL, nDotV,
                       glm::clamp(glm::dot(point.normal, halfway), 0.0, 1.0),
                       glm::clamp(glm::dot(point.towardsEye, halfway), 0.0, 1.0));
}

/// Of light from all around.
glm::dvec3 ambientLight(const ShadedPoint& point, const glm::dvec3& lux) {
    const glm::dvec3 specular = glm::mix(glm::dvec3(0.04), point.baseColor, point.metallic);
    glm::dvec3 albedo = point.baseColor * (1.0 - point.metallic) + specular;
    if (point.layers) {
        albedo = shader::layeredAlbedo(layeredSurface(point), facing(point.normal, point),
                                       facing(point.layers->coatNormal, point));
    }
    return albedo * lux * (shader::kInversePi * point.occlusion);
}

}  // namespace

ShadedPoint shadedPoint(const PlacedSurface& surface, const MaterialTextures& textures,
                        const SurfaceHit& hit, const glm::dvec3& origin,
                        const glm::dvec3& direction) {
    const Material& material = *surface.material;
    const auto sample = [&](const std::optional<TextureSlot>& slot, Meaning meaning) {
        return textures.sample(*slot, meaning, surface, hit.triangle, hit.weights);
    };
    ShadedPoint point;
    point.position = origin + hit.distance * direction;
    point.towardsEye = -direction;
    point.baseColor = glm::dvec3(material.baseColor);
    const std::vector<glm::vec4>& colors = surface.primitive->colors;
    if (!colors.empty()) {
        const glm::dvec4 color = blended(colors, surface.corners(hit.triangle), hit.weights);
        point.baseColor *= glm::clamp(glm::dvec3(color), 0.0, 1.0);
    }
    point.alpha = textures.alpha(surface, hit.triangle, hit.weights);
    point.metallic = material.metallic;
    point.roughness = material.roughness;
    point.emission = glm::dvec3(material.emission);
    point.unlit = material.unlit;
    if (material.baseColorTexture) {
        point.baseColor *= glm::dvec3(sample(material.baseColorTexture, Meaning::kColors));
    }
    if (material.metallicRoughnessTexture) {
        const glm::dvec4 texel = sample(material.metallicRoughnessTexture, Meaning::kData);
        point.metallic *= texel.z;
        point.roughness *= texel.y;
    }
    if (material.occlusionTexture) {
        const double occlusion = sample(material.occlusionTexture, Meaning::kData).x;
        point.occlusion = 1.0 + double(material.occlusionStrength) * (occlusion - 1.0);
    }
    if (material.emissiveTexture) {
        point.emission *= glm::dvec3(sample(material.emissiveTexture, Meaning::kColors));
    }

    const auto corners = surface.cornerPositions(hit.triangle);
    const glm::dvec3 plane = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    point.geometric = glm::normalize(plane);
    if (glm::dot(point.geometric, point.towardsEye) < 0.0) {
        point.geometric = -point.geometric;
    }
    const glm::dvec3 smoothNormal = vertexNormal(surface, hit, point.geometric);
    point.normal = mappedNormal(surface, textures, hit, smoothNormal);
    if (material.layers) {
        point.layers = pointLayers(surface, textures, hit, smoothNormal, point);
    }
    return point;
}

glm::dvec3 keptBehind(const ShadedPoint& point) {
    const double alpha = glm::clamp(point.alpha, 0.0, 1.0);
    if (!point.layers || !(point.layers->transmission > 0.0) || point.unlit) {
        return glm::dvec3(1.0 - alpha);
    }
    const glm::dvec3 kept = shader::seenThrough(layeredSurface(point), facing(point.normal, point),
                                                facing(point.layers->coatNormal, point));
    return glm::mix(glm::dvec3(1.0), kept, alpha);
}

SurfaceLight::SurfaceLight(const Scene& scene, std::span<const BeamLamp> spots,
                           const RayCaster& caster, const Haze& haze, double ambientLux,
                           const SkyDaylight* day)
    : scene_(scene),
      spots_(spots),
      caster_(caster),
      extinction_(haze.extinctionPerMetre()),
      ambientLux_(ambientLux),
      daylight_(day) {}

glm::dvec3 SurfaceLight::radiance(const ShadedPoint& point) const {
    if (point.unlit) {
        return point.baseColor;
    }
    // Even light, a little less from below.
    const double fromAbove = 0.75 + 0.25 * point.normal.y;
    glm::dvec3 lux(ambientLux_ * fromAbove);
    if (scene_.environment) {
        lux += irradiance(*scene_.environment, point.normal);
    }
    glm::dvec3 sum = point.emission + ambientLight(point, lux);
    if (daylight_ != nullptr) {
        sum += fromDay(point);
    }
    for (const BeamLamp& lamp : spots_) {
        sum += fromSpot(lamp, point);
    }
    for (const PointLight& lamp : scene_.pointLights) {
        if (lamp.shown) {
            sum += fromPoint(lamp, point);
        }
    }
    for (std::size_t i = 0; i < scene_.directionalLights.size(); ++i) {
        const DirectionalLight& lamp = scene_.directionalLights[i];
        if (!lamp.shown || (daylight_ != nullptr && int(i) == daylight_->sunLamp())) {
            continue;
        }
        sum += reflected(point, -lamp.direction) * glm::dvec3(lamp.color) * lamp.illuminanceLux;
    }
    return sum;
}

glm::dvec3 SurfaceLight::fromSpot(const BeamLamp& lamp, const ShadedPoint& point) const {
    const glm::dvec3 fromLamp = point.position - lamp.light.frame.position;
    const glm::dvec3 place = lamp.toBeam(fromLamp);
    if (place.z <= shader::kLensMetres) {
        return glm::dvec3(0.0);
    }
    const double distance = glm::length(place);
    const double inverseTan = lamp.cosOuter / lamp.sinOuter;
    double falloff = 0.0;
    if (lamp.light.beamShape == BeamShape::kPyramid) {
        falloff = std::max(std::abs(place.x), std::abs(place.y)) * inverseTan < place.z ? 1.0 : 0.0;
    } else {
        falloff = shader::coneFalloff(place.z / distance, lamp.cosInner, lamp.cosOuter);
    }
    falloff *= shader::rangeWindow(distance, lamp.inverseRange) * shader::inverseSquare(distance) *
               shader::transmittance(extinction_, distance);
    if (!(falloff > 0.0)) {
        return glm::dvec3(0.0);
    }
    glm::dvec3 light = reflected(point, -fromLamp / distance) * lamp.candela * falloff;
    if (lamp.lightMap != nullptr) {
        light *= lightMapOn(lamp, place, point);
    }
    if (light == glm::dvec3(0.0) || isShadowed(lamp, point, place.z)) {
        return glm::dvec3(0.0);
    }
    return light;
}

// Lit from the side that faces the lamp, whichever the eye sees; up to the lens plane, before which
// nothing casts.
bool SurfaceLight::isShadowed(const BeamLamp& lamp, const ShadedPoint& point, double depth) const {
    const glm::dvec3 way = lamp.light.frame.position - point.position;
    const double side = glm::dot(way, point.geometric) < 0.0 ? -1.0 : 1.0;
    const double off = 1e-9 * (glm::length(way) + glm::length(point.position));
    const glm::dvec3 from = point.position + (side * off) * point.geometric;
    return caster_.isBlocked(from, from + (1.0 - shader::kLensMetres / depth) * way);
}

glm::dvec3 SurfaceLight::fromDay(const ShadedPoint& point) const {
    const glm::dvec3 light = ambientLight(point, daylight_->irradiance(point.normal));
    const glm::dvec3 sun = reflected(point, daylight_->towardsSun()) * daylight_->sunLux();
    return sun == glm::dvec3(0.0) ? light : light + sunSeen(point) * sun;
}

// By rays to points that are spread evenly over the disc.
double SurfaceLight::sunSeen(const ShadedPoint& point) const {
    constexpr double kBeyondAllScenes = 1e6;  // metres
    const double side = glm::dot(daylight_->towardsSun(), point.geometric) < 0.0 ? -1.0 : 1.0;
    const double off = 1e-9 * (kBeyondAllScenes + glm::length(point.position));
    const glm::dvec3 from = point.position + (side * off) * point.geometric;
    int open = 0;
    for (const glm::dvec3& direction : daylight_->sunDisc()) {
        open += caster_.isBlocked(from, from + kBeyondAllScenes * direction) ? 0 : 1;
    }
    return double(open) / double(daylight_->sunDisc().size());
}

glm::dvec3 SurfaceLight::fromPoint(const PointLight& lamp, const ShadedPoint& point) const {
    const glm::dvec3 way = lamp.position - point.position;
    const double distance = glm::length(way);
    if (!(distance > 0.0)) {
        return glm::dvec3(0.0);
    }
    const double attenuation = shader::rangeWindow(distance, 1.0 / lamp.rangeMetres) *
                               shader::inverseSquare(distance) *
                               shader::transmittance(extinction_, distance);
    return reflected(point, way / distance) * glm::dvec3(lamp.color) *
           (lamp.intensityCandela * attenuation);
}

}  // namespace ribalta
