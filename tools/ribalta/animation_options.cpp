#include "animation_options.h"

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "base/log.h"
#include "look/apply_look.h"
#include "options.h"
#include "parse_number.h"

namespace ribalta {
namespace {

constexpr int kLastFrame = 999'999;

std::string expectFps(const std::string& text) {
    const double fps = parseNumber<double>(text).value_or(0.0);
    return fps >= 0.001 && fps <= 1000.0
               ? ""
               : "'" + text + "' is not a number of frames a second, 0.001..1000";
}

std::optional<FrameRange> parseRange(const std::string& text) {
    const std::size_t colon = text.find(':');
    const auto first = parseNumber<int>(text.substr(0, colon));
    const auto last =
        colon == std::string::npos ? std::nullopt : parseNumber<int>(text.substr(colon + 1));
    if (!first || !last || *first < 0 || *last < *first || *last > kLastFrame) {
        return std::nullopt;
    }
    return FrameRange{*first, *last, 0.0};
}

std::string expectRange(const std::string& text) {
    return parseRange(text) ? ""
                            : "'" + text + "' is not FIRST:LAST, two frames counted from 0 to " +
                                  std::to_string(kLastFrame) + ", the second not below the first";
}

}  // namespace

void AnimationOptions::addMomentTo(CLI::App& command) {
    command
        .add_option("--time", time,
                    "draw the scene as its animations have it at this second (default: as it "
                    "rests)")
        ->type_name("SECONDS")
        ->check(expectNotNegative, "");
    command
        .add_option("--animation", animation,
                    "the animation that is played, by name or counted from 0 (default: all of "
                    "them together)")
        ->type_name("NAME|INDEX|all");
}

void AnimationOptions::addTo(CLI::App& command) {
    addMomentTo(command);
    CLI::Option* const film =
        command
            .add_option("--frames", frames,
                        "draw the frames FIRST to LAST of the animation, frame i at second i / "
                        "fps: to numbered pictures (-o out_####.png; # are the number's digits) or "
                        "to a film through ffmpeg (-o out.mp4, .webm, .mkv); pictures that are "
                        "there and whole are kept")
            ->type_name("FIRST:LAST")
            ->check(expectRange, "");
    for (const char* other : {"--time", "--repeat", "--redraw", "--still", "--stats"}) {
        film->excludes(command.get_option(other));
    }
    command.add_option("--fps", fps, "with --frames: frames a second")
        ->type_name("N")
        ->check(expectFps, "")
        ->capture_default_str()
        ->needs(film);
    command.add_flag("--fresh", fresh, "with --frames: draw pictures anew that are there")
        ->needs(film);
}

std::optional<FrameRange> AnimationOptions::range() const {
    if (animation && !time && frames.empty()) {
        throw CLI::ValidationError("--animation", "needs a time: give --time or --frames");
    }
    if (frames.empty()) {
        return std::nullopt;
    }
    FrameRange range = parseRange(frames).value();
    range.perSecond = fps;
    return range;
}

int AnimationOptions::chosen(const Scene& scene, const std::optional<LookTime>& otherwise) const {
    if (!animation) {
        return animationOf(otherwise, scene);
    }
    if (*animation == "all") {
        return kAllAnimations;
    }
    for (std::size_t i = 0; i < scene.animations.size(); ++i) {
        if (scene.animations[i].name == *animation) {
            return int(i);
        }
    }
    const auto index = parseNumber<std::size_t>(*animation);
    if (index && *index < scene.animations.size()) {
        return int(*index);
    }
    constexpr std::size_t kShown = 20;
    std::string there;
    for (std::size_t i = 0; i < scene.animations.size() && i < kShown; ++i) {
        there += (i == 0 ? "" : ", ") + std::to_string(i) + " " + scene.animations[i].name;
    }
    if (scene.animations.size() > kShown) {
        there += " and " + std::to_string(scene.animations.size() - kShown) + " more";
    }
    throw Error(ErrorKind::kUsage, {"--animation", ""},
                "no animation '" + *animation + "'; " +
                    (there.empty() ? "the file has none" : "there are: " + there));
}

void AnimationOptions::pose(Scene& scene, const std::optional<LookTime>& otherwise) const {
    const std::optional<FrameRange> film = range();
    if (!time && !film) {
        if (!poseAt(otherwise, scene)) {
            logWarning("look: the scene has no animation '" + oneLine(otherwise->animation) +
                       "'; all of them are played");
        }
        return;
    }
    const int played = chosen(scene, otherwise);
    if (!isAnimated(scene)) {
        logWarning("nothing in the file is animated; the scene is drawn as it rests");
    }
    poseScene(scene, film ? film->seconds(film->first) : *time, played);
}

}  // namespace ribalta
