// A part of a table of scattering that one dispatch computes: some rows of one of its layers.
layout(local_size_x = 8, local_size_y = 8) in;
layout(location = kSkyLayerLocation) uniform int layer;
layout(location = kSkyFirstRowLocation) uniform int firstRow;
layout(location = kSkyEndRowLocation) uniform int endRow;

ivec3 layerTexel() {
    return ivec3(gl_GlobalInvocationID.x, int(gl_GlobalInvocationID.y) + firstRow, layer);
}

bool inLayer(ivec3 texel) {
    return texel.x < int(tables.scattering.x * tables.scattering.w) && texel.y < endRow;
}
