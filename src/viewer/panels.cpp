#include "viewer/panels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <imgui/imgui.h>
#include <imgui/imgui_stdlib.h>

#include "base/angles.h"
#include "look/look_settings.h"
#include "optics/shader_lib.h"
#include "scene/animation.h"

namespace ribalta {
namespace {

constexpr float kPanelWidth = 330.0F;
constexpr float kMargin = 10.0F;

struct KeyHelp {
    const char* key;
    const char* what;
};
constexpr std::array<KeyHelp, 23> kKeys = {
    {{"left drag", "turn around the middle"},
     {"Shift + left, middle drag", "move sideways"},
     {"right drag, wheel", "nearer, farther"},
     {"Ctrl + left drag", "look around"},
     {"W A S D, Q E", "walk, down and up; Shift: faster"},
     {"click", "choose a lamp"},
     {"drag the cross", "aim the chosen lamp"},
     {"F", "frame the chosen lamp, or everything"},
     {"Enter", "the scene's own camera"},
     {"C", "next camera"},
     {"O, Shift + O", "chosen lamp on or off; solo"},
     {"+, -", "chosen lamp wider, narrower"},
     {"Space", "play, pause"},
     {"I", "illuminance in false colours"},
     {"M, Shift + M", "the beams' error, by shadow maps, by geometry"},
     {"B, Shift + B", "beams within the error, within the time"},
     {"L", "marks of lamps"},
     {"P", "panels"},
     {"Z", "statistics"},
     {"F12", "save the picture"},
     {"Ctrl + S, Ctrl + O", "save, load the look"},
     {"H", "this help"},
     {"Esc", "close"}}};

void choose(ViewerState& state, const StageView& stage, const Camera& camera) {
    state.view = viewpointOf(stage.posed(camera), stage.bounds());
}

void drawCameras(ViewerState& state, const StageView& stage) {
    const Camera& now = state.view.camera;
    int id = 0;
    for (const Camera& camera : stage.scene().cameras) {
        ImGui::PushID(id++);
        const std::string label = camera.name.empty() ? "(no name)" : camera.name;
        if (ImGui::Selectable(label.c_str(), camera == now)) {
            choose(state, stage, camera);
        }
        ImGui::PopID();
    }
    int removed = -1;
    for (std::size_t i = 0; i < state.look.bookmarks.size(); ++i) {
        ImGui::PushID(id++);
        if (ImGui::SmallButton("x")) {
            removed = int(i);
        }
        ImGui::SameLine();
        const Camera& bookmark = state.look.bookmarks[i];
        if (ImGui::Selectable(bookmark.name.c_str(), bookmark == now)) {
            choose(state, stage, bookmark);
        }
        ImGui::PopID();
    }
    if (removed >= 0) {
        state.look.bookmarks.erase(state.look.bookmarks.begin() + removed);
    }
    if (ImGui::Button("keep this view")) {
        Camera bookmark = now;
        bookmark.node = -1;  // it stays, whatever its camera does
        bookmark.name = "view " + std::to_string(state.look.bookmarks.size() + 1);
        state.look.bookmarks.push_back(std::move(bookmark));
    }
    if (auto* lens = std::get_if<PerspectiveLens>(&state.view.camera.lens)) {
        auto degrees = float(lens->verticalFov * kDegreesPerRadian);
        if (ImGui::SliderFloat("angle", &degrees, 1.0F, 150.0F, "%.1f degrees",
                               ImGuiSliderFlags_AlwaysClamp)) {
            lens->verticalFov = double(degrees) / kDegreesPerRadian;
        }
    }
}

void drawLookPanel(ViewerState& state) {
    std::string file = state.lookFile.string();
    if (ImGui::InputText("file##look", &file)) {
        state.lookFile = file;
    }
    if (ImGui::Button("save (Ctrl+S)")) {
        state.requests.saveLook = true;
    }
    ImGui::SameLine();
    if (ImGui::Button("load (Ctrl+O)")) {
        state.requests.loadLook = true;
    }
    ImGui::SameLine();
    if (ImGui::Button("picture (F12)")) {
        state.requests.savePicture = true;
    }
}

void drawStatistics(const PictureFacts& facts, const StageView& stage) {
    const FramePlan& plan = stage.renderer().lastPlan();
    ImGui::SetNextWindowPos(ImVec2(kMargin, kMargin));
    ImGui::SetNextWindowBgAlpha(0.5F);
    constexpr ImGuiWindowFlags kFlags =
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
        ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing;
    ImGui::Begin("statistics", nullptr, kFlags);
    if (facts.framesPerSecond > 0.0) {
        ImGui::Text("%.0f fps", facts.framesPerSecond);
    } else {
        ImGui::Text(facts.isStill ? "still" : "refining");
    }
    ImGui::Text("%d x %d, %d sheets", facts.size.x, facts.size.y, facts.sheets);
    ImGui::Text("lamps %d of %d",
                int(plan.lamps.size() + plan.pointLights.size() + plan.directionalLights.size()),
                int(stage.lamps().size()));
    for (const PassTime& pass : facts.passes) {
        ImGui::Text("%-12s %7.2f ms", pass.name.c_str(), pass.gpuMs);
    }
    if (facts.ev100) {
        ImGui::Text("EV100 %.2f", *facts.ev100);
    }
    if (!facts.probe.empty()) {
        ImGui::Text("%s", facts.probe.c_str());
    }
    if (!facts.error.empty()) {
        ImGui::Text("error %s", facts.error.c_str());
    }
    ImGui::TextDisabled("%s", facts.renderer.c_str());
    ImGui::End();
}

// A list of a table's words; whether another was chosen.
template <typename Value>
bool chooseNamed(const char* label, std::span<const Named<Value>> table, Value& value) {
    bool changed = false;
    if (ImGui::BeginCombo(label, std::string(nameIn(table, value)).c_str())) {
        for (const Named<Value>& each : table) {
            if (ImGui::Selectable(std::string(each.name).c_str(), each.value == value)) {
                changed = each.value != value;
                value = each.value;
            }
        }
        ImGui::EndCombo();
    }
    return changed;
}

void drawHaze(Haze& haze) {
    const double low = 0.0;
    const double high = 2.0;
    constexpr ImGuiSliderFlags kFlags = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic;
    ImGui::SliderScalar("scattering 1/m", ImGuiDataType_Double, &haze.scatteringPerMetre, &low,
                        &high, "%.4f", kFlags);
    ImGui::SliderScalar("absorption 1/m", ImGuiDataType_Double, &haze.absorptionPerMetre, &low,
                        &high, "%.4f", kFlags);
    if (chooseNamed("phase", phaseFunctions(), haze.phase.kind)) {
        haze.phase.g = 0.0;
    }
    if (haze.phase.hasG()) {
        const double back = -0.95;
        const double ahead = 0.95;
        ImGui::SliderScalar("g", ImGuiDataType_Double, &haze.phase.g, &back, &ahead, "%.2f",
                            ImGuiSliderFlags_AlwaysClamp);
    }
}

// What belongs to the thesis's planes alone.
void drawPlanesQuality(BeamSettings& beams) {
    int cells[2] = {beams.cellsAcross, beams.cellsDown};
    if (ImGui::SliderInt2("cells", cells, 0, 256, "%d", ImGuiSliderFlags_AlwaysClamp)) {
        // Both or none: at every pixel, or at the corners of cells across and down.
        const bool any = cells[0] > 0 && cells[1] > 0;
        beams.cellsAcross = any ? cells[0] : 0;
        beams.cellsDown = any ? cells[1] : 0;
    }
}

// A method and a number of sheets for a time or an error, found by trying them in this view.
void drawGoals(ViewerState& state) {
    const double low = 0.01;
    const double high = 10000.0;
    constexpr ImGuiSliderFlags kFlags = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic;
    ImGui::PushItemWidth(90.0F);
    ImGui::DragScalar("ms##budget", ImGuiDataType_Double, &*state.goal.budgetMs, 0.1F, &low, &high,
                      "%.2f", kFlags);
    ImGui::SameLine();
    if (ImGui::Button("best within the time")) {
        state.requests.chooseBeams = state.goal;
    }
    ImGui::DragScalar("%##error", ImGuiDataType_Double, &state.goal.errorPercent, 0.01F, &low,
                      &high, "%.2f", kFlags);
    ImGui::SameLine();
    if (ImGui::Button("fastest within the error")) {
        state.requests.chooseBeams = BeamGoal{std::nullopt, state.goal.errorPercent};
    }
    ImGui::PopItemWidth();
}

void drawError(ViewerState& state, const PictureFacts& facts) {
    ImGui::TextDisabled("the beams' error, of full scale");
    if (ImGui::Button("by shadow maps")) {
        state.requests.measureError = ErrorEstimate::Against::kShadowMaps;
    }
    ImGui::SameLine();
    if (ImGui::Button("by geometry")) {
        state.requests.measureError = ErrorEstimate::Against::kGeometry;
    }
    if (!facts.error.empty()) {
        ImGui::TextUnformatted(facts.error.c_str());
    }
}

void drawQuality(BeamSettings& beams) {
    if (chooseNamed("beams", beamMethods(), beams.method)) {
        beams.tolerance.reset();
    }
    ImGui::SliderInt("sheets", &beams.planes, 1, 256, "%d",
                     ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
    if (beams.method == BeamMethod::kPlanes) {
        drawPlanesQuality(beams);
    }
}

void drawExposure(ViewerState& state, const PictureFacts& facts) {
    bool automatic = !state.look.ev100;
    if (ImGui::Checkbox("automatic exposure", &automatic)) {
        state.look.ev100 =
            automatic ? std::nullopt : std::optional<double>(facts.ev100.value_or(8.0));
    }
    if (state.look.ev100) {
        const double low = -10.0;
        const double high = 24.0;
        ImGui::SliderScalar("EV100", ImGuiDataType_Double, &*state.look.ev100, &low, &high, "%.2f",
                            ImGuiSliderFlags_AlwaysClamp);
    }
    chooseNamed("tone curve", toneCurves(), state.look.toneCurve);
    bool lux = state.highestLux.has_value();
    if (ImGui::Checkbox("illuminance in false colours", &lux)) {
        state.highestLux = lux ? std::optional<double>(IlluminanceView{}.highestLux) : std::nullopt;
    }
    if (state.highestLux) {
        const double least = 1.0;
        const double most = 2e5;
        ImGui::SliderScalar("up to lx", ImGuiDataType_Double, &*state.highestLux, &least, &most,
                            "%.0f", ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
    }
    const double low = 0.0;
    const double high = 1000.0;
    ImGui::SliderScalar("ambient lx", ImGuiDataType_Double, &state.look.ambientLux, &low, &high,
                        "%.3g", ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
}

void drawSky(ViewerState& state) {
    bool hasSky = state.look.sky.has_value();
    if (ImGui::Checkbox("sky", &hasSky)) {
        state.look.sky = hasSky ? std::optional<SkyLook>(SkyLook{}) : std::nullopt;
    }
    if (!state.look.sky) {
        return;
    }
    chooseNamed("model", skyKinds(), state.look.sky->model);
    SunInSky sun = state.look.sky->sun.value_or(sunOfNoLamp());
    auto elevation = float(sun.elevation * kDegreesPerRadian);
    auto azimuth = float(sun.azimuth * kDegreesPerRadian);
    bool changed = ImGui::SliderFloat("sun's height", &elevation, -20.0F, 90.0F, "%.1f degrees",
                                      ImGuiSliderFlags_AlwaysClamp);
    changed |= ImGui::SliderFloat("azimuth", &azimuth, 0.0F, 360.0F, "%.1f degrees",
                                  ImGuiSliderFlags_AlwaysClamp);
    if (changed) {
        state.look.sky->sun =
            SunInSky{double(elevation) / kDegreesPerRadian, double(azimuth) / kDegreesPerRadian};
    }
    const double low = 0.0;
    const double high = 1e5;
    ImGui::SliderScalar("altitude m", ImGuiDataType_Double, &state.look.sky->altitudeMetres, &low,
                        &high, "%.0f", ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
}

}  // namespace

void drawLightPanels(ViewerState& state, const PictureFacts& facts) {
    if (ImGui::CollapsingHeader("Haze", ImGuiTreeNodeFlags_DefaultOpen)) {
        drawHaze(state.look.haze);
    }
    if (ImGui::CollapsingHeader("Quality")) {
        drawQuality(state.look.beams);
        drawGoals(state);
        drawError(state, facts);
    }
    if (ImGui::CollapsingHeader("Exposure and sky")) {
        drawExposure(state, facts);
        drawSky(state);
    }
}

void drawAnimationPanel(ViewerState& state, const StageView& stage) {
    const Scene& scene = stage.scene();
    const std::string chosen = state.look.time ? state.look.time->animation : "";
    if (ImGui::BeginCombo("played", chosen.empty() ? "all together" : chosen.c_str())) {
        LookTime time = state.look.time.value_or(LookTime{});
        if (ImGui::Selectable("all together", chosen.empty())) {
            time.animation.clear();
            state.look.time = time;
        }
        for (const Animation& animation : scene.animations) {
            if (!animation.name.empty() &&
                ImGui::Selectable(animation.name.c_str(), animation.name == chosen)) {
                time.animation = animation.name;
                state.look.time = time;
            }
        }
        ImGui::EndCombo();
    }
    if (ImGui::Button(state.isPlaying ? "pause" : "play")) {
        state.isPlaying = !state.isPlaying;
    }
    ImGui::SameLine();
    ImGui::Checkbox("loop", &state.loops);
    ImGui::SameLine();
    if (ImGui::Button("rest")) {
        state.look.time.reset();
        state.isPlaying = false;
    }
    const double low = 0.0;
    const double high = stage.durationSeconds(state.look);
    double seconds = state.look.time ? state.look.time->seconds : 0.0;
    if (ImGui::SliderScalar("seconds", ImGuiDataType_Double, &seconds, &low, &high, "%.2f",
                            ImGuiSliderFlags_AlwaysClamp)) {
        state.look.time = LookTime{seconds, chosen};
    }
    const double slowest = 0.05;
    const double fastest = 8.0;
    ImGui::SliderScalar("speed", ImGuiDataType_Double, &state.speed, &slowest, &fastest, "%.2f",
                        ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
}

void drawPanels(ViewerState& state, const StageView& stage, const PictureFacts& facts) {
    if (state.showStatistics) {
        drawStatistics(facts, stage);
    }
    if (!state.showPanels) {
        return;
    }
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(screen.x - kPanelWidth - kMargin, kMargin));
    ImGui::SetNextWindowSize(ImVec2(kPanelWidth, std::max(100.0F, screen.y - 2.0F * kMargin)));
    ImGui::SetNextWindowBgAlpha(0.85F);
    ImGui::Begin("ribalta", nullptr,
                 ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoTitleBar);
    ImGui::PushItemWidth(0.58F * kPanelWidth);
    if (ImGui::CollapsingHeader("Look", ImGuiTreeNodeFlags_DefaultOpen)) {
        drawLookPanel(state);
    }
    if (ImGui::CollapsingHeader("Cameras", ImGuiTreeNodeFlags_DefaultOpen)) {
        drawCameras(state, stage);
    }
    if (ImGui::CollapsingHeader("Lamps", ImGuiTreeNodeFlags_DefaultOpen)) {
        drawLampList(state, stage);
        drawLampPanel(state, stage);
    }
    if (isAnimated(stage.scene()) &&
        ImGui::CollapsingHeader("Animation", ImGuiTreeNodeFlags_DefaultOpen)) {
        drawAnimationPanel(state, stage);
    }
    drawLightPanels(state, facts);
    ImGui::PopItemWidth();
    ImGui::End();
}

void drawLegend(const ViewerState& state) {
    if (!state.highestLux) {
        return;
    }
    constexpr int kSteps = 60;
    constexpr float kHeight = 180.0F;
    constexpr float kWidth = 16.0F;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImVec2 foot(kMargin, 0.62F * screen.y + 0.5F * kHeight);
    list.AddRectFilled({foot.x - 4.0F, foot.y - kHeight - 12.0F},
                       {foot.x + kWidth + 80.0F, foot.y + 10.0F}, IM_COL32(0, 0, 0, 160), 4.0F);
    for (int step = 0; step < kSteps; ++step) {
        const glm::dvec3 color = shader::falseColor((step + 0.5) / kSteps);
        const float top = foot.y - kHeight * float(step + 1) / kSteps;
        list.AddRectFilled(
            {foot.x, top}, {foot.x + kWidth, top + kHeight / kSteps + 1.0F},
            ImGui::ColorConvertFloat4ToU32({float(color.x), float(color.y), float(color.z), 1.0F}));
    }
    // A label for each decade and between, on the scale of the colours' own function.
    for (int label = 0; label <= 6; ++label) {
        const double share = label / 6.0;
        const double lux =
            *state.highestLux * std::pow(10.0, shader::kFalseColorDecades * (share - 1.0));
        char text[32];
        std::snprintf(text, sizeof text, lux >= 10.0 ? "%.0f lx" : "%.2g lx", lux);
        list.AddText({foot.x + kWidth + 6.0F, foot.y - kHeight * float(share) - 8.0F},
                     IM_COL32_WHITE, text);
    }
}

void drawHelp(ViewerState& state) {
    if (!state.showHelp) {
        return;
    }
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(0.5F * screen.x, 0.5F * screen.y), ImGuiCond_Always,
                            ImVec2(0.5F, 0.5F));
    ImGui::Begin("Keys", &state.showHelp,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse);
    if (ImGui::BeginTable("keys", 2)) {
        for (const KeyHelp& line : kKeys) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(line.key);
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(line.what);
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

void drawMessages(ViewerState& state, const std::string& busy) {
    const auto now = std::chrono::steady_clock::now();
    std::erase_if(state.messages,
                  [&](const ViewerMessage& message) { return message.until < now; });
    if (state.messages.empty() && busy.empty()) {
        return;
    }
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(kMargin, screen.y - kMargin), ImGuiCond_Always,
                            ImVec2(0.0F, 1.0F));
    ImGui::SetNextWindowBgAlpha(0.7F);
    constexpr ImGuiWindowFlags kFlags =
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
        ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing;
    ImGui::Begin("messages", nullptr, kFlags);
    ImGui::PushTextWrapPos(std::max(200.0F, screen.x - kPanelWidth - 4.0F * kMargin));
    if (!busy.empty()) {
        ImGui::TextUnformatted(busy.c_str());
    }
    for (const ViewerMessage& message : state.messages) {
        const ImVec4 color =
            message.isError ? ImVec4(1.0F, 0.5F, 0.4F, 1.0F) : ImVec4(1.0F, 1.0F, 1.0F, 1.0F);
        ImGui::PushStyleColor(ImGuiCol_Text, color);
        ImGui::TextUnformatted(message.text.c_str());
        ImGui::PopStyleColor();
    }
    ImGui::PopTextWrapPos();
    ImGui::End();
}

}  // namespace ribalta
