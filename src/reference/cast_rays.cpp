#include "reference/cast_rays.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <embree3/rtcore.h>

#include "base/error.h"

namespace ribalta {
namespace {

// Bits of geometries and rays: a ray meets what shares a bit with it.
constexpr unsigned kSeen = 1;
constexpr unsigned kCasts = 2;

/// Where a ray's line meets a triangle's plane, in double precision.
struct Meeting {
    double distance = 0.0;
    glm::dvec3 weights{0.0};
    bool front = true;  ///< counter-clockwise as seen along the ray
};

// Moeller & Trumbore 1997.
std::optional<Meeting> meet(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& from,
                            const glm::dvec3& direction) {
    const glm::dvec3 edge1 = corners[1] - corners[0];
    const glm::dvec3 edge2 = corners[2] - corners[0];
    const glm::dvec3 p = glm::cross(direction, edge2);
    const double determinant = glm::dot(edge1, p);
    if (determinant == 0.0 || !std::isfinite(determinant)) {
        return std::nullopt;
    }
    const glm::dvec3 offset = from - corners[0];
    const double u = glm::dot(offset, p) / determinant;
    const glm::dvec3 q = glm::cross(offset, edge1);
    const double v = glm::dot(direction, q) / determinant;
    return Meeting{glm::dot(edge2, q) / determinant, {1.0 - u - v, u, v}, determinant > 0.0};
}

/// One query, as the filters see it.
struct Query {
    RTCIntersectContext context{};  ///< first, so that Embree's pointer to it is one to this
    glm::dvec3 from{0.0};
    glm::dvec3 direction{0.0};
    double first = 0.0;
    double last = 0.0;
    std::optional<SurfaceHit> nearest;
    std::vector<SurfaceHit>* blended = nullptr;  ///< gathers them; null where none are looked for
};

}  // namespace

struct RayCaster::State {
    std::span<const PlacedSurface> surfaces;
    const MaterialTextures& textures;
    glm::dvec3 origin;
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;

    State(std::span<const PlacedSurface> itsSurfaces, const MaterialTextures& itsTextures,
          const glm::dvec3& itsOrigin)
        : surfaces(itsSurfaces), textures(itsTextures), origin(itsOrigin) {}
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (scene != nullptr) {
            rtcReleaseScene(scene);
        }
        if (device != nullptr) {
            rtcReleaseDevice(device);
        }
    }

    void add(std::uint32_t index);
    void throwIfFailed() const;
    RTCRay makeRay(const Query& query, unsigned mask) const;
    std::optional<SurfaceHit> meetExactly(const Query& query, const RTCHit& hit) const;
    bool isSeen(Query& query, const RTCHit& hit) const;
    bool blocks(const Query& query, const RTCHit& hit) const;

    // Embree hands over one candidate at a time here; one that is turned down does not end the ray.
    static void filterSeen(const RTCFilterFunctionNArguments* candidate) {
        const auto* state = static_cast<const State*>(candidate->geometryUserPtr);
        if (!state->isSeen(*reinterpret_cast<Query*>(candidate->context),
                           *reinterpret_cast<const RTCHit*>(candidate->hit))) {
            candidate->valid[0] = 0;
        }
    }
    static void filterBlocking(const RTCFilterFunctionNArguments* candidate) {
        const auto* state = static_cast<const State*>(candidate->geometryUserPtr);
        if (!state->blocks(*reinterpret_cast<Query*>(candidate->context),
                           *reinterpret_cast<const RTCHit*>(candidate->hit))) {
            candidate->valid[0] = 0;
        }
    }
};

void RayCaster::State::throwIfFailed() const {
    const RTCError error = rtcGetDeviceError(device);
    if (error != RTC_ERROR_NONE) {
        throw Error(ErrorKind::kJobFailed, {},
                    error == RTC_ERROR_OUT_OF_MEMORY
                        ? std::string("out of memory; the scene has too many triangles")
                        : "Embree failed with its error " + std::to_string(int(error)));
    }
}

void RayCaster::State::add(std::uint32_t index) {
    const PlacedSurface& surface = surfaces[index];
    const std::size_t vertices = surface.primitive->positions.size();
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), vertices));
    auto* indices = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(unsigned), surface.triangles()));
    throwIfFailed();
    for (std::size_t v = 0; v < vertices; ++v) {
        const glm::dvec3 place = surface.position(std::uint32_t(v)) - origin;
        for (int axis = 0; axis < 3; ++axis) {
            positions[3 * v + std::size_t(axis)] = float(place[axis]);
        }
    }
    std::copy_n(surface.primitive->indices.begin(), 3 * surface.triangles(), indices);
    rtcSetGeometryMask(geometry, kSeen | (surface.castsShadow() ? kCasts : 0U));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryIntersectFilterFunction(geometry, &filterSeen);
    rtcSetGeometryOccludedFilterFunction(geometry, &filterBlocking);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, index);
    rtcReleaseGeometry(geometry);
}

