// Shadow projection: where a point in a lamp's frame falls in that lamp's shadow map. The map holds
// reversed depth, near / z, which is linear along a ray in the lamp's projection.

/// Texture coordinates (x, y) and depth (z) of a slope (x / z, y / z) and an inverse depth 1 / z in
/// 1/m. inverseTan is 1 / tan of the map's half angle, nearMetres its near plane.
vec3 shadowCoordinates(vec2 slope, float inverseDepth, float inverseTan, float nearMetres) {
    vec3 result;
    result.x = 0.5 + 0.5 * inverseTan * slope.x;
    result.y = 0.5 + 0.5 * inverseTan * slope.y;
    result.z = nearMetres * inverseDepth;
    return result;
}
