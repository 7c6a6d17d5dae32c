// Binding slots: the same numbers in GLSL and in C++.
#pragma once
#include "shared/language.h"
SHARED_BEGIN

// Uniform buffers.
const int kViewSlot = 0;
const int kBeamSettingsSlot = 1;
const int kMaterialSlot = 3;  // a window onto its material
const int kAtmosphereSlot = 4;
const int kSkySlot = 5;
const int kPrecomputedSkySlot = 6;
const int kSunShadowSlot = 7;
const int kDeformJobSlot = 8;  // a window onto the primitive at hand
// Shader storage.
const int kLampsSlot = 0;
const int kPointLampsSlot = 1;
const int kDirectionalLampsSlot = 2;
const int kSpotConesSlot = 3;
const int kSampledCellsSlot = 4;
const int kTilesSlot = 5;
const int kTileLampsSlot = 6;
const int kExposureSlot = 7;
const int kSampledQuadsSlot = 3;   // only surfaces ask for cones
const int kSurfaceLayersSlot = 4;  // likewise
const int kPyramidLayersSlot = 4;  // before the beams
const int kSkyEdgeTilesSlot = 4;   // likewise
const int kSkyEdgesSlot = 5;
const int kRunCountsSlot = 1;  // while beams are drawn
const int kSkyRaysSlot = 0;    // while listed rays of the sky are asked for
const int kSkyLightsSlot = 1;
// While meshes are deformed, before all else.
const int kDeformRestSlot = 0;
const int kDeformInfluencesSlot = 1;
const int kDeformJointsSlot = 2;
const int kDeformActiveSlot = 3;
const int kDeformTargetsSlot = 4;
const int kDeformPositionsSlot = 5;
const int kDeformAttributesSlot = 6;
// Textures.
const int kShadowMapsUnit = 0;
const int kLightMapsUnit = 1;
const int kDepthUnit = 2;
const int kColorUnit = 3;
const int kBeamLatticeUnit = 4;
const int kBeamQuadsUnit = 5;
const int kBeamsOutputUnit = 6;
const int kBeamFineUnit = 7;
const int kShadowPyramidUnit = 8;
const int kOpticalLengthsUnit = 9;
const int kRayleighSourcesUnit = 10;
const int kMieSourcesUnit = 11;
const int kSkyIrradianceUnit = 12;
const int kSkyViewUnit = 13;
const int kAerialUnit = 14;
const int kSunShadowUnit = 15;
const int kLayerTexturesUnit = 17;    // nine of them, as kSpecularTexture ...
const int kSunDepthUnit = 16;         // the same, read without comparing
const int kSkyTableUnit = 0;          // an image
const int kSkyTransmittanceUnit = 9;  // of a precomputed sky, which has no other tables
const int kSkyPlaneUnit = 10;
const int kSkyScatteringUnit = 11;
const int kSkyMieUnit = 12;
const int kPyramidUnit = 0;           // an image, as kColorUnit, kBeamLatticeUnit ... are
const int kMaterialTexturesUnit = 4;  // five of them, as kBaseColorTexture ... below
// Images of the sky's tables while they are made.
const int kSkyScatteringImage = 0;
const int kSkyMieImage = 1;
const int kSkyOrderImage = 2;
const int kSkyPlaneImage = 3;
const int kSkyIrradianceImage = 4;
// Uniforms of the passes over a volume.
const int kSkyLayerLocation = 0;
const int kSkyFirstRowLocation = 1;
const int kSkyEndRowLocation = 2;
// Vertex attributes.
const int kPositionAttribute = 0;
const int kNormalAttribute = 1;
const int kTangentAttribute = 2;
const int kUv0Attribute = 3;
const int kUv1Attribute = 4;
const int kColorAttribute = 5;
const int kInstanceAttribute = 6;  // seven for surfaces, four for what casts shadows

SHARED_END
