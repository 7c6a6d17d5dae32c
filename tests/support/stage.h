// Small stages built in memory, for tests of the renderer: shapes, lamps, pictures, rays. Draws
// nothing itself.
#pragma once

#include <functional>

#include <glm/glm.hpp>

#include "image/image.h"
#include "scene/camera.h"
#include "scene/light.h"
#include "scene/scene.h"

namespace ribalta::test {

/// A rectangle around `centre`; u and v are its half sides, cross(u, v) is the side it faces.
/// Texture coordinates run 0..1 along u and against v, so that a picture's top lies towards v.
Primitive makeQuad(const glm::vec3& centre, const glm::vec3& u, const glm::vec3& v);

/// A sphere with smooth normals; its facets lie within `radius` and come within
/// radius (1 - cos(pi / segments)) of it.
Primitive makeSphere(const glm::vec3& centre, float radius, int segments = 64);

/// A box with flat faces, seen from outside.
Primitive makeBox(const glm::vec3& low, const glm::vec3& high);

/// A material of one even colour; rough and not metallic unless told otherwise.
Material makeMaterial(const glm::vec3& baseColor, float metallic = 0.0F, float roughness = 1.0F);

/// Puts a primitive with a material of its own into the scene, in a node of its own whose index is
/// returned.
int addShape(Scene& scene, Primitive primitive, const Material& material,
             const glm::dmat4& worldFromLocal = glm::dmat4(1.0));

/// Shifts a node with all that it draws.
void moveNode(Scene& scene, int node, const glm::dvec3& metres);

/// A spot at `position` that shines towards `target`.
SpotLight makeSpot(const glm::dvec3& position, const glm::dvec3& target, double outerConeAngle,
                   double candela = 1000.0);

/// A perspective camera; `verticalFov` in radians, endless.
Camera makeCamera(const glm::dvec3& position, const glm::dvec3& target, double verticalFov = 0.8);

/// An 8-bit picture; `color` gives sRGB-encoded R, G, B, A in 0..1 of a texel, rows from the top.
Image makeImage(int width, int height, const std::function<glm::vec4(int x, int y)>& color);

/// Adds `image` to the scene and lets the lamp project it.
void useLightMap(Scene& scene, SpotLight& lamp, Image image, double rotationRadians = 0.0);

/// The ray through the centre of a pixel, rows from the top: where it starts (the eye, or the
/// camera's plane where orthographic), its unit direction, and the metres along it of one metre
/// along the view axis.
struct PixelRay {
    glm::dvec3 origin;
    glm::dvec3 direction;
    double metresPerDepth = 1.0;
};
PixelRay pixelRay(const Camera& camera, int width, int height, int x, int y);

}  // namespace ribalta::test
