// Shapes, lamps and rays written out plainly; nothing here comes from the renderer.
#include "support/stage.h"

#include <cmath>
#include <cstring>
#include <numbers>

namespace ribalta::test {
namespace {

void addQuad(Primitive& primitive, const glm::vec3& centre, const glm::vec3& u,
             const glm::vec3& v) {
    const auto first = std::uint32_t(primitive.positions.size());
    const glm::vec3 normal = glm::normalize(glm::cross(u, v));
    for (const glm::vec2 corner :
         {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
        primitive.positions.push_back(centre + corner.x * u + corner.y * v);
        primitive.normals.push_back(normal);
        primitive.uv0.emplace_back(0.5F + 0.5F * corner.x, 0.5F - 0.5F * corner.y);
        primitive.bounds.add(glm::dvec3(primitive.positions.back()));
    }
    for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) {
        primitive.indices.push_back(first + i);
    }
}

}  // namespace

Primitive makeQuad(const glm::vec3& centre, const glm::vec3& u, const glm::vec3& v) {
    Primitive primitive;
    addQuad(primitive, centre, u, v);
    return primitive;
}

Primitive makeSphere(const glm::vec3& centre, float radius, int segments) {
    Primitive primitive;
    const int rings = segments / 2;
    for (int ring = 0; ring <= rings; ++ring) {
        const double polar = std::numbers::pi * ring / rings;
        for (int s = 0; s <= segments; ++s) {
            const double around = 2.0 * std::numbers::pi * s / segments;
            const glm::vec3 normal(std::sin(polar) * std::cos(around), std::cos(polar),
                                   -std::sin(polar) * std::sin(around));
            primitive.positions.push_back(centre + radius * normal);
            primitive.normals.push_back(normal);
            primitive.bounds.add(glm::dvec3(primitive.positions.back()));
        }
    }
    const auto at = [&](int ring, int s) { return std::uint32_t(ring * (segments + 1) + s); };
    for (int ring = 0; ring < rings; ++ring) {
        for (int s = 0; s < segments; ++s) {
            for (const std::uint32_t index : {at(ring, s), at(ring + 1, s), at(ring + 1, s + 1),
                                              at(ring, s), at(ring + 1, s + 1), at(ring, s + 1)}) {
                primitive.indices.push_back(index);
            }
        }
    }
    return primitive;
}

Primitive makeBox(const glm::vec3& low, const glm::vec3& high) {
    Primitive primitive;
    const glm::vec3 centre = 0.5F * (low + high);
    const glm::vec3 half = 0.5F * (high - low);
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0F, 1.0F}) {
            glm::vec3 normal(0.0F);
            glm::vec3 u(0.0F);
            normal[axis] = side;
            u[(axis + 1) % 3] = 1.0F;
            const glm::vec3 v = glm::cross(normal, u);
            addQuad(primitive, centre + normal * half, u * half, v * half);
        }
    }
    return primitive;
}

Material makeMaterial(const glm::vec3& baseColor, float metallic, float roughness) {
    Material material;
    material.baseColor = glm::vec4(baseColor, 1.0F);
    material.metallic = metallic;
    material.roughness = roughness;
    return material;
}

int addShape(Scene& scene, Primitive primitive, const Material& material,
             const glm::dmat4& worldFromLocal) {
    primitive.material = int(scene.materials.size());
    scene.materials.push_back(material);
    Mesh mesh;
    mesh.primitives.push_back(std::move(primitive));
    Node node;
    node.mesh = int(scene.meshes.size());
    node.parentFromLocal = worldFromLocal;
    node.worldFromLocal = worldFromLocal;
    scene.meshes.push_back(std::move(mesh));
    scene.nodes.push_back(node);
    return int(scene.nodes.size()) - 1;
}

void moveNode(Scene& scene, int node, const glm::dvec3& metres) {
    Node& moved = scene.nodes[std::size_t(node)];
    moved.parentFromLocal[3] += glm::dvec4(metres, 0.0);
    moved.worldFromLocal[3] += glm::dvec4(metres, 0.0);
}

SpotLight makeSpot(const glm::dvec3& position, const glm::dvec3& target, double outerConeAngle,
                   double candela) {
    SpotLight lamp;
    lamp.frame = lookAt(position, target);
    lamp.outerConeAngle = outerConeAngle;
    lamp.intensityCandela = candela;
    return lamp;
}

Camera makeCamera(const glm::dvec3& position, const glm::dvec3& target, double verticalFov) {
    Camera camera;
    camera.frame = lookAt(position, target);
    camera.lens = PerspectiveLens{verticalFov, std::nullopt};
    return camera;
}

Image makeImage(int width, int height, const std::function<glm::vec4(int x, int y)>& color) {
    Image image;
    image.name = "made";
    image.width = width;
    image.height = height;
    image.pixels = RawBytes(std::size_t(width) * std::size_t(height) * 4);
    std::byte* to = image.pixels.data();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const glm::vec4 texel = color(x, y);
            for (int c = 0; c < 4; ++c) {
                *to++ = std::byte(int(std::lround(255.0F * texel[c])));
            }
        }
    }
    return image;
}

void useLightMap(Scene& scene, SpotLight& lamp, Image image, double rotationRadians) {
    lamp.lightMap = LightMap{int(scene.images.size()), rotationRadians};
    scene.images.push_back(std::move(image));
}

PixelRay pixelRay(const Camera& camera, int width, int height, int x, int y) {
    const double across = (x + 0.5) / width * 2.0 - 1.0;
    const double up = 1.0 - (y + 0.5) / height * 2.0;
    const glm::dvec2 half = viewHalfExtent(camera, width, height);
    const Frame& frame = camera.frame;
    const glm::dvec3 aside = across * half.x * frame.right() + up * half.y * frame.up();
    if (camera.isOrthographic()) {
        return {frame.position + aside, frame.forward(), 1.0};
    }
    const glm::dvec3 unscaled = frame.forward() + aside;
    const double length = glm::length(unscaled);
    return {frame.position, unscaled / length, length};
}

}  // namespace ribalta::test
