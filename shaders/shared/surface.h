// What an instance and a material hand to the surface shaders.
#pragma once
#include "shared/language.h"
SHARED_BEGIN

// Read as vertex attributes, column by column from kInstanceAttribute on.
struct SurfaceInstance {
    mat4 viewFromLocal;
    vec4 viewFromNormal[3];  // columns of the upper 3x3's inverse transpose; 0 where a primitive has
                             // no normals and the surface's own are used
};

struct CasterInstance {
    mat4 clipFromLocal;
};

const int kBaseColorTexture = 0;
const int kMetallicRoughnessTexture = 1;
const int kNormalTexture = 2;
const int kOcclusionTexture = 3;
const int kEmissiveTexture = 4;
const int kMaterialTextures = 5;

const int kUnlitFlag = 1;
const int kDoubleSidedFlag = 2;

// Textures of materials with layers, in the order of MaterialLayers.
const int kSpecularTexture = 0;
const int kSpecularColorTexture = 1;
const int kClearcoatTexture = 2;
const int kClearcoatRoughnessTexture = 3;
const int kClearcoatNormalTexture = 4;
const int kSheenColorTexture = 5;
const int kSheenRoughnessTexture = 6;
const int kAnisotropyTexture = 7;
const int kTransmissionTexture = 8;
const int kLayerTextures = 9;

const int kGlossinessFlag = 1;

struct SurfaceLayers {
    vec4 specular;    // R, G, B of its colour; w: its weight
    vec4 coat;        // weight, roughness, normal scale; w: reflectance of the ior straight on
    vec4 sheen;       // R, G, B; w: roughness
    vec4 anisotropy;  // strength, cosine and sine of its rotation; w: transmission
    ivec4 flags;      // x: kGlossinessFlag; y and z as a SurfaceMaterial's
    vec4 uvRows[18];  // likewise
};

struct SurfaceMaterial {
    vec4 baseColor;
    vec4 emission;  // cd/m2; w: alpha cutoff
    vec4 factors;   // metallic, roughness, normal scale, occlusion strength
    ivec4 flags;  // x: kUnlitFlag ...; y: bit t set where texture t is there; z: bit t set where it
                  // uses the second coordinates; w: its SurfaceLayers, where it has any
    vec4 uvRows[10];  // texture t: u' = dot(uvRows[2t].xyz, (u, v, 1)), v' with uvRows[2t + 1]
};

SHARED_END
