// Lamp reach: what a lamp can light and where its beam lies in the picture. All tests are
// conservative: they may keep what turns out dark, and never drop what is lit.
#pragma once

#include <vector>

#include "scene/bounds.h"
#include "scene/camera.h"
#include "scene/light.h"

namespace ribalta {

/// A lamp that gives no light: zero or negative intensity, or black.
bool isDark(const SpotLight& lamp);

/// The half angle within which the lamp is drawn, in kMinConeAngle..kMaxConeAngle.
double drawnConeAngle(const SpotLight& lamp);

/// Lamp space (apex at 0, x right, y up, z the depth along the beam) from world.
glm::dmat4 lampFromWorld(const SpotLight& lamp);

/// The beam's corners in homogeneous world coordinates, which enclose it: its apex, and the ring at
/// its range, or in an unlimited beam the directions (w = 0) it goes on in.
std::vector<glm::dvec4> beamCorners(const SpotLight& lamp);

/// Whether a box may stand in the lamp's beam, its range included.
bool beamTouches(const SpotLight& lamp, const Bounds& worldBounds);

/// Whether a box may be in the camera's view.
bool viewTouches(const glm::dmat4& clipFromWorld, const Bounds& worldBounds);

/// The convex outline, in pixels (y up), of the part of the beam before the camera; not cut at the
/// picture's edges. Empty where the beam lies wholly behind the near plane.
std::vector<glm::dvec2> beamOutline(const SpotLight& lamp, const Camera& camera, int width,
                                    int height);

/// beamOutline of the part of the beam, from the lamp on, that is less than `pixels` wide in the
/// picture at its far end.
std::vector<glm::dvec2> thinBeamOutline(const SpotLight& lamp, const Camera& camera, int width,
                                        int height, double pixels);

}  // namespace ribalta
