// Where values lie in the sky's tables, for whoever fills and whoever reads them. Places count from
// 0 at the first node to count - 1 at the last; not how a texture's coordinates name them. Needs
// air_shell.glsl.

/// Logarithms of optical length over distance to the air's end: rows of heights, dense at the
/// ground, columns of distances (the mapping of Bruneton's 2017 code). Read by cubics: 16 KB that
/// are 20 times better than 512 x 128 values read linearly.
const int kLengthHeights = 32;
const int kLengthCosines = 64;

/// Sources: logarithms of the light that has been on its way before and is scattered at a height
/// under a sun towards a direction. Layers of height and azimuth, rows of zenith angles, columns of
/// suns; read linearly.
const int kSourceHeights = 12;
const int kSourceSuns = 40;
const int kSourceZeniths = 9;
const int kSourceAzimuths = 5;

/// Stands for no light at all.
const float kDarkest = 1.0e-30;

/// Row of a height 0..top.
float lengthRow(Air air, float h) {
    float part = max(airSquare(air, h), 0.0) / airSquare(air, air.top);
    return float(kLengthHeights - 1) * sqrt(part);
}

/// Column of a distance to the air's end from that height.
float lengthColumn(Air air, float h, float distanceMetres) {
    float shortest = max(air.top - h, 0.0);
    float longest = sqrt(max(airSquare(air, h), 0.0)) + sqrt(airSquare(air, air.top));
    return float(kLengthCosines - 1) * clamp((distanceMetres - shortest) / (longest - shortest), 0.0, 1.0);
}

/// Place of a height 0..top among the sources' heights.
float sourceHeight(Air air, float h) {
    return float(kSourceHeights - 1) * sqrt(clamp(h / air.top, 0.0, 1.0));
}

/// Place of a sun of cosine muS: even in asinh(muS / scale) from first to last, so that suns lie
/// dense around the horizon. `suns`: scale, first, last.
float sourceSun(vec3 suns, float muS) {
    float x = abs(muS) / suns.x;
    float even = log(x + sqrt(x * x + 1.0));
    float part = ((muS < 0.0 ? -even : even) - suns.y) / (suns.z - suns.y);
    return float(kSourceSuns - 1) * clamp(part, 0.0, 1.0);
}

/// The cosine of the azimuth between a ray and the sun.
float skyAzimuthCosine(float mu, float muS, float nu) {
    float sines = sqrt(max((1.0 - mu) * (1.0 + mu) * (1.0 - muS) * (1.0 + muS), 0.0));
    return sines > 1.0e-6 ? clamp((nu - mu * muS) / sines, -1.0, 1.0) : 1.0;
}
