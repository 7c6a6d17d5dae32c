#include "viewer/pointer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <epoxy/gl.h>
// After epoxy: GLFW brings OpenGL's own header otherwise.
#include <GLFW/glfw3.h>
#include <imgui/imgui.h>

#include "viewer/lamp_marks.h"

namespace ribalta {
namespace {

constexpr double kReachPixels = 12.0;
constexpr float kClickPixels = 4.0F;
constexpr double kTurnAWindow = std::numbers::pi;  ///< radians for a drag of a window's height
constexpr double kWheelStep = 0.88;
constexpr double kZoomStep = 1.05;

ImVec2 toPointer(const glm::dvec2& pixels, glm::vec2 scale) {
    return {float(pixels.x) / scale.x, float(pixels.y) / scale.y};
}

const LampId* chosen(const ViewerState& state, const StageView& stage) {
    return state.selected >= 0 && state.selected < int(stage.lamps().size())
               ? &stage.lamps()[std::size_t(state.selected)]
               : nullptr;
}

void drawMarks(const ViewerState& state, const StageView& stage, glm::ivec2 window,
               glm::vec2 scale) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const Camera& camera = state.view.camera;
    constexpr ImU32 kPlain = IM_COL32(255, 220, 120, 170);
    constexpr ImU32 kDark = IM_COL32(110, 110, 110, 170);
    constexpr ImU32 kChosen = IM_COL32(255, 255, 255, 255);
    for (std::size_t i = 0; i < stage.lamps().size(); ++i) {
        const bool isChosen = state.selected == int(i);
        const LampId& lamp = stage.lamps()[i];
        const std::optional<glm::dvec3> place = placeOf(stage.scene(), lamp);
        const std::optional<Projected> mark =
            place ? project(camera, window, *place) : std::optional<Projected>();
        if (!mark || (!state.showLamps && !isChosen)) {
            continue;
        }
        const ImVec2 at = toPointer(mark->at, scale);
        const bool isLit = intensityOf(stage.scene(), lamp) > 0.0;
        list.AddCircle(at, 6.0F, isChosen ? kChosen : (isLit ? kPlain : kDark), 16, 1.5F);
        if (!isChosen) {
            continue;
        }
        const std::optional<glm::dvec3> aim = aimOf(stage.scene(), lamp, stage.bounds());
        const std::optional<Projected> end =
            aim ? project(camera, window, *aim) : std::optional<Projected>();
        if (end) {
            const ImVec2 cross = toPointer(end->at, scale);
            list.AddLine(at, cross, IM_COL32(255, 255, 255, 90));
            list.AddLine({cross.x - 7.0F, cross.y}, {cross.x + 7.0F, cross.y}, kChosen, 2.0F);
            list.AddLine({cross.x, cross.y - 7.0F}, {cross.x, cross.y + 7.0F}, kChosen, 2.0F);
        }
    }
}

bool isOnAim(const ViewerState& state, const StageView& stage, glm::ivec2 window, glm::dvec2 at) {
    const LampId* lamp = chosen(state, stage);
    const std::optional<glm::dvec3> aim =
        lamp == nullptr ? std::nullopt : aimOf(stage.scene(), *lamp, stage.bounds());
    const std::optional<Projected> cross =
        aim ? project(state.view.camera, window, *aim) : std::optional<Projected>();
    return cross && glm::distance(cross->at, at) <= kReachPixels;
}

// The point of the plane through `point` that faces the camera, at a place of the picture.
glm::dvec3 beside(const Camera& camera, glm::ivec2 window, const glm::dvec3& point, glm::dvec2 at) {
    const std::optional<Projected> there = project(camera, window, point);
    if (!there) {
        return point;
    }
    const glm::dvec2 half = viewHalfExtent(camera, window.x, window.y);
    const double depth = camera.isOrthographic() ? 1.0 : there->depth;
    const glm::dvec2 metresAPixel = 2.0 * half * depth / glm::dvec2(window);
    const glm::dvec2 moved = (at - there->at) * metresAPixel;
    return point + moved.x * camera.frame.right() - moved.y * camera.frame.up();
}

}  // namespace

void Pointer::dragCamera(ViewerState& state, glm::ivec2 window, glm::dvec2 moved) const {
    const ImGuiIO& io = ImGui::GetIO();
    const glm::dvec2 turn = moved * (kTurnAWindow / std::max(1, window.y));
    const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
    if (ImGui::IsMouseDown(ImGuiMouseButton_Middle) || (left && io.KeyShift)) {
        pan(state.view, moved, window);
    } else if (left && io.KeyCtrl) {
        lookAround(state.view, {-turn.x, turn.y});
    } else if (left) {
        orbit(state.view, {-turn.x, turn.y});
    } else {
        dolly(state.view, std::exp(2.0 * moved.y / std::max(1, window.y)));
    }
}

