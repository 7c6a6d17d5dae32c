#include "render_frames.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/log.h"
#include "base/progress.h"
#include "frame_files.h"
#include "interrupts.h"
#include "video_encoder.h"

namespace ribalta {
namespace {

using Clock = std::chrono::steady_clock;

// The pictures of one frame.
RenderOutputs picturesOf(const RenderOutputs& outputs, int frame) {
    RenderOutputs pictures{{}, outputs.layers, {}};
    for (const std::filesystem::path& file : outputs.files) {
        if (!isVideo(file)) {
            pictures.files.push_back(numbered(file, frame));
        }
    }
    return pictures;
}

std::vector<std::filesystem::path> filmsOf(const RenderOutputs& outputs) {
    std::vector<std::filesystem::path> films;
    for (const std::filesystem::path& file : outputs.files) {
        if (isVideo(file)) {
            films.push_back(file);
        }
    }
    return films;
}

class FrameRun {
  public:
    explicit FrameRun(FramesJob job);

    /// Returns the signal that interrupted it, or 0.
    int run();

  private:
    bool drawFrame(int frame);
    void place(int frame);
    void write(const RenderOutputs& missing);
    void tell(int done, int signal) const;

    FramesJob job_;
    bool sunFollows_ = false;
    std::vector<std::unique_ptr<VideoEncoder>> films_;
    int kept_ = 0;
};

FrameRun::FrameRun(FramesJob job) : job_(std::move(job)) {
    const std::optional<SkyDrawing>& sky = job_.settings.sky;
    sunFollows_ =
        sky && sky->sunLamp >= 0 &&
        sky->towardsSun == -job_.scene.directionalLights[std::size_t(sky->sunLamp)].direction;
    for (const std::filesystem::path& film : filmsOf(job_.outputs)) {
        films_.push_back(std::make_unique<VideoEncoder>(
            film, job_.settings.width, job_.settings.height, job_.range.perSecond));
    }
}

void FrameRun::place(int frame) {
    poseScene(job_.scene, job_.range.seconds(frame), job_.animation);
    job_.afterPose(job_.scene);
    job_.camera = posedCamera(job_.scene, job_.camera);
    if (sunFollows_) {
        SkyDrawing& sky = *job_.settings.sky;
        sky.towardsSun = -job_.scene.directionalLights[std::size_t(sky.sunLamp)].direction;
    }
}

void FrameRun::write(const RenderOutputs& missing) {
    for (const std::unique_ptr<VideoEncoder>& film : films_) {
        film->write(readDisplay(job_.renderer.targets()));
    }
    writeOutputs(missing, job_.renderer.lastPlan(), job_.renderer.targets());
}

// False where all of the frame was there.
bool FrameRun::drawFrame(int frame) {
    RenderOutputs missing = picturesOf(job_.outputs, frame);
    const std::size_t wanted = missing.files.size();
    if (!job_.fresh) {
        std::erase_if(missing.files, [&](const std::filesystem::path& file) {
            return newestOf({file}) >= job_.newestInput &&
                   isWholePicture(file, job_.settings.width, job_.settings.height,
                                  job_.outputs.layers);
        });
    }
    kept_ += wanted > 0 && missing.files.empty() ? 1 : 0;
    if (missing.files.empty() && films_.empty()) {
        return false;
    }
    place(frame);
    job_.renderer.draw(job_.camera, job_.settings);
    write(missing);
    return true;
}

int FrameRun::run() {
    const InterruptWatch watch;
    std::optional<Progress> progress(std::in_place, "drawing frames",
                                     std::size_t(job_.range.count()));
    double drawnSeconds = 0.0;
    int drawn = 0;
    int frame = job_.range.first;
    for (; frame <= job_.range.last && InterruptWatch::noted() == 0; ++frame) {
        const Clock::time_point start = Clock::now();
        if (drawFrame(frame)) {
            drawnSeconds += std::chrono::duration<double>(Clock::now() - start).count();
            ++drawn;
            progress->expectLeft(drawnSeconds / drawn * (job_.range.last - frame));
        }
        progress->step();
    }
    progress.reset();
    const int signal = InterruptWatch::noted();
    if (signal == 0) {
        for (const std::unique_ptr<VideoEncoder>& film : films_) {
            film->finish();
        }
    }
    tell(frame - job_.range.first, signal);
    return signal;
}

void FrameRun::tell(int done, int signal) const {
    if (kept_ > 0) {
        logNote("frames: " + std::to_string(kept_) + " of " + std::to_string(job_.range.count()) +
                " were there already and are kept; --fresh draws them anew");
    }
    if (job_.renderer.ev100() && !job_.settings.ev100) {
        char line[128];
        std::snprintf(line, sizeof line,
                      "frames: each has its own exposure, the last EV100 %.2f; --exposure %.2f "
                      "holds it",
                      *job_.renderer.ev100(), *job_.renderer.ev100());
        logNote(line);
    }
    if (signal != 0) {
        logWarning(
            "interrupted: " + std::to_string(done) + " of " + std::to_string(job_.range.count()) +
            (films_.empty() ? std::string(" frames are done and kept; the same command ") +
                                  (job_.fresh ? "without --fresh " : "") + "goes on from there"
                            : " frames were drawn; the film is not written, pictures are"));
    }
}

}  // namespace

void checkFrameOutputs(const RenderOutputs& outputs, const FrameRange& range,
                       const FrameSettings& settings) {
    const std::vector<std::filesystem::path> films = filmsOf(outputs);
    const RenderOutputs pictures = picturesOf(outputs, range.first);
    if (films.empty() && pictures.files.empty()) {
        throw CLI::ValidationError(
            "--frames", "needs something to write: give -o FILE_####.png or -o FILE.mp4");
    }
    checkOutputs(pictures);
    if (!films.empty() && (settings.width % 2 != 0 || settings.height % 2 != 0)) {
        throw CLI::ValidationError("--size", "a film needs an even width and height, not " +
                                                 std::to_string(settings.width) + "x" +
                                                 std::to_string(settings.height));
    }
    for (const std::filesystem::path& film : films) {
        findFfmpeg(film);
        const TemporaryFile probe(film);
    }
}

void renderFrames(FramesJob job) {
    int signal = 0;
    {
        FrameRun run(std::move(job));
        signal = run.run();
    }
    if (signal != 0) {
        std::fflush(nullptr);
        std::raise(signal);
    }
}

}  // namespace ribalta
