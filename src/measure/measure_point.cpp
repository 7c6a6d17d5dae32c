#include "measure/measure_point.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "gl/counters.h"
#include "render/read_frame.h"

namespace ribalta {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// Forgets the process's peak memory so far; false where the system does not let us.
bool resetPeakRss() {
    std::ofstream stream("/proc/self/clear_refs");
    stream << "5" << std::flush;
    return bool(stream);
}

std::optional<std::uint64_t> readPeakRss() {
    std::ifstream stream("/proc/self/status");
    std::string word;
    while (stream >> word) {
        std::uint64_t kibibytes = 0;
        if (word == "VmHWM:" && stream >> kibibytes) {
            return kibibytes * 1024;
        }
    }
    return std::nullopt;
}

struct TimedFrame {
    double ms = 0.0;
    std::vector<PassTime> passes;
};

TimedFrame drawFrame(Renderer& renderer, const Camera& camera, const FrameSettings& settings) {
    renderer.redrawNextFrame();
    const Clock::time_point start = Clock::now();
    renderer.draw(camera, settings);
    TimedFrame frame;
    frame.passes = renderer.takeTimes();
    frame.ms = 1000.0 * secondsSince(start);
    return frame;
}

// The passes of all frames, in the order of the first that has them.
std::vector<PassSpread> spreadPasses(const std::vector<TimedFrame>& frames) {
    std::vector<PassSpread> result;
    for (const TimedFrame& frame : frames) {
        for (const PassTime& pass : frame.passes) {
            const auto same = [&](const PassSpread& known) { return known.name == pass.name; };
            if (std::none_of(result.begin(), result.end(), same)) {
                result.push_back({pass.name, {}, {}});
            }
        }
    }
    for (PassSpread& spread : result) {
        std::vector<double> cpu;
        std::vector<double> gpu;
        for (const TimedFrame& frame : frames) {
            for (const PassTime& pass : frame.passes) {
                if (pass.name == spread.name) {
                    cpu.push_back(pass.cpuMs);
                    gpu.push_back(pass.gpuMs);
                }
            }
        }
        spread.cpuMs = spreadOf(cpu);
        spread.gpuMs = spreadOf(gpu);
    }
    return result;
}

std::string secondsText(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g s", seconds);
    return text;
}

// How many more frames of `seconds` each fit before the limit.
int framesLeft(double seconds, double spent, double limit) {
    return int(std::clamp((limit - spent) / std::max(seconds, 1e-6), 0.0, 1e6));
}

}  // namespace

void measureTimes(Renderer& renderer, const Camera& camera, const MeasureSettings& settings,
                  std::optional<double> expectedSeconds, SweepRecord& record) {
    record.maxPointSeconds = settings.maxPointSeconds;
    if (expectedSeconds && *expectedSeconds > settings.maxPointSeconds) {
        record.status = SweepRecord::Status::kSkipped;
        record.message = "a frame would take about " + secondsText(*expectedSeconds) +
                         ", over --max-point-seconds " + secondsText(settings.maxPointSeconds);
        return;
    }
    const bool peakIsOwn = resetPeakRss();
    glCounters().peakBytes = glCounters().bytesAllocated;
    const FrameSettings& frameSettings = record.point.settings;
    const Clock::time_point start = Clock::now();
    double frameSeconds = expectedSeconds.value_or(0.0);
    const auto stopIfAsked = [&] {
        if (settings.interrupted()) {
            throw Interrupted();
        }
    };

    const auto fits = [&](int frames) {
        return framesLeft(frameSeconds, secondsSince(start), settings.maxPointSeconds) >= frames;
    };

    int warmups = 0;
    std::vector<TimedFrame> frames;
    const auto draw = [&] {
        stopIfAsked();
        frames.push_back(drawFrame(renderer, camera, frameSettings));
        frameSeconds = frames.back().ms * 1e-3;
    };
    while (warmups < settings.warmups && fits(2)) {
        frames.clear();
        draw();
        ++warmups;
    }
    // Where no frame fits after it, the last warm-up is the one that counts.
    if (warmups > 0 && !fits(1)) {
        --warmups;
    } else {
        frames.clear();
    }
    while (int(frames.size()) < settings.repeats && (frames.empty() || fits(1))) {
        draw();
    }

    std::vector<double> whole;
    whole.reserve(frames.size());
    for (const TimedFrame& frame : frames) {
        whole.push_back(frame.ms);
    }
    record.status = SweepRecord::Status::kMeasured;
    record.frameMs = spreadOf(whole);
    record.passes = spreadPasses(frames);
    record.samples = renderer.beamSamples();
    record.peakGl = glCounters().peakBytes;
    record.peakRss = peakIsOwn ? readPeakRss() : std::nullopt;
    record.warmups = warmups;
    record.repeats = int(frames.size());
    if (warmups < settings.warmups || record.repeats < settings.repeats) {
        record.message = std::to_string(warmups) + " of " + std::to_string(settings.warmups) +
                         " warm-up frames and " + std::to_string(record.repeats) + " of " +
                         std::to_string(settings.repeats) + " repeats within " +
                         secondsText(settings.maxPointSeconds);
    }
}

DrawnLight drawLight(Renderer& renderer, const Camera& camera, FrameSettings settings) {
    settings.beamsOutput = true;
    settings.display = false;
    const FramePlan& plan = renderer.draw(camera, settings);
    FrameLayers layers;
    layers.beams = true;
    const FloatImage image = readFrame(plan, renderer.targets(), layers);
    renderer.takeTimes();
    const Place place{"the drawn frame", ""};
    return {pickLayer(image, "", place), pickLayer(image, "beams", place)};
}

}  // namespace ribalta
