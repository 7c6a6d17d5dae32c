// The structs of shaders/shared as the driver lays them out against C++'s own layout.
#include <cstddef>
#include <map>

#include <shared/atmosphere.h>
#include <shared/beams.h>
#include <shared/lamp.h>
#include <shared/sky.h>
#include <shared/slots.h>
#include <shared/sun_shadow.h>
#include <shared/surface.h>
#include <shared/view.h>

#include "gl/buffer.h"
#include "gl/program.h"
#include "gpu_test.h"

namespace ribalta::test {
namespace {

struct Member {
    const char* name;
    std::size_t offset;
};

class StructLayout : public GpuTest {
  protected:
    static GLint property(const Program& program, GLenum interface, const std::string& name,
                          GLenum what) {
        const GLuint index = glGetProgramResourceIndex(program.name(), interface, name.c_str());
        if (index == GL_INVALID_INDEX) {
            return -1;
        }
        GLint value = -2;
        glGetProgramResourceiv(program.name(), interface, index, 1, &what, 1, nullptr, &value);
        return value;
    }
    /// Members of an unsized array of structs in a std430 buffer, and its stride. A member that the
    /// program does not use has no offset to ask for: at least `atLeast` must have one.
    static void expectBuffer(const Program& program, const std::string& block,
                             const std::string& array, const std::vector<Member>& members,
                             std::size_t stride, int atLeast) {
        int found = 0;
        for (const Member& member : members) {
            const std::string name = array + "[0]." + member.name;
            const GLint offset = property(program, GL_BUFFER_VARIABLE, name, GL_OFFSET);
            if (offset < 0) {
                continue;
            }
            ++found;
            EXPECT_EQ(offset, GLint(member.offset)) << block << ": " << name;
            EXPECT_EQ(property(program, GL_BUFFER_VARIABLE, name, GL_TOP_LEVEL_ARRAY_STRIDE),
                      GLint(stride))
                << block << ": " << name;
        }
        EXPECT_GE(found, atLeast) << block;
    }
    static void expectUniforms(const Program& program, const std::string& block,
                               const std::vector<Member>& members, std::size_t size, int atLeast) {
        int found = 0;
        for (const Member& member : members) {
            const std::string name = member.name;
            const GLint offset = property(program, GL_UNIFORM, name, GL_OFFSET);
            if (offset >= 0) {
                ++found;
                EXPECT_EQ(offset, GLint(member.offset)) << block << ": " << name;
            }
        }
        EXPECT_GE(found, atLeast) << block;
        EXPECT_EQ(property(program, GL_UNIFORM_BLOCK, block, GL_BUFFER_DATA_SIZE), GLint(size))
            << block;
    }
};

#define MEMBER(STRUCT, NAME)               \
    Member {                               \
#NAME, offsetof(gpu::STRUCT, NAME) \
    }

TEST_F(StructLayout, WhatBeamsRead) {
    const Program program({"passes/beams_tiles.vert", "passes/beams_clipped.frag"},
                          {"PHASE_KIND 0"});
    expectUniforms(program, "ViewBlock",
                   {{"view.clipFromView", offsetof(gpu::View, clipFromView)},
                    {"view.halfExtent", offsetof(gpu::View, halfExtent)},
                    {"view.depthTerms", offsetof(gpu::View, depthTerms)},
                    {"view.picture", offsetof(gpu::View, picture)},
                    {"view.haze", offsetof(gpu::View, haze)},
                    {"view.upAmbient", offsetof(gpu::View, upAmbient)},
                    {"view.lampCounts", offsetof(gpu::View, lampCounts)},
                    {"view.environment[0]", offsetof(gpu::View, environment)}},
                   sizeof(gpu::View), 8);
    expectUniforms(program, "SettingsBlock",
                   {{"settings.planes", offsetof(gpu::BeamSettings, planes)},
                    {"settings.cells", offsetof(gpu::BeamSettings, cells)},
                    {"settings.lattice", offsetof(gpu::BeamSettings, lattice)},
                    {"settings.adaptive", offsetof(gpu::BeamSettings, adaptive)}},
                   sizeof(gpu::BeamSettings), 4);
    expectBuffer(program, "SpotLamps", "spotLamps",
                 {MEMBER(SpotLamp, lampFromView), MEMBER(SpotLamp, candela), MEMBER(SpotLamp, cone),
                  MEMBER(SpotLamp, projection), MEMBER(SpotLamp, shadow),
                  MEMBER(SpotLamp, towardsEye), MEMBER(SpotLamp, layers)},
                 sizeof(gpu::SpotLamp), 7);
    expectBuffer(program, "Tiles", "tiles", {MEMBER(BeamSquare, place), MEMBER(BeamSquare, detail)},
                 sizeof(gpu::BeamSquare), 2);
    EXPECT_EQ(property(program, GL_BUFFER_VARIABLE, "tileLamps[0]", GL_ARRAY_STRIDE),
              GLint(sizeof(int)));
}

TEST_F(StructLayout, WhatSurfacesRead) {
    const Program program({"passes/forward.vert", "passes/forward.frag"},
                          {"TEXTURES", "ALPHA_MASK"});
    expectBuffer(program, "SpotCones", "spotCones",
                 {MEMBER(SpotCone, apex), MEMBER(SpotCone, axis)}, sizeof(gpu::SpotCone), 2);
    expectBuffer(program, "PointLamps", "pointLamps",
                 {MEMBER(PointLamp, position), MEMBER(PointLamp, candela)}, sizeof(gpu::PointLamp),
                 2);
    expectBuffer(program, "DirectionalLamps", "directionalLamps",
                 {MEMBER(DirectionalLamp, towardsLamp), MEMBER(DirectionalLamp, lux)},
                 sizeof(gpu::DirectionalLamp), 2);
    expectUniforms(program, "MaterialBlock",
                   {{"material.baseColor", offsetof(gpu::SurfaceMaterial, baseColor)},
                    {"material.emission", offsetof(gpu::SurfaceMaterial, emission)},
                    {"material.factors", offsetof(gpu::SurfaceMaterial, factors)},
                    {"material.flags", offsetof(gpu::SurfaceMaterial, flags)},
                    {"material.uvRows[0]", offsetof(gpu::SurfaceMaterial, uvRows)}},
                   sizeof(gpu::SurfaceMaterial), 5);
    EXPECT_EQ(property(program, GL_UNIFORM, "material.uvRows[0]", GL_ARRAY_STRIDE),
              GLint(sizeof(glm::vec4)));
    EXPECT_EQ(property(program, GL_BUFFER_VARIABLE, "spotLamps[0].lampFromView", GL_MATRIX_STRIDE),
              GLint(sizeof(glm::vec4)));
}

TEST_F(StructLayout, WhatLayeredSurfacesRead) {
    const Program program({"passes/forward.vert", "passes/forward.frag"}, {"TEXTURES", "LAYERS"});
    expectBuffer(
        program, "LayersBlock", "layers",
        {MEMBER(SurfaceLayers, specular), MEMBER(SurfaceLayers, coat), MEMBER(SurfaceLayers, sheen),
         MEMBER(SurfaceLayers, anisotropy), MEMBER(SurfaceLayers, flags),
         Member{"uvRows[0]", offsetof(gpu::SurfaceLayers, uvRows)}},
        sizeof(gpu::SurfaceLayers), 6);
}

TEST_F(StructLayout, WhatTheSkyReads) {
    const Program program({"passes/sky_composite.comp"}, {"PHASE_KIND 0"});
    expectUniforms(program, "AtmosphereBlock",
                   {{"atmosphere.rayleigh", offsetof(gpu::Atmosphere, rayleigh)},
                    {"atmosphere.mieScattering", offsetof(gpu::Atmosphere, mieScattering)},
                    {"atmosphere.mieExtinction", offsetof(gpu::Atmosphere, mieExtinction)},
                    {"atmosphere.shell", offsetof(gpu::Atmosphere, shell)},
                    {"atmosphere.albedo", offsetof(gpu::Atmosphere, albedo)},
                    {"atmosphere.sun", offsetof(gpu::Atmosphere, sun)}},
                   sizeof(gpu::Atmosphere), 6);
    expectUniforms(program, "SkyBlock",
                   {{"sky.worldFromView", offsetof(gpu::SkyFrame, worldFromView)},
                    {"sky.zenith", offsetof(gpu::SkyFrame, zenith)},
                    {"sky.sun", offsetof(gpu::SkyFrame, sun)},
                    {"sky.sunward", offsetof(gpu::SkyFrame, sunward)},
                    {"sky.suns", offsetof(gpu::SkyFrame, suns)},
                    {"sky.aerial", offsetof(gpu::SkyFrame, aerial)},
                    {"sky.hazeMiddle", offsetof(gpu::SkyFrame, hazeMiddle)},
                    {"sky.hazePerMetre", offsetof(gpu::SkyFrame, hazePerMetre)},
                    {"sky.sunLux", offsetof(gpu::SkyFrame, sunLux)},
                    {"sky.irradiance[0]", offsetof(gpu::SkyFrame, irradiance)}},
                   sizeof(gpu::SkyFrame), 10);
    const Program shadowed({"passes/forward.vert", "passes/forward.frag"}, {"SKY", "SUN_SHADOW"});
    expectUniforms(shadowed, "SunShadowBlock",
                   {{"sunShadow.sunFromView", offsetof(gpu::SunShadow, sunFromView)},
                    {"sunShadow.cascades[0]", offsetof(gpu::SunShadow, cascades)},
                    {"sunShadow.depths[0]", offsetof(gpu::SunShadow, depths)},
                    {"sunShadow.sun", offsetof(gpu::SunShadow, sun)},
                    {"sunShadow.counts", offsetof(gpu::SunShadow, counts)}},
                   sizeof(gpu::SunShadow), 5);
    const Program points({"passes/sky_points.comp"});
    expectBuffer(points, "Rays", "rays", {MEMBER(SkyRayStart, ray), MEMBER(SkyRayStart, way)},
                 sizeof(gpu::SkyRayStart), 2);
    expectBuffer(
        points, "Lights", "lights",
        {MEMBER(SkyRayLight, transmittance), MEMBER(SkyRayLight, air), MEMBER(SkyRayLight, ground)},
        sizeof(gpu::SkyRayLight), 3);
}

// Instances are read column by column of four floats.
TEST_F(StructLayout, InstancesAreColumns) {
    const Program surfaces({"passes/forward.vert", "passes/forward.frag"});
    const auto place = [&](const char* name) {
        return glGetAttribLocation(surfaces.name(), name) - gpu::kInstanceAttribute;
    };
    EXPECT_EQ(place("viewFromLocal"),
              GLint(offsetof(gpu::SurfaceInstance, viewFromLocal) / sizeof(glm::vec4)));
    EXPECT_EQ(place("viewFromNormal"),
              GLint(offsetof(gpu::SurfaceInstance, viewFromNormal) / sizeof(glm::vec4)));
    GLint most = 0;
    glGetIntegerv(GL_MAX_VERTEX_ATTRIBS, &most);
    EXPECT_LE(gpu::kInstanceAttribute + int(sizeof(gpu::SurfaceInstance) / sizeof(glm::vec4)),
              most);
}

TEST_F(StructLayout, WindowsOntoBuffersAreAligned) {
    GLint alignment = 0;
    glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
    EXPECT_EQ(kUniformStride % std::size_t(alignment), 0U);
}

TEST_F(StructLayout, BuffersStandInTheirSlots) {
    const Program beams({"passes/beams_tiles.vert", "passes/beams_clipped.frag"}, {"PHASE_KIND 0"});
    const Program surfaces({"passes/forward.vert", "passes/forward.frag"});
    EXPECT_EQ(property(beams, GL_UNIFORM_BLOCK, "ViewBlock", GL_BUFFER_BINDING), gpu::kViewSlot);
    EXPECT_EQ(property(beams, GL_UNIFORM_BLOCK, "SettingsBlock", GL_BUFFER_BINDING),
              gpu::kBeamSettingsSlot);
    EXPECT_EQ(property(surfaces, GL_UNIFORM_BLOCK, "MaterialBlock", GL_BUFFER_BINDING),
              gpu::kMaterialSlot);
    const auto slot = [&](const Program& program, const char* block) {
        return property(program, GL_SHADER_STORAGE_BLOCK, block, GL_BUFFER_BINDING);
    };
    EXPECT_EQ(slot(beams, "SpotLamps"), gpu::kLampsSlot);
    EXPECT_EQ(slot(beams, "Tiles"), gpu::kTilesSlot);
    EXPECT_EQ(slot(beams, "TileLamps"), gpu::kTileLampsSlot);
    EXPECT_EQ(slot(surfaces, "SpotCones"), gpu::kSpotConesSlot);
    EXPECT_EQ(slot(surfaces, "PointLamps"), gpu::kPointLampsSlot);
    EXPECT_EQ(slot(surfaces, "DirectionalLamps"), gpu::kDirectionalLampsSlot);
}

#undef MEMBER

}  // namespace
}  // namespace ribalta::test
