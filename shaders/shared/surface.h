// What a draw and a material hand to the surface shaders.
#pragma once
#include "shared/language.h"
SHARED_BEGIN

struct Draw {
    mat4 viewFromLocal;
    mat4 viewFromNormal;  // inverse transpose of the upper 3x3
    ivec4 flags;          // x: 1 where normals are given, 0 where the surface's own are used
};

const int kBaseColorTexture = 0;
const int kMetallicRoughnessTexture = 1;
const int kNormalTexture = 2;
const int kOcclusionTexture = 3;
const int kEmissiveTexture = 4;
const int kMaterialTextures = 5;

const int kUnlitFlag = 1;
const int kDoubleSidedFlag = 2;

struct SurfaceMaterial {
    vec4 baseColor;
    vec4 emission;  // cd/m2; w: alpha cutoff
    vec4 factors;   // metallic, roughness, normal scale, occlusion strength
    ivec4 flags;    // x: kUnlitFlag ...; y: bit t set where texture t is there; z: bit t set where it
                    // uses the second coordinates
    vec4 uvRows[10];  // texture t: u' = dot(uvRows[2t].xyz, (u, v, 1)), v' with uvRows[2t + 1]
};

SHARED_END
