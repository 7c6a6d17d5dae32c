// The frame plan held against what OpenGL was really asked for: what a frame does not need is not
// made, built or drawn.
#include <cmath>
#include <functional>

#include "gl/counters.h"
#include "gpu_test.h"
#include "reference_beams.h"
#include "support/random_stage.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

/// How many names OpenGL itself knows of a kind.
template <typename IsOne>
int countLive(const IsOne& isOne) {
    int count = 0;
    for (GLuint name = 1; name < 5000; ++name) {
        count += isOne(name) == GL_TRUE ? 1 : 0;
    }
    return count;
}

/// A program that is deleted but still in use somewhere in the driver is no longer ours.
GLboolean isOurProgram(GLuint name) {
    GLint deleted = GL_TRUE;
    if (glIsProgram(name) == GL_TRUE) {
        glGetProgramiv(name, GL_DELETE_STATUS, &deleted);
    }
    return deleted == GL_TRUE ? GL_FALSE : GL_TRUE;
}

struct Live {
    int programs = countLive(isOurProgram);
    int textures = countLive([](GLuint name) { return glIsTexture(name); });
    int framebuffers = countLive([](GLuint name) { return glIsFramebuffer(name); });
    int buffers = countLive([](GLuint name) { return glIsBuffer(name); });
};

class Skipping : public GpuTest {
  protected:
    Skipping() {
        addShape(scene_, makeQuad({0, 0, 0}, {5, 0, 0}, {0, 0, -5}), makeMaterial(glm::vec3(0.5F)));
        addShape(scene_, makeSphere({0, 1, 0}, 0.5F, 16), makeMaterial(glm::vec3(0.5F)));
        scene_.spotLights.push_back(makeSpot({0, 5, 0}, {0, 0, 0}, 0.3));
        settings_.haze.scatteringPerMetre = 0.05;
        // Of one program and no picture of its own: what a frame adds can be counted.
        settings_.beams.method = BeamMethod::kClipped;
        settings_.beams.planes = 8;
    }

    /// What a new renderer's first frame has made, by OpenGL's own count.
    Live firstFrame() {
        const Live before;
        Renderer renderer(scene_);
        renderer.draw(camera_, settings_);
        line_ = renderer.lastPlan().describe();
        const Live after;
        return {after.programs - before.programs, after.textures - before.textures,
                after.framebuffers - before.framebuffers, after.buffers - before.buffers};
    }

    Scene scene_;
    Camera camera_ = makeCamera({0, 2, 8}, {0, 1, 0});
    FrameSettings settings_ = measuringSettings();
    std::string line_;
};

TEST_F(Skipping, OnlyWhatThePlanNamesIsBuilt) {
    // Surfaces alone: one program, the frame's colours and depth.
    Scene whole = scene_;
    scene_.spotLights.clear();
    Live made = firstFrame();
    EXPECT_EQ(line_, "forward");
    EXPECT_EQ(made.programs, 1);
    EXPECT_EQ(made.textures, 2);
    const int framebuffers = made.framebuffers;

    // A lamp without haze: a shadow program, one texture for its map, no beam program.
    scene_ = whole;
    settings_.haze.scatteringPerMetre = 0.0;
    made = firstFrame();
    EXPECT_EQ(line_, "shadow_map[1] forward");
    EXPECT_EQ(made.programs, 2);
    EXPECT_EQ(made.textures, 3);
    EXPECT_EQ(made.framebuffers, framebuffers + 1);

    // Haze: one program more, no texture.
    settings_.haze.scatteringPerMetre = 0.05;
    made = firstFrame();
    EXPECT_EQ(line_, "shadow_map[1] forward beams[1]");
    EXPECT_EQ(made.programs, 3);
    EXPECT_EQ(made.textures, 3);

    // A light map: one texture more.
    useLightMap(scene_, scene_.spotLights[0],
                makeImage(8, 8, [](int, int) { return glm::vec4(1.0F); }));
    made = firstFrame();
    EXPECT_EQ(made.programs, 3);
    EXPECT_EQ(made.textures, 4);

    // A picture for a screen: a program and a texture; looking for the exposure: a program more.
    settings_.display = true;
    settings_.ev100 = 3.0;
    made = firstFrame();
    EXPECT_EQ(line_, "shadow_map[1] forward beams[1] tonemap");
    EXPECT_EQ(made.programs, 4);
    EXPECT_EQ(made.textures, 5);
    settings_.ev100.reset();
    made = firstFrame();
    EXPECT_EQ(line_, "shadow_map[1] forward beams[1] exposure tonemap");
    EXPECT_EQ(made.programs, 5);
    EXPECT_EQ(made.textures, 5);
}

