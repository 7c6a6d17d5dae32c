// One scene, of a unit square and the light maps, whose nodes and lamps are replaced case by case:
// the renderer keeps its programs, and thousands of cases run. Nothing else is kept between frames.
#include "stage.h"

#include "render/read_frame.h"
#include "render/renderer.h"

namespace ribalta::stress {
namespace {

Mesh unitSquare() {
    Primitive primitive;
    for (const glm::vec2 corner :
         {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
        primitive.positions.emplace_back(corner, 0.0F);
        primitive.normals.emplace_back(0.0F, 0.0F, 1.0F);
        primitive.bounds.add(glm::dvec3(corner, 0.0));
    }
    primitive.indices = {0, 1, 2, 0, 2, 3};
    primitive.material = 0;
    Mesh mesh;
    mesh.primitives.push_back(std::move(primitive));
    return mesh;
}

Node place(const Rectangle& rectangle) {
    const glm::dvec3 normal = glm::normalize(glm::cross(rectangle.halfU, rectangle.halfV));
    Node node;
    node.mesh = 0;
    node.worldFromLocal =
        glm::dmat4(glm::dvec4(rectangle.halfU, 0.0), glm::dvec4(rectangle.halfV, 0.0),
                   glm::dvec4(normal, 0.0), glm::dvec4(rectangle.centre, 1.0));
    node.parentFromLocal = node.worldFromLocal;
    return node;
}

Scene makeScene() {
    Scene scene;
    scene.meshes.push_back(unitSquare());
    Material material;
    material.metallic = 0.0F;
    material.doubleSided = true;
    scene.materials.push_back(material);
    scene.images = lightMaps();
    // Which light maps are uploaded follows from the lamps that are there at first.
    for (std::size_t i = 0; i < scene.images.size(); ++i) {
        SpotLight lamp;
        lamp.lightMap = LightMap{int(i), 0.0};
        scene.spotLights.push_back(lamp);
    }
    return scene;
}

}  // namespace

struct Stage::State {
    Scene scene = makeScene();
    Renderer renderer{scene};
};

Stage::Stage() : state_(std::make_unique<State>()) {}
Stage::~Stage() = default;

Drawn Stage::draw(const SetUp& setUp, BeamMethod method, const std::optional<double>& ev100) {
    Scene& scene = state_->scene;
    scene.spotLights = setUp.lamps;
    scene.nodes.clear();
    for (const Rectangle& rectangle : setUp.rectangles) {
        scene.nodes.push_back(place(rectangle));
    }
    FrameSettings settings;
    settings.width = setUp.width;
    settings.height = setUp.height;
    settings.haze = setUp.haze;
    settings.beams.method = method;
    settings.beams.planes = setUp.sheets;
    settings.beamsOutput = true;
    settings.ev100 = ev100;

    Renderer& renderer = state_->renderer;
    renderer.forget();
    const FramePlan& plan = renderer.draw(setUp.camera, settings);
    FrameLayers layers;
    layers.beams = layers.transmittance = true;
    Drawn drawn;
    drawn.image = readFrame(plan, renderer.targets(), layers);
    drawn.ev100 = renderer.ev100();
    drawn.tolerance = method == BeamMethod::kAdaptive ? settings.beams.usedTolerance() : 0.0;
    drawn.shadowSide = plan.shadowMaps.side;
    if (method == BeamMethod::kPlanes && plan.beams) {
        drawn.sampledDepths = {plan.beams->firstDepth,
                               plan.beams->firstDepth + plan.beams->spacingMetres * setUp.sheets};
    }
    return drawn;
}

glm::dvec3 Drawn::color(int x, int y, const char* layer) const {
    const std::string prefix = *layer == '\0' ? "" : std::string(layer) + ".";
    const int first = image.channel(prefix + "R");
    return {image.at(x, y, first), image.at(x, y, first + 1), image.at(x, y, first + 2)};
}

}  // namespace ribalta::stress