// A little longer than the query at both ends: its exact ends are looked at with each candidate.
RTCRay RayCaster::State::makeRay(const Query& query, unsigned mask) const {
    const glm::dvec3 from = query.from - origin;
    const double size = std::max({std::abs(from.x), std::abs(from.y), std::abs(from.z)});
    const double room = 1e-5 * (size + query.first);
    RTCRay ray{};
    ray.org_x = float(from.x);
    ray.org_y = float(from.y);
    ray.org_z = float(from.z);
    ray.dir_x = float(query.direction.x);
    ray.dir_y = float(query.direction.y);
    ray.dir_z = float(query.direction.z);
    ray.tnear = float(std::max(query.first - room, 0.0));
    ray.tfar = float(query.last * 1.00001 + room);
    ray.mask = mask;
    return ray;
}

std::optional<SurfaceHit> RayCaster::State::meetExactly(const Query& query,
                                                        const RTCHit& hit) const {
    const PlacedSurface& surface = surfaces[hit.geomID];
    const std::optional<Meeting> meeting =
        meet(surface.cornerPositions(hit.primID), query.from, query.direction);
    if (!meeting || !(meeting->distance >= query.first && meeting->distance <= query.last)) {
        return std::nullopt;
    }
    // Single precision found it inside: so it is, whatever rounding says of its very edge. What is
    // truly outside is so by more.
    constexpr double kEdge = 1e-3;
    if (std::min({meeting->weights.x, meeting->weights.y, meeting->weights.z}) < -kEdge) {
        return std::nullopt;
    }
    const glm::dvec3 kept = glm::max(meeting->weights, glm::dvec3(0.0));
    return SurfaceHit{hit.geomID, hit.primID, meeting->distance, kept / (kept.x + kept.y + kept.z),
                      meeting->front != surface.mirrored};
}

bool RayCaster::State::isSeen(Query& query, const RTCHit& hit) const {
    const std::optional<SurfaceHit> exact = meetExactly(query, hit);
    if (!exact) {
        return false;
    }
    const PlacedSurface& surface = surfaces[exact->surface];
    if (!exact->front && !surface.material->doubleSided) {
        return false;
    }
    if (surface.isBlended()) {
        query.blended->push_back(*exact);
        return false;
    }
    if (!textures.isThere(surface, exact->triangle, exact->weights)) {
        return false;
    }
    if (!query.nearest || exact->distance < query.nearest->distance) {
        query.nearest = exact;
    }
    return true;
}

bool RayCaster::State::blocks(const Query& query, const RTCHit& hit) const {
    const std::optional<SurfaceHit> exact = meetExactly(query, hit);
    return exact && textures.isThere(surfaces[exact->surface], exact->triangle, exact->weights);
}

RayCaster::RayCaster(std::span<const PlacedSurface> surfaces, const MaterialTextures& textures,
                     const glm::dvec3& origin)
    : state_(std::make_unique<State>(surfaces, textures, origin)) {
    state_->device = rtcNewDevice(nullptr);
    state_->throwIfFailed();
    state_->scene = rtcNewScene(state_->device);
    rtcSetSceneFlags(state_->scene, RTC_SCENE_FLAG_ROBUST);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        state_->add(std::uint32_t(i));
    }
    rtcCommitScene(state_->scene);
    state_->throwIfFailed();
}

RayCaster::~RayCaster() = default;

void RayCaster::look(const glm::dvec3& from, const glm::dvec3& direction, double first, double last,
                     Sight& sight) const {
    sight.blended.clear();
    Query query;
    query.from = from;
    query.direction = direction;
    query.first = first;
    query.last = last;
    query.blended = &sight.blended;
    rtcInitIntersectContext(&query.context);
    RTCRayHit ray{};
    ray.ray = state_->makeRay(query, kSeen);
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(state_->scene, &query.context, &ray);
    sight.opaque = query.nearest;

    // Drawn over it as the renderer does: whole primitives far to near, their triangles in order.
    std::vector<SurfaceHit>& blended = sight.blended;
    if (sight.opaque) {
        std::erase_if(blended,
                      [&](const SurfaceHit& hit) { return hit.distance > sight.opaque->distance; });
    }
    const auto drawnBefore = [&](const SurfaceHit& a, const SurfaceHit& b) {
        const double depthA = state_->surfaces[a.surface].blendDepth;
        const double depthB = state_->surfaces[b.surface].blendDepth;
        if (depthA != depthB) {
            return depthA > depthB;
        }
        return a.surface != b.surface ? a.surface < b.surface : a.triangle < b.triangle;
    };
    std::sort(blended.begin(), blended.end(), drawnBefore);
    blended.erase(std::unique(blended.begin(), blended.end(),
                              [](const SurfaceHit& a, const SurfaceHit& b) {
                                  return a.surface == b.surface && a.triangle == b.triangle;
                              }),
                  blended.end());
}

bool RayCaster::isBlocked(const glm::dvec3& from, const glm::dvec3& to) const {
    const glm::dvec3 way = to - from;
    const double length = glm::length(way);
    if (!(length > 0.0)) {
        return false;
    }
    Query query;
    query.from = from;
    query.direction = way / length;
    query.first = 1e-9 * (length + glm::length(from - state_->origin));
    query.last = length;
    rtcInitIntersectContext(&query.context);
    RTCRay ray = state_->makeRay(query, kCasts);
    rtcOccluded1(state_->scene, &query.context, &ray);
    return ray.tfar < 0.0F;
}

}  // namespace ribalta