TEST_F(Skipping, AnEmptySceneBuildsNoProgram) {
    scene_ = {};
    const std::uint64_t drawCalls = glCounters().drawCalls;
    const Live made = firstFrame();
    EXPECT_EQ(line_, "nothing");
    EXPECT_EQ(made.programs, 0);
    EXPECT_EQ(made.textures, 2) << "the frame's colours and depth";
    EXPECT_EQ(glCounters().drawCalls, drawCalls);
}

TEST_F(Skipping, LampsWithoutCastersHaveNoShadowTexture) {
    scene_.spotLights[0] = makeSpot({0, 3, 0}, {0, 9, 0}, 0.3);
    const Live made = firstFrame();
    EXPECT_EQ(line_, "forward beams[1]");
    EXPECT_EQ(made.programs, 2);
    EXPECT_EQ(made.textures, 2);
}

TEST_F(Skipping, DarkLampsBuildNothing) {
    scene_.spotLights[0].intensityCandela = 0.0;
    const Live made = firstFrame();
    EXPECT_EQ(line_, "forward");
    EXPECT_EQ(made.programs, 1);
    EXPECT_EQ(made.textures, 2);
}

std::uint64_t plannedDrawCalls(const Scene& scene, const FramePlan& plan) {
    const auto runs = [&](const std::vector<int>& list) {
        std::size_t count = 0;
        for (std::size_t first = 0; first < list.size();
             first = endOfInstances(scene, plan.draws, list, first)) {
            ++count;
        }
        return count;
    };
    std::size_t calls = 0;
    for (const ShadowMapWork& work : plan.shadowMapWork) {
        calls += runs(work.casters);
    }
    if (plan.forward) {
        calls += runs(plan.forward->opaque) + runs(plan.forward->blended);
    }
    if (plan.beams) {
        calls += plan.beams->settings.method == BeamMethod::kPlanes ? plan.beams->lamps.size() : 1;
    }
    if (plan.tonemap) {
        calls += plan.tonemap->ev100 ? 1 : 2;
    }
    return calls;
}

TEST_F(Skipping, DrawCallsAreWhatThePlanSays) {
    scene_.spotLights.push_back(makeSpot({3, 4, 1}, {0, 0.5, 0}, 0.2));
    Material glass = makeMaterial(glm::vec3(0.5F));
    glass.alphaMode = Material::AlphaMode::kBlend;
    addShape(scene_, makeQuad({0, 1, 2}, {1, 0, 0}, {0, 1, 0}), glass);
    for (const auto method : {BeamMethod::kClipped, BeamMethod::kPlanes}) {
        for (const bool display : {false, true}) {
            Renderer renderer(scene_);
            settings_.beams.method = method;
            settings_.display = display;
            for (int frame = 0; frame < 2; ++frame) {
                renderer.redrawNextFrame();
                const std::uint64_t before = glCounters().drawCalls;
                const FramePlan& plan = renderer.draw(camera_, settings_);
                EXPECT_EQ(glCounters().drawCalls - before, plannedDrawCalls(scene_, plan))
                    << plan.describe();
                EXPECT_EQ(plan.shadowMapWork.empty(), frame == 1);
                EXPECT_EQ(plan.forward->blended.size(), 1U);
            }
        }
    }
}

