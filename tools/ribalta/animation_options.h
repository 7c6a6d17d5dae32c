// The options that say at which time, or times, an animated scene is drawn.
#pragma once

#include <optional>
#include <string>

#include "look/look.h"
#include "scene/scene.h"

namespace CLI {
class App;
}

namespace ribalta {

/// Frames of a film, both ends included.
struct FrameRange {
    int first = 0;
    int last = 0;
    double perSecond = 24.0;

    int count() const { return last - first + 1; }
    double seconds(int frame) const { return double(frame) / perSecond; }
};

/// The texts of --time, --animation, --frames, --fps and --fresh. Must outlive the parsing of the
/// command it is added to.
struct AnimationOptions {
    std::optional<double> time;
    std::optional<std::string> animation;
    std::string frames;
    double fps = 24.0;
    bool fresh = false;

    /// --time and --animation alone, for one picture.
    void addMomentTo(CLI::App& command);
    /// All, to a command that has --repeat, --redraw, --still and --stats already, which --frames
    /// excludes.
    void addTo(CLI::App& command);

    /// None without --frames. Throws CLI::ValidationError that says what was expected.
    std::optional<FrameRange> range() const;
    /// The animation that is played: an index into the scene's, or kAllAnimations; that of
    /// `otherwise` where none is given. Throws Error(kUsage) that says which there are.
    int chosen(const Scene& scene, const std::optional<LookTime>& otherwise = {}) const;
    /// Poses the scene as --time asks, or as the first frame does; leaves it at rest without
    /// either, or at `otherwise`. Says on stderr where there is nothing to play.
    void pose(Scene& scene, const std::optional<LookTime>& otherwise = {}) const;
};

}  // namespace ribalta
