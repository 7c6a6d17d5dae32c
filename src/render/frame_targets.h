// FrameTargets: the pictures a frame is drawn into.
#pragma once

#include "gl/framebuffer.h"
#include "gl/texture.h"
#include "render/frame_settings.h"

namespace ribalta {

struct FrameTargets {
    /// Makes those that the settings ask for, width x height pixels, rows from below.
    explicit FrameTargets(const FrameSettings& settings);

    /// Whether they suit the settings as they are.
    bool suit(const FrameSettings& settings) const;

    Texture2D color;    ///< RGBA32F, cd/m2: stage light of 500,000 cd outgrows half floats
    Texture2D depth;    ///< reversed, 0 where nothing is hit
    Texture2D normals;  ///< RGBA16F, view space; only if asked for
    Texture2D beams;    ///< RGBA32F, cd/m2; only if asked for
    Texture2D display;  ///< RGBA8, sRGB-encoded; only if asked for

    Framebuffer surfaces;       ///< color, normals, depth
    Framebuffer haze;           ///< color, beams; no depth, so that it can be read
    Framebuffer hazeWithDepth;  ///< the same with depth, for planes that surfaces cut
    Framebuffer screen;         ///< display
};

}  // namespace ribalta