// Only the light maps of lamps that are drawn take memory, and only with one are they asked for.
TEST_F(Skipping, NoLightMapOfALampThatIsNotDrawn) {
    Scene plain = scene_;
    useLightMap(scene_, scene_.spotLights[0],
                makeImage(8, 8, [](int, int) { return glm::vec4(1.0F); }));
    settings_.haze.scatteringPerMetre = 0.05;
    const auto texturesOf = [&](const Scene& scene) {
        const GlCounters before = glCounters();
        Renderer renderer(scene);
        renderer.draw(camera_, settings_);
        EXPECT_EQ(renderer.lastPlan().lamps.size(), 1U);
        return int(glCounters().texturesMade - before.texturesMade);
    };
    const int lit = texturesOf(scene_);
    SpotLight dark = scene_.spotLights[0];
    dark.intensityCandela = 0.0;
    scene_.spotLights[0].lightMap.reset();
    scene_.spotLights.push_back(dark);
    EXPECT_EQ(texturesOf(scene_), texturesOf(plain));
    EXPECT_EQ(texturesOf(scene_) + 1, lit);
}

TEST_F(Skipping, TheSecondFrameMakesNothingNew) {
    useLightMap(scene_, scene_.spotLights[0],
                makeImage(8, 8, [](int, int) { return glm::vec4(1.0F); }));
    settings_.display = true;
    Renderer renderer(scene_);
    renderer.draw(camera_, settings_);
    const Frame3 first = readBack(renderer);
    renderer.redrawNextFrame();
    const GlCounters before = glCounters();
    const Live liveBefore;
    renderer.draw(camera_, settings_);
    const GlCounters after = glCounters();
    const Live liveAfter;
    EXPECT_EQ(renderer.lastPlan().describe(), "forward beams[1] exposure tonemap");
    EXPECT_EQ(after.programsBuilt, before.programsBuilt);
    EXPECT_EQ(after.texturesMade, before.texturesMade);
    EXPECT_EQ(after.framebuffersMade, before.framebuffersMade);
    EXPECT_EQ(after.bytesAllocated, before.bytesAllocated);
    EXPECT_EQ(liveAfter.programs, liveBefore.programs);
    EXPECT_EQ(liveAfter.textures, liveBefore.textures);
    EXPECT_EQ(liveAfter.buffers, liveBefore.buffers);
    // And is the same picture.
    EXPECT_EQ(readBack(renderer).image.values, first.image.values);
}

TEST_F(Skipping, AdaptiveTellsHowManySamplesItTook) {
    settings_.width = 64;  // whole tiles
    settings_.height = 48;
    Renderer renderer(scene_);
    renderer.draw(camera_, settings_);
    const std::uint64_t atEveryPixel = renderer.beamSamples();
    EXPECT_EQ(atEveryPixel, renderer.lastPlan().beamSamples());

    settings_.beams.method = BeamMethod::kAdaptive;
    std::uint64_t before = atEveryPixel + 1;
    std::uint64_t all = 0;
    for (const double tolerance : {0.0, 0.001, 1.0}) {
        settings_.beams.tolerance = tolerance;
        renderer.draw(camera_, settings_);
        const std::uint64_t samples = renderer.beamSamples();
        EXPECT_LT(samples, before) << tolerance;
        before = samples;
        if (tolerance == 0.0) {
            all = renderer.lastPlan().beamSamples();  // its tiles are smaller
            EXPECT_EQ(samples, all);
        }
    }
    EXPECT_GE(before, all / 16) << "the lattice itself";
    renderer.draw(camera_, settings_);
    EXPECT_EQ(renderer.beamSamples(), 0U) << "a picture that is kept";
}

