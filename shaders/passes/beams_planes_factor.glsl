// The smooth factor of a sampling plane: all of the integrand but the lamp's picture and visibility.

layout(std140, binding = kViewSlot) uniform ViewBlock { View view; };
layout(std140, binding = kBeamSettingsSlot) uniform SettingsBlock { BeamSettings settings; };
layout(std430, binding = kLampsSlot) readonly buffer SpotLamps { SpotLamp spotLamps[]; };
layout(location = 0) uniform int lampIndex;

/// Phase, both legs of the haze, inverse square and the step's length along the ray, for a candela at
/// a point in view space.
float sheetFactor(vec3 point) {
    vec3 lampToPoint = (spotLamps[lampIndex].lampFromView * vec4(point, 1.0)).xyz;
    vec3 direction = view.halfExtent.z > 0.5 ? vec3(0.0, 0.0, -1.0) : normalize(point);
    float eyeMetres = view.halfExtent.z > 0.5 ? -point.z : length(point);
    vec3 lampDirection = mat3(spotLamps[lampIndex].lampFromView) * direction;
    float phase = phaseFunction(PHASE_KIND, scatteringCosine(lampToPoint, lampDirection),
                                view.haze.z, view.haze.w);
    // A step dz between planes is dz / cos(view angle) along the ray.
    float stepMetres = settings.planes.w / -direction.z;
    return stepMetres * scatteredIntensity(phase, view.haze.x, view.haze.y, length(lampToPoint),
                                           eyeMetres);
}
