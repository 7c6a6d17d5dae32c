// View rays: from a pixel and its depth to a ray through the scene, in view space.

/// Point the ray of a pixel starts from: the eye, or the camera's plane where orthographic.
/// ndc in -1..1; halfExtent as in shared/view.h.
vec3 viewRayOrigin(vec2 ndc, vec4 halfExtent) {
    vec3 origin = vec3(0.0);
    if (halfExtent.z > 0.5) {
        origin.x = ndc.x * halfExtent.x;
        origin.y = ndc.y * halfExtent.y;
    }
    return origin;
}

/// Unit direction of that ray.
vec3 viewRayDirection(vec2 ndc, vec4 halfExtent) {
    vec3 direction = vec3(0.0, 0.0, -1.0);
    if (halfExtent.z < 0.5) {
        direction.x = ndc.x * halfExtent.x;
        direction.y = ndc.y * halfExtent.y;
    }
    return normalize(direction);
}

/// Distance along the view axis in metres for a reversed depth of 0..1; the far plane, or 1e30
/// where there is none, for a depth of 0. depthTerms as in shared/view.h.
float viewDistance(float depth, vec4 depthTerms, float orthographic) {
    if (orthographic > 0.5) {
        return depthTerms.x + depthTerms.y * depth;
    }
    return depth > depthTerms.y ? min(depthTerms.x / (depth - depthTerms.y), depthTerms.w)
                                : depthTerms.w;
}