TEST_F(Skipping, AFrameInWhichNothingChangedDrawsNothing) {
    settings_.display = true;
    Renderer renderer(scene_);
    renderer.draw(camera_, settings_);
    renderer.takeTimes();
    const Frame3 first = readBack(renderer);
    const std::uint64_t samples = renderer.lastPlan().beamSamples();
    EXPECT_GT(samples, 0U);
    for (int frame = 0; frame < 3; ++frame) {
        const GlCounters before = glCounters();
        const FramePlan& plan = renderer.draw(camera_, settings_);
        const GlCounters after = glCounters();
        EXPECT_EQ(plan.describe(), "kept");
        EXPECT_EQ(plan.beamSamples(), 0U);
        EXPECT_EQ(plan.shadowMapsKept, 1);
        EXPECT_EQ(after.drawCalls, before.drawCalls);
        EXPECT_EQ(after.texturesMade, before.texturesMade);
        EXPECT_EQ(after.bytesAllocated, before.bytesAllocated);
        EXPECT_TRUE(renderer.takeTimes().empty());
        EXPECT_EQ(readBack(renderer).image.values, first.image.values);
        EXPECT_TRUE(renderer.ev100().has_value());
    }
    // Asked to, it draws the same again: the passes, or the shadow maps as well.
    renderer.redrawNextFrame();
    EXPECT_EQ(renderer.draw(camera_, settings_).describe(), "forward beams[1] exposure tonemap");
    EXPECT_EQ(renderer.draw(camera_, settings_).describe(), "kept");
    renderer.forget();
    EXPECT_EQ(renderer.draw(camera_, settings_).describe(),
              "shadow_map[1] forward beams[1] exposure tonemap");
    EXPECT_EQ(readBack(renderer).image.values, first.image.values);
}

TEST_F(Skipping, ByEveryMethod) {
    settings_.display = true;
    settings_.ev100 = 5.0;
    for (const auto& [method, methodName] : beamMethods()) {
        settings_.beams.method = method;
        // Without haze no method builds anything of its own.
        settings_.haze.scatteringPerMetre = 0.0;
        const Live made = firstFrame();
        EXPECT_EQ(line_, "shadow_map[1] forward tonemap") << methodName;
        EXPECT_EQ(made.programs, 3) << methodName;
        EXPECT_EQ(made.textures, 4) << methodName;
        // With it, a still frame draws nothing again.
        settings_.haze.scatteringPerMetre = 0.05;
        Renderer renderer(scene_);
        renderer.draw(camera_, settings_);
        const Frame3 first = readBack(renderer);
        const GlCounters before = glCounters();
        EXPECT_TRUE(renderer.draw(camera_, settings_).kept) << methodName;
        EXPECT_EQ(glCounters().drawCalls, before.drawCalls) << methodName;
        EXPECT_EQ(glCounters().bytesAllocated, before.bytesAllocated) << methodName;
        EXPECT_EQ(readBack(renderer).image.values, first.image.values) << methodName;
    }
}

TEST_F(Skipping, WhateverChangesIsDrawn) {
    scene_.pointLights.push_back({"point", -1, {2, 3, 2}, glm::vec3(1.0F), 20.0, 30.0});
    scene_.directionalLights.push_back({"sun", -1, {0, -1, 0}, glm::vec3(1.0F), 5.0});
    Renderer renderer(scene_);
    renderer.draw(camera_, settings_);
    const std::vector<std::function<void()>> changes = {
        [&] { camera_.frame.position.x += 0.1; },
        [&] {
            camera_.lens = PerspectiveLens{0.7, std::nullopt};
        },
        [&] { camera_.nearMetres = 6.0; },
        [&] { camera_.farMetres = 9.0; },
        [&] { settings_.width = 40; },
        [&] { settings_.haze.scatteringPerMetre = 0.06; },
        [&] { settings_.haze.absorptionPerMetre = 0.01; },
        [&] { settings_.haze.phase.k = 1.0; },
        [&] { settings_.haze.phase.kind = PhaseFunction::Kind::kIsotropic; },
        [&] { settings_.beams.planes = 9; },
        [&] { settings_.beams.method = BeamMethod::kPlanes; },
        [&] { settings_.ambientLux = 2.0; },
        [&] { scene_.spotLights[0].frame.position.y += 0.1; },
        [&] { scene_.spotLights[0].color.x = 0.5F; },
        [&] { scene_.spotLights[0].intensityCandela = 900.0; },
        [&] { scene_.spotLights[0].innerConeAngle = 0.1; },
        [&] { scene_.spotLights[0].outerConeAngle = 0.2; },
        [&] { scene_.spotLights[0].rangeMetres = 20.0; },
        [&] { scene_.spotLights[0].beamShape = BeamShape::kPyramid; },
        [&] { scene_.pointLights[0].intensityCandela = 30.0; },
        [&] { scene_.directionalLights[0].illuminanceLux = 6.0; },
        [&] {
            moveNode(scene_, 1, {0.1, 0.0, 0.0});
        },
        [&] { scene_.nodes[1].shown = false; }};
    Frame3 before = readBack(renderer);
    for (std::size_t i = 0; i < changes.size(); ++i) {
        changes[i]();
        EXPECT_FALSE(renderer.draw(camera_, settings_).kept) << "change " << i;
        const Frame3 after = readBack(renderer);
        EXPECT_NE(after.image.values, before.image.values) << "change " << i;
        EXPECT_TRUE(renderer.draw(camera_, settings_).kept) << "change " << i;
        before = after;
    }
    settings_.display = true;
    EXPECT_FALSE(renderer.draw(camera_, settings_).kept);
}