void Pointer::dragAim(ViewerState& state, const StageView& stage, glm::ivec2 window) const {
    const LampId* lamp = chosen(state, stage);
    if (lamp == nullptr || lamp->kind != LampId::Kind::kSpot) {
        return;
    }
    const Frame& frame = stage.scene().spotLights[std::size_t(lamp->index)].frame;
    std::optional<glm::dvec3> target;
    if (stage.hasPicture()) {
        target = stage.surfaceAt(stage.pixelAt(at_ / glm::dvec2(window)));
    }
    if (!target) {
        target =
            beside(state.view.camera, window, *aimOf(stage.scene(), *lamp, stage.bounds()), at_);
    }
    if (glm::distance(*target, frame.position) > 1e-6) {
        state.changeOf(*lamp).frame = turned(frame, *target - frame.position);
    }
}

bool Pointer::walkByKeys(const std::vector<KeyPress>& keys, ViewerState& state,
                         const StageView& stage) {
    const ImGuiIO& io = ImGui::GetIO();
    // Ctrl+S is no step back, also where Ctrl is let go of first.
    for (const KeyPress& press : keys) {
        if (!press.control && !io.WantTextInput) {
            held_.insert(press.key);
        }
    }
    std::erase_if(held_, [](int key) { return !ImGui::IsKeyDown(key); });
    const auto axis = [this](int less, int more) {
        return double(held_.contains(more)) - double(held_.contains(less));
    };
    const glm::dvec3 direction(axis(GLFW_KEY_A, GLFW_KEY_D), axis(GLFW_KEY_Q, GLFW_KEY_E),
                               axis(GLFW_KEY_S, GLFW_KEY_W));
    if (direction == glm::dvec3(0.0)) {
        return false;
    }
    // Through a whole scene in some ten seconds, whatever its units.
    const double size =
        stage.bounds().isEmpty() ? 10.0 : 2.0 * glm::length(stage.bounds().halfSize());
    const double pace = 0.1 * size * (io.KeyShift ? 4.0 : 1.0);
    walk(state.view, direction * pace * double(std::min(io.DeltaTime, 0.1F)));
    return true;
}

void Pointer::steer(const std::vector<KeyPress>& keys, ViewerState& state, const StageView& stage,
                    glm::ivec2 window, glm::vec2 scale) {
    const ImGuiIO& io = ImGui::GetIO();
    overPanels_ = io.WantCaptureMouse;
    at_ = glm::dvec2(io.MousePos.x * scale.x, io.MousePos.y * scale.y);
    const glm::dvec2 moved(io.MouseDelta.x * scale.x, io.MouseDelta.y * scale.y);
    if (state.showLamps || state.selected >= 0) {
        drawMarks(state, stage, window, scale);
    }
    walking_ = walkByKeys(keys, state, stage);
    if (overPanels_) {
        aiming_ = false;
        return;
    }
    if (io.MouseWheel != 0.0F) {
        dolly(state.view, std::pow(kWheelStep, double(io.MouseWheel)));
    }
    const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        dragged_ = false;
        aiming_ = !io.KeyShift && !io.KeyCtrl && isOnAim(state, stage, window, at_);
        const int lamp = lampAt(stage, state.view.camera, window, at_, kReachPixels);
        if (lamp >= 0 && !aiming_) {
            state.selected = lamp;
        }
        onLamp_ = lamp >= 0 || aiming_;
    }
    dragged_ = dragged_ || ImGui::IsMouseDragging(ImGuiMouseButton_Left, kClickPixels);
    const bool drags = (left && dragged_) || ImGui::IsMouseDown(ImGuiMouseButton_Middle) ||
                       ImGui::IsMouseDown(ImGuiMouseButton_Right);
    if (drags && moved != glm::dvec2(0.0)) {
        if (left && aiming_) {
            dragAim(state, stage, window);
        } else {
            dragCamera(state, window, moved);
        }
    }
    if (ImGui::IsMouseReleased(ImGuiMouseButton_Left)) {
        if (!dragged_ && !onLamp_) {
            state.selected = -1;
        }
        aiming_ = false;
    }
}

