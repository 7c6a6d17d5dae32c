#include "render_stats.h"

#include <algorithm>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "base/temporary_file.h"
#include "measure/statistics.h"

namespace ribalta {
namespace {

nlohmann::json toJson(const FrameTimes& frame) {
    nlohmann::json passes = nlohmann::json::array();
    for (const PassTime& pass : frame.passes) {
        passes.push_back({{"name", pass.name}, {"cpu_ms", pass.cpuMs}, {"gpu_ms", pass.gpuMs}});
    }
    return passes;
}

std::string row(const std::string& name, double cpuMs, double gpuMs) {
    char line[128];
    std::snprintf(line, sizeof line, "  %-12s %9.2f %9.2f\n", name.c_str(), cpuMs, gpuMs);
    return line;
}

}  // namespace

FrameTimes medianTimes(const std::vector<FrameTimes>& frames) {
    FrameTimes result;
    std::vector<double> whole;
    std::vector<std::string> names;
    for (const FrameTimes& frame : frames) {
        whole.push_back(frame.frameMs);
        for (const PassTime& pass : frame.passes) {
            if (std::find(names.begin(), names.end(), pass.name) == names.end()) {
                names.push_back(pass.name);
            }
        }
    }
    result.frameMs = median(whole);
    for (const std::string& name : names) {
        std::vector<double> cpu;
        std::vector<double> gpu;
        for (const FrameTimes& frame : frames) {
            for (const PassTime& pass : frame.passes) {
                if (pass.name == name) {
                    cpu.push_back(pass.cpuMs);
                    gpu.push_back(pass.gpuMs);
                }
            }
        }
        result.passes.push_back({name, median(cpu), median(gpu)});
    }
    return result;
}

void countPlan(const FramePlan& plan, const Scene& scene, RenderStats& stats) {
    stats.lampsDrawn =
        int(plan.lamps.size() + plan.pointLights.size() + plan.directionalLights.size());
    stats.lampsSkipped = plan.lampsSkipped;
    stats.skipped = plan.skipped;
    stats.lampsWithLightMap =
        int(std::count_if(plan.lamps.begin(), plan.lamps.end(), [&](const PlannedLamp& lamp) {
            return scene.spotLights[std::size_t(lamp.spot)].lightMap.has_value();
        }));
    stats.beamsDrawn = plan.beams && !plan.kept ? int(plan.beams->lamps.size()) : 0;
    stats.tilesDrawn = plan.beamTilesDrawn();
    stats.tilesTotal = plan.beamTilesTotal();
    stats.surfacesDrawn = plan.forward && !plan.kept
                              ? int(plan.forward->opaque.size() + plan.forward->blended.size())
                              : 0;
    stats.surfacesCulled = int(plan.draws.size()) - stats.surfacesDrawn;
    stats.shadowMapsNeedless = plan.shadowMapsNeedless;
    stats.castersDrawn = plan.castersDrawn;
    stats.castersCulled = plan.castersCulled;
    if (plan.sunShadow) {
        for (const SunCascade& cascade : plan.sunShadow->cascades) {
            stats.sunCastersDrawn += int(cascade.casters.size());
        }
        stats.sunCastersCulled = plan.sunShadow->castersCulled;
    }
}

std::string describeTimes(const RenderStats& stats) {
    const FrameTimes times = medianTimes(stats.frames);
    std::string text = "  pass          cpu ms    gpu ms\n";
    for (const PassTime& pass : times.passes) {
        text += row(pass.name, pass.cpuMs, pass.gpuMs);
    }
    char line[160];
    std::snprintf(line, sizeof line, "  frame %.2f ms%s, first frame %.2f ms", times.frameMs,
                  stats.frames.size() > 1
                      ? (" (median of " + std::to_string(stats.frames.size()) + ")").c_str()
                      : "",
                  stats.frames.front().frameMs);
    return text + line;
}

void writeStats(const std::filesystem::path& file, const RenderStats& stats) {
    const FrameTimes times = medianTimes(stats.frames);
    nlohmann::json load = nlohmann::json::array();
    for (const LoadedScene::Stage& stage : stats.load) {
        load.push_back({{"stage", stage.name}, {"ms", stage.ms}});
    }
    nlohmann::json json = {
        {"plan", stats.plan},
        {"renderer", stats.renderer},
        {"frame_ms", times.frameMs},
        {"first_frame_ms", stats.frames.front().frameMs},
        {"first_pixel_ms", stats.firstPixelMs},
        {"repeats", stats.frames.size()},
        {"passes", toJson(times)},
        {"first_frame_passes", toJson(stats.frames.front())},
        {"counters",
         {{"lamps_drawn", stats.lampsDrawn},
          {"lamps_skipped", stats.lampsSkipped},
          {"lamps_dark", stats.skipped.dark},
          {"lamps_out_of_range", stats.skipped.outOfRange},
          {"lamps_behind_camera", stats.skipped.behindCamera},
          {"lamps_behind_scene", stats.skipped.behindScene},
          {"lamps_outside_view", stats.skipped.outsideView},
          {"lamps_with_light_map", stats.lampsWithLightMap},
          {"beams_drawn", stats.beamsDrawn},
          {"tiles_drawn", stats.tilesDrawn},
          {"tiles_total", stats.tilesTotal},
          {"surfaces_drawn", stats.surfacesDrawn},
          {"surfaces_culled", stats.surfacesCulled},
          {"frames_kept", stats.framesKept},
          {"shadow_maps_drawn", stats.shadowMapsDrawn},
          {"shadow_maps_kept", stats.shadowMapsKept},
          {"shadow_maps_needless", stats.shadowMapsNeedless},
          {"meshes_deformed", stats.meshesDeformed},
          {"meshes_kept", stats.meshesKept},
          {"vertices_deformed", stats.verticesDeformed},
          {"casters_drawn", stats.castersDrawn},
          {"casters_culled", stats.castersCulled},
          {"sun_shadow_maps_drawn", stats.sunMapsDrawn},
          {"sun_shadow_maps_kept", stats.sunMapsKept},
          {"sun_casters_drawn", stats.sunCastersDrawn},
          {"sun_casters_culled", stats.sunCastersCulled},
          {"draw_calls", stats.drawCalls},
          {"samples", stats.samples},
          {"runs_lit", stats.runs.lit},
          {"runs_dark", stats.runs.dark},
          {"runs_mixed", stats.runs.mixed},
          {"shadow_fetches", stats.runs.fetches},
          {"programs_built", stats.programsBuilt},
          {"textures_made", stats.texturesMade}}},
        {"load", load},
        {"uploaded_bytes", stats.uploadedBytes},
        {"peak_bytes", stats.peakBytes},
        {"ev100", stats.ev100 ? nlohmann::json(*stats.ev100) : nlohmann::json()}};
    writeFileAtomically(file, json.dump(2) + "\n");
}

}  // namespace ribalta