// Dials of animations: what follows from one is drawn anew, and nothing else. Each frame is held
// against one of a renderer that has seen none of the ones before.
class TurnedDials : public Skipping {
  protected:
    TurnedDials() : renderer_(withSecondLamp()) { renderer_.draw(camera_, settings_); }

    // Draws the scene with a dial's first number at `value`, and returns the plan's line.
    std::string turn(Dial::List list, Dial::Numbers numbers, const glm::dvec4& values,
                     int owner = 0) {
        Dial dial;
        dial.list = list;
        dial.numbers = numbers;
        dial.owners = {owner};
        dial.rest = values;
        dial.now = values;
        scene_.dials[0] = dial;
        bringTo(dial, scene_);
        placeNodes(scene_);
        const std::string line = renderer_.draw(camera_, settings_).describe();
        EXPECT_EQ(readBack(renderer_).image.values,
                  drawOnce(scene_, camera_, settings_).image.values);
        return line;
    }

    Renderer renderer_;

  private:
    const Scene& withSecondLamp() {
        scene_.spotLights.push_back(makeSpot({3, 4, 1}, {0, 0.5, 0}, 0.2));
        scene_.dials.emplace_back();
        scene_.dials[0].list = Dial::List::kMaterials;
        scene_.dials[0].numbers = Dial::Numbers::kBaseColor;
        scene_.dials[0].owners = {0};
        scene_.dials[0].rest = scene_.dials[0].now = glm::dvec4(scene_.materials[0].baseColor);
        return scene_;
    }
};

TEST_F(TurnedDials, BrightnessKeepsShadows) {
    const std::string plain = "forward beams[2]";
    EXPECT_EQ(turn(Dial::List::kSpotLights, Dial::Numbers::kIntensity, glm::dvec4(400.0)), plain);
    EXPECT_EQ(turn(Dial::List::kSpotLights, Dial::Numbers::kColor, {1.0, 0.2, 0.1, 0.0}), plain);
    EXPECT_EQ(turn(Dial::List::kSpotLights, Dial::Numbers::kIntensity, glm::dvec4(0.0)),
              "forward beams[1]");
    // Its shadow map is still there when it is lit again.
    EXPECT_EQ(turn(Dial::List::kSpotLights, Dial::Numbers::kIntensity, glm::dvec4(5.0)), plain);
    EXPECT_EQ(turn(Dial::List::kSpotLights, Dial::Numbers::kCone, {0.1, 0.3, 0.0, 0.0}), plain)
        << "the inner cone alone";
}

TEST_F(TurnedDials, ConesDrawTheirOwnShadowMapAnew) {
    const std::string one = "shadow_map[1] forward beams[2]";
    EXPECT_EQ(turn(Dial::List::kSpotLights, Dial::Numbers::kCone, {0.0, 0.35, 0.0, 0.0}), one);
    EXPECT_EQ(turn(Dial::List::kSpotLights, Dial::Numbers::kCone, {0.0, 0.15, 0.0, 0.0}, 1), one);
    EXPECT_EQ(turn(Dial::List::kSpotLights, Dial::Numbers::kRange, glm::dvec4(4.7)), one);
    // As it is: nothing at all.
    EXPECT_EQ(renderer_.draw(camera_, settings_).describe(), "kept");
}

