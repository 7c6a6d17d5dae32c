#include "render/frame_targets.h"

namespace ribalta {

FrameTargets::FrameTargets(const FrameSettings& settings) {
    const Texture2D::Size size{settings.width, settings.height, 0, 1};
    color = Texture2D("colour", GL_RGBA32F, size);
    depth = Texture2D("depth", GL_DEPTH_COMPONENT32F, size);
    depth.setSampling(GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE);
    if (settings.normalOutput) {
        normals = Texture2D("normals", GL_RGBA16F, size);
    }
    if (settings.beamsOutput) {
        beams = Texture2D("beams", GL_RGBA32F, size);
    }
    const Texture2D* normalTarget = normals ? &normals : nullptr;
    const Texture2D* beamTarget = beams ? &beams : nullptr;
    surfaces = Framebuffer("surfaces", {&color, normalTarget}, &depth);
    haze = Framebuffer("haze", {&color, beamTarget}, nullptr);
    hazeWithDepth = Framebuffer("haze with depth", {&color, beamTarget}, &depth);
    if (settings.display) {
        display = Texture2D("display", GL_RGBA8, size);
        screen = Framebuffer("screen", {&display}, nullptr);
    }
}

bool FrameTargets::suit(const FrameSettings& settings) const {
    return color.size().width == settings.width && color.size().height == settings.height &&
           bool(normals) == settings.normalOutput && bool(beams) == settings.beamsOutput &&
           bool(display) == settings.display;
}

}  // namespace ribalta
