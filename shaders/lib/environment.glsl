// Light of an environment on surfaces: spherical harmonics up to the second band, as the quadratic
// form that they are (Ramamoorthi and Hanrahan, An Efficient Representation for Irradiance
// Environment Maps, 2001, section 3.3).

/// Irradiance in lux on a surface with the unit normal: (n, 1) M (n, 1) of each channel's symmetric
/// matrix, none below 0, where truncated series of strong lights swing to.
vec3 environmentLux(vec3 normal, mat4 red, mat4 green, mat4 blue) {
    vec4 n = vec4(normal, 1.0);
    return vec3(max(dot(n, red * n), 0.0), max(dot(n, green * n), 0.0),
                max(dot(n, blue * n), 0.0));
}