TEST_F(TurnedDials, WhatIsHiddenCastsNoShadow) {
    // Two things of one place, of which the first goes: the other one is not taken for it.
    const int box = addShape(scene_, makeBox({-0.2F, 2, -0.2F}, {0.2F, 2.4F, 0.2F}),
                             makeMaterial(glm::vec3(0.5F)));
    Renderer fresh(scene_);
    fresh.draw(camera_, settings_);
    scene_.nodes[1].visible = false;
    placeNodes(scene_);
    EXPECT_EQ(fresh.draw(camera_, settings_).shadowMapWork.size(), 2U);
    EXPECT_EQ(readBack(fresh).image.values, drawOnce(scene_, camera_, settings_).image.values);
    scene_.nodes[1].visible = true;
    scene_.nodes[std::size_t(box)].visible = false;
    placeNodes(scene_);
    EXPECT_FALSE(fresh.draw(camera_, settings_).shadowMapWork.empty());
    EXPECT_EQ(readBack(fresh).image.values, drawOnce(scene_, camera_, settings_).image.values);
}

TEST_F(TurnedDials, ColoursOfMaterialsAreUploaded) {
    EXPECT_EQ(turn(Dial::List::kMaterials, Dial::Numbers::kBaseColor, {0.1, 0.9, 0.2, 1.0}),
              "forward beams[2]");
    EXPECT_EQ(renderer_.draw(camera_, settings_).describe(), "kept");
    EXPECT_EQ(turn(Dial::List::kMaterials, Dial::Numbers::kEmission, {1.0, 0.5, 0.0, 30.0}),
              "forward beams[2]");
}

TEST_F(TurnedDials, HolesThatCloseCastShadows) {
    Material& sphere = scene_.materials[1];
    sphere.alphaMode = Material::AlphaMode::kMask;
    renderer_.usePictures();
    turn(Dial::List::kMaterials, Dial::Numbers::kBaseColor, {0.5, 0.5, 0.5, 0.4}, 1);
    EXPECT_EQ(turn(Dial::List::kMaterials, Dial::Numbers::kBaseColor, {0.5, 0.5, 0.5, 0.6}, 1),
              "shadow_map[2] forward beams[2]");
}

// The lamps that are left out change nothing (that none of them would be seen is held against rays
// in the unit tests), nor does leaving them out mix up those that stay.
TEST_F(Skipping, SkippedLampsChangeNoPixel) {
    settings_.width = 40;
    settings_.height = 30;
    int skipped = 0;
    int kept = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        const RandomStage stage(seed);
        Renderer renderer(stage.scene);
        const FramePlan plan = renderer.draw(stage.camera, settings_);
        const Frame3 all = readBack(renderer);
        Scene fewer = stage.scene;
        fewer.spotLights.clear();
        for (const PlannedLamp& lamp : plan.lamps) {
            fewer.spotLights.push_back(stage.scene.spotLights[std::size_t(lamp.spot)]);
        }
        const Frame3 same = drawOnce(fewer, stage.camera, settings_);
        EXPECT_EQ(all.image.values, same.image.values) << "seed " << seed;
        EXPECT_EQ(countNotFinite(all), 0);
        skipped += plan.lampsSkipped;
        kept += int(plan.lamps.size());
    }
    EXPECT_GT(skipped, 60);
    EXPECT_GT(kept, 60);
}

