// Lamps: the list of all, by groups of names, and the editor of one.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>

#include <imgui/imgui.h>
#include <imgui/imgui_stdlib.h>

#include "base/angles.h"
#include "optics/color_temperature.h"
#include "scene/bearing.h"
#include "viewer/lamp_marks.h"
#include "viewer/panels.h"

namespace ribalta {
namespace {

constexpr float kListHeight = 220.0F;

// What names of lamps that belong together start with: "Spot.001" and "Spot 2" are both "Spot".
std::string groupOf(const std::string& name) {
    std::size_t end = name.size();
    while (end > 0 &&
           (std::isdigit(static_cast<unsigned char>(name[end - 1])) != 0 || name[end - 1] == '.' ||
            name[end - 1] == '_' || name[end - 1] == ' ' || name[end - 1] == '-')) {
        --end;
    }
    return end == 0 ? name : name.substr(0, end);
}

bool isOff(const Look& look, const LampId& lamp) {
    const LampChange* change = findChange(look.lamps, lamp);
    return change != nullptr && change->off;
}

bool isSolo(const Look& look, const LampId& lamp) {
    const LampChange* change = findChange(look.lamps, lamp);
    return change != nullptr && change->solo;
}

std::string labelOf(const LampId& lamp) {
    const std::string name = lamp.name.empty() ? "(no name)" : lamp.name;
    return lamp.number == 0 ? name : name + " (" + std::to_string(lamp.number + 1) + ")";
}

void drawRow(ViewerState& state, const StageView& stage, std::size_t index) {
    const LampId& lamp = stage.lamps()[index];
    ImGui::PushID(int(index));
    bool on = !isOff(state.look, lamp);
    if (ImGui::Checkbox("##on", &on)) {
        state.changeOf(lamp).off = !on;
    }
    ImGui::SameLine();
    bool solo = isSolo(state.look, lamp);
    if (ImGui::RadioButton("##solo", solo)) {
        state.changeOf(lamp).solo = !solo;
    }
    ImGui::SameLine();
    if (ImGui::Selectable(labelOf(lamp).c_str(), state.selected == int(index))) {
        state.selected = int(index);
    }
    ImGui::PopID();
}

// A switch and a solo button for all lamps of a group.
void drawGroupSwitches(ViewerState& state, const StageView& stage,
                       const std::vector<std::size_t>& members) {
    const auto all = [&](bool (*is)(const Look&, const LampId&)) {
        return std::all_of(members.begin(), members.end(),
                           [&](std::size_t index) { return is(state.look, stage.lamps()[index]); });
    };
    bool on = !all(isOff);
    const bool solo = all(isSolo);
    const bool switched = ImGui::Checkbox("##on", &on);
    ImGui::SameLine();
    const bool soloed = ImGui::RadioButton("##solo", solo);
    for (const std::size_t index : members) {
        const LampId& lamp = stage.lamps()[index];
        if (switched) {
            state.changeOf(lamp).off = !on;
        }
        if (soloed) {
            state.changeOf(lamp).solo = !solo;
        }
    }
}

double coneSolidAngle(double halfAngle) {
    return 2.0 * std::numbers::pi * (1.0 - std::cos(halfAngle));
}

void editIntensity(ViewerState& state, const StageView& stage, const LampId& lamp) {
    // What the look has, and not the scene: a lamp that is off has none there.
    const LampChange* change = findChange(state.look.lamps, lamp);
    double intensity =
        change != nullptr && change->intensity ? *change->intensity : stage.intensityInFile(lamp);
    const bool isDirectional = lamp.kind == LampId::Kind::kDirectional;
    const double low = 0.0;
    const double high = 1e9;
    constexpr ImGuiSliderFlags kFlags = ImGuiSliderFlags_AlwaysClamp;
    bool changed = false;
    const float speed = float(std::max(1.0, 0.01 * intensity));
    changed |= ImGui::DragScalar(isDirectional ? "lx" : "cd", ImGuiDataType_Double, &intensity,
                                 speed, &low, &high, "%.6g", kFlags);
    if (!isDirectional) {
        const double angle =
            lamp.kind == LampId::Kind::kSpot
                ? coneSolidAngle(stage.scene().spotLights[std::size_t(lamp.index)].outerConeAngle)
                : 4.0 * std::numbers::pi;
        double lumen = intensity * angle;
        if (ImGui::DragScalar("lm, as if even", ImGuiDataType_Double, &lumen, speed * float(angle),
                              &low, &high, "%.6g", kFlags)) {
            intensity = std::min(lumen / angle, high);
            changed = true;
        }
    }
    if (changed) {
        state.changeOf(lamp).intensity = intensity;
    }
}

void editColor(ViewerState& state, const StageView& stage, const LampId& lamp) {
    glm::vec3 color = visitLamp(stage.scene(), lamp, [](const auto& each) { return each.color; });
    if (ImGui::ColorEdit3("colour, linear", &color.x, ImGuiColorEditFlags_Float)) {
        state.changeOf(lamp).color = glm::max(color, glm::vec3(0.0F));
    }
    static float kelvin = 5600.0F;
    if (ImGui::SliderFloat("K", &kelvin, float(kLowestKelvin), 12000.0F, "%.0f",
                           ImGuiSliderFlags_AlwaysClamp)) {
        state.changeOf(lamp).color = glm::vec3(colorOfTemperature(kelvin));
    }
}

void editCone(ViewerState& state, const LampId& lamp, const SpotLight& spot) {
    auto outer = float(spot.outerConeAngle * kDegreesPerRadian * 2.0);
    if (ImGui::SliderFloat("zoom", &outer, 1.0F, 160.0F, "%.1f degrees",
                           ImGuiSliderFlags_AlwaysClamp)) {
        LampChange& change = state.changeOf(lamp);
        // The edge stays as soft as it is.
        change.outerConeAngle = 0.5 * double(outer) / kDegreesPerRadian;
        change.innerConeAngle = *change.outerConeAngle * sharpnessOf(spot);
    }
    auto soft = float(1.0 - sharpnessOf(spot));
    if (ImGui::SliderFloat("soft edge", &soft, 0.0F, 1.0F, "%.2f", ImGuiSliderFlags_AlwaysClamp)) {
        state.changeOf(lamp).innerConeAngle = spot.outerConeAngle * (1.0 - double(soft));
    }
}

// Pan about the world's up from -Z to the right, tilt above the horizon.
void editAim(ViewerState& state, const LampId& lamp, const Frame& frame) {
    const Bearing ahead = bearingOf(frame.forward());
    auto pan = float(ahead.azimuth * kDegreesPerRadian);
    auto tilt = float(ahead.elevation * kDegreesPerRadian);
    bool changed = ImGui::SliderFloat("pan", &pan, -180.0F, 180.0F, "%.1f degrees",
                                      ImGuiSliderFlags_AlwaysClamp);
    changed |= ImGui::SliderFloat("tilt", &tilt, -89.9F, 89.9F, "%.1f degrees",
                                  ImGuiSliderFlags_AlwaysClamp);
    if (changed) {
        const Bearing bearing{double(pan) / kDegreesPerRadian, double(tilt) / kDegreesPerRadian};
        state.changeOf(lamp).frame = turned(frame, directionOf(bearing));
    }
}

void editLightMap(ViewerState& state, const StageView& stage, const LampId& lamp,
                  const SpotLight& spot) {
    const std::string name =
        spot.lightMap ? stage.scene().images[std::size_t(spot.lightMap->image)].name : "none";
    ImGui::Text("light map: %s", name.c_str());
    ImGui::TextDisabled("drop a picture on the window to change it");
    std::string& file = state.lightMapText;
    if (ImGui::InputText("file##light map", &file, ImGuiInputTextFlags_EnterReturnsTrue) &&
        !file.empty()) {
        std::error_code failed;
        state.changeOf(lamp).lightMap.file =
            std::filesystem::absolute(file, failed).lexically_normal();
        file.clear();
    }
    if (spot.lightMap) {
        if (ImGui::Button("no light map")) {
            state.changeOf(lamp).lightMap.file.emplace();
        }
        auto degrees = float(spot.lightMap->rotationRadians * kDegreesPerRadian);
        if (ImGui::SliderFloat("rotation", &degrees, -180.0F, 180.0F, "%.1f degrees",
                               ImGuiSliderFlags_AlwaysClamp)) {
            state.changeOf(lamp).lightMap.rotationRadians = double(degrees) / kDegreesPerRadian;
        }
    }
}

}  // namespace

void drawLampList(ViewerState& state, const StageView& stage) {
    ImGui::InputTextWithHint("##filter", "part of a name", &state.lampFilter);
    ImGui::TextDisabled("on, solo, name");
    std::map<std::string, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < stage.lamps().size(); ++i) {
        const std::string& name = stage.lamps()[i].name;
        if (name.find(state.lampFilter) != std::string::npos) {
            groups[groupOf(name)].push_back(i);
        }
    }
    ImGui::BeginChild("lamps", ImVec2(0.0F, kListHeight), true);
    for (const auto& [group, members] : groups) {
        if (members.size() == 1) {
            drawRow(state, stage, members.front());
            continue;
        }
        ImGui::PushID(group.c_str());
        drawGroupSwitches(state, stage, members);
        ImGui::SameLine();
        const bool open = ImGui::TreeNodeEx("##group", ImGuiTreeNodeFlags_DefaultOpen, "%s (%zu)",
                                            group.c_str(), members.size());
        if (open) {
            for (const std::size_t index : members) {
                drawRow(state, stage, index);
            }
            ImGui::TreePop();
        }
        ImGui::PopID();
    }
    ImGui::EndChild();
}

void drawLampPanel(ViewerState& state, const StageView& stage) {
    if (state.selected < 0 || state.selected >= int(stage.lamps().size())) {
        ImGui::TextDisabled("click a lamp in the picture or the list");
        return;
    }
    const LampId& lamp = stage.lamps()[std::size_t(state.selected)];
    const Scene& scene = stage.scene();
    const auto index = std::size_t(lamp.index);
    ImGui::Text("%s", labelOf(lamp).c_str());
    editIntensity(state, stage, lamp);
    editColor(state, stage, lamp);
    if (lamp.kind == LampId::Kind::kSpot) {
        const SpotLight& spot = scene.spotLights[index];
        editCone(state, lamp, spot);
        editAim(state, lamp, spot.frame);
        editLightMap(state, stage, lamp, spot);
    } else if (lamp.kind == LampId::Kind::kDirectional) {
        const glm::dvec3 direction = scene.directionalLights[index].direction;
        editAim(state, lamp, lookAt(glm::dvec3(0.0), direction));
    }
    if (ImGui::Button("as in the file")) {
        std::erase_if(state.look.lamps, [&](const LampChange& change) { return lamp.is(change); });
    }
}

}  // namespace ribalta