namespace {

void toggle(bool& value) {
    value = !value;
}

// Keys that make sense without a scene.
void handleKey(const KeyPress& press, ViewerState& state) {
    switch (press.key) {
        case GLFW_KEY_ESCAPE:
            state.requests.quit = true;
            break;
        case GLFW_KEY_H:
            toggle(state.showHelp);
            break;
        case GLFW_KEY_P:
            toggle(state.showPanels);
            break;
        case GLFW_KEY_Z:
            toggle(state.showStatistics);
            break;
        case GLFW_KEY_I:
            state.highestLux = state.highestLux
                                   ? std::nullopt
                                   : std::optional<double>(IlluminanceView{}.highestLux);
            break;
        case GLFW_KEY_M:
            state.requests.measureError = press.shift ? ErrorEstimate::Against::kGeometry
                                                      : ErrorEstimate::Against::kShadowMaps;
            break;
        case GLFW_KEY_B:
            state.requests.chooseBeams =
                press.shift ? state.goal : BeamGoal{std::nullopt, state.goal.errorPercent};
            break;
        case GLFW_KEY_L:
            toggle(state.showLamps);
            break;
        default:
            break;
    }
}

// Whether it is one that may be pressed while a text is being edited.
bool handleCommand(const KeyPress& press, ViewerRequests& requests) {
    if (press.key == GLFW_KEY_F12) {
        requests.savePicture = true;
    } else if (press.key == GLFW_KEY_F5) {
        requests.reload = true;
    } else if (press.control && press.key == GLFW_KEY_S) {
        requests.saveLook = true;
    } else if (press.control && press.key == GLFW_KEY_O) {
        requests.loadLook = true;
    } else {
        return false;
    }
    return true;
}

// Known by its node, since an animated one stands elsewhere than in the file.
Camera nextCamera(const std::vector<Camera>& cameras, const Camera& now) {
    const auto found = std::find_if(cameras.begin(), cameras.end(), [&](const Camera& camera) {
        return camera.node >= 0 && camera.node == now.node;
    });
    const bool isLast = found == cameras.end() || found + 1 == cameras.end();
    return isLast ? cameras.front() : *(found + 1);
}

// Around the lamp and what it aims at; without a lamp, around everything.
Bounds boundsToFrame(const StageView& stage, const LampId* lamp) {
    const std::optional<glm::dvec3> place =
        lamp == nullptr ? std::nullopt : placeOf(stage.scene(), *lamp);
    if (!place) {
        return stage.bounds();
    }
    Bounds bounds;
    bounds.add(*place);
    bounds.add(aimOf(stage.scene(), *lamp, stage.bounds()).value_or(*place));
    return bounds;
}

bool isZoom(int key) {
    return key == GLFW_KEY_EQUAL || key == GLFW_KEY_KP_ADD || key == GLFW_KEY_MINUS ||
           key == GLFW_KEY_KP_SUBTRACT;
}

// The beam's edge stays as soft as it is.
void zoom(LampChange& change, const SpotLight& spot, double factor) {
    // The scene follows the look once a frame, in which several keys may come.
    const double now = change.outerConeAngle.value_or(spot.outerConeAngle);
    const double outer = std::clamp(now * factor, kMinConeAngle, kMaxConeAngle);
    change.innerConeAngle = outer * sharpnessOf(spot);
    change.outerConeAngle = outer;
}

void handleSceneKey(const KeyPress& press, ViewerState& state, const StageView& stage,
                    double aspectRatio) {
    const std::vector<Camera>& cameras = stage.scene().cameras;
    const LampId* lamp = chosen(state, stage);
    if (press.key == GLFW_KEY_ENTER) {
        state.view = viewpointOf(stage.homeCamera(aspectRatio), stage.bounds());
    } else if (press.key == GLFW_KEY_C && !cameras.empty()) {
        state.view =
            viewpointOf(stage.posed(nextCamera(cameras, state.view.camera)), stage.bounds());
    } else if (press.key == GLFW_KEY_SPACE) {
        toggle(state.isPlaying);
    } else if (press.key == GLFW_KEY_F) {
        frame(state.view, boundsToFrame(stage, lamp), aspectRatio);
    } else if (press.key == GLFW_KEY_O && lamp != nullptr) {
        LampChange& change = state.changeOf(*lamp);
        toggle(press.shift ? change.solo : change.off);
    } else if (isZoom(press.key) && lamp != nullptr && lamp->kind == LampId::Kind::kSpot) {
        const bool wider = press.key == GLFW_KEY_EQUAL || press.key == GLFW_KEY_KP_ADD;
        zoom(state.changeOf(*lamp), stage.scene().spotLights[std::size_t(lamp->index)],
             wider ? kZoomStep : 1.0 / kZoomStep);
    }
}

}  // namespace

void handleKeys(const std::vector<KeyPress>& keys, ViewerState& state, const StageView* stage,
                glm::ivec2 window) {
    for (const KeyPress& press : keys) {
        if (handleCommand(press, state.requests) || press.control || ImGui::GetIO().WantTextInput) {
            continue;
        }
        handleKey(press, state);
        if (stage != nullptr) {
            handleSceneKey(press, state, *stage,
                           double(std::max(1, window.x)) / double(std::max(1, window.y)));
        }
    }
}

}  // namespace ribalta