// The same lamp with its beam's place in the picture narrowed to what its light map lets through,
// and with texels so faint at the map's edge that they add nothing but keep it from being narrowed.
TEST_F(Skipping, ABlackRimIsLeftOutWithoutBeingMissed) {
    settings_.width = 320;
    settings_.height = 240;
    settings_.beams.planes = 48;
    for (const auto shape : {BeamShape::kCone, BeamShape::kPyramid}) {
        Picture pictures[2];
        int tiles[2];
        for (int whole = 0; whole < 2; ++whole) {
            Scene scene = scene_;
            scene.spotLights[0] = makeSpot({0, 5, 0}, {0, 0, 0}, 0.5);
            scene.spotLights[0].beamShape = shape;
            const auto texel = [&](int x, int y) {
                const bool edge = x == 127 || y == 127 || x == 0 || y == 0;
                const glm::vec4 dark(0, 0, whole == 1 && edge ? 1.0F / 255.0F : 0.0F, 1);
                return std::hypot(x - 63.5, y - 63.5) < 32.0 ? glm::vec4(1, 0.5, 0.2, 1) : dark;
            };
            useLightMap(scene, scene.spotLights[0], makeImage(128, 128, texel), 0.4);
            pictures[whole] = drawnBeams(scene, camera_, settings_);
            const FramePlan plan =
                planFrame(scene, camera_, settings_, FrameCache(), litRegions(scene));
            tiles[whole] = plan.beamTilesDrawn();
        }
        const double apart = relativeRmse(pictures[0], pictures[1]);
        std::printf("tiles %d of %d, pictures %.6f apart\n", tiles[0], tiles[1], apart);
        EXPECT_LT(tiles[0], 0.8 * tiles[1]);
        EXPECT_LT(apart, 5e-4);
    }
}

TEST_F(Skipping, ABlackLightMapMakesADarkLamp) {
    useLightMap(scene_, scene_.spotLights[0],
                makeImage(8, 8, [](int, int) { return glm::vec4(0, 0, 0, 1); }));
    Renderer renderer(scene_);
    const FramePlan& plan = renderer.draw(camera_, settings_);
    EXPECT_EQ(plan.describe(), "forward");
    EXPECT_EQ(plan.skipped.dark, 1);
}

TEST_F(Skipping, CountersAgreeWithOpenGl) {
    settings_.display = true;
    const GlCounters before = glCounters();
    const Live made = firstFrame();
    const GlCounters after = glCounters();
    EXPECT_EQ(after.programsBuilt - before.programsBuilt, std::uint64_t(made.programs));
    EXPECT_EQ(after.texturesMade - before.texturesMade, std::uint64_t(made.textures));
    EXPECT_EQ(after.framebuffersMade - before.framebuffersMade, std::uint64_t(made.framebuffers));
}

TEST_F(Skipping, ARendererLeavesNothingBehind) {
    settings_.display = true;
    const Live before;
    const std::uint64_t bytes = glCounters().bytesAllocated;
    firstFrame();
    const Live after;
    EXPECT_EQ(after.programs, before.programs);
    EXPECT_EQ(after.textures, before.textures);
    EXPECT_EQ(after.framebuffers, before.framebuffers);
    EXPECT_EQ(after.buffers, before.buffers);
    EXPECT_EQ(glCounters().bytesAllocated, bytes);
}

TEST_F(Skipping, AMovedCasterIsSeenInTheNextFrame) {
    Renderer renderer(scene_);
    renderer.draw(camera_, settings_);
    moveNode(scene_, 1, {0.5, 0.5, 0.0});
    renderer.draw(camera_, settings_);
    EXPECT_EQ(renderer.lastPlan().describe(), "shadow_map[1] forward beams[1]");
    const Frame3 kept = readBack(renderer);
    // A renderer that knows nothing of earlier frames draws the same.
    EXPECT_EQ(drawOnce(scene_, camera_, settings_).image.values, kept.image.values);
    renderer.forget();
    renderer.draw(camera_, settings_);
    EXPECT_EQ(renderer.lastPlan().describe(), "shadow_map[1] forward beams[1]");
}

TEST_F(Skipping, EveryPassDrawnHasATime) {
    settings_.display = true;
    Renderer renderer(scene_);
    renderer.draw(camera_, settings_);
    std::string names;
    for (const PassTime& time : renderer.takeTimes()) {
        names += time.name + ' ';
        EXPECT_GE(time.cpuMs, 0.0);
        EXPECT_GE(time.gpuMs, 0.0);
    }
    EXPECT_EQ(names, "upload shadow_map forward beams tonemap ");
}

}  // namespace
}  // namespace ribalta::test
