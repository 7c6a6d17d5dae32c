// FrameSettings: how a frame is drawn. What belongs to a scene stands in the scene.
#pragma once

#include <algorithm>
#include <optional>

#include "render/beam_method.h"
#include "render/sky_settings.h"
#include "render/tone_curve.h"
#include "scene/haze.h"

namespace ribalta {

/// Sheets a beam from which on `clipped` and `adaptive` make and use the shadow maps' pyramid. User
/// time of a 1280x720 frame on two cores with llvmpipe, against that without: `adaptive` from the
/// stage's front, from its side and inside a single beam, 24 sheets: 15, 15 and 6 % less; 10
/// sheets: the same, 10 % less, 5 % more. `clipped`, 64 sheets, front, single beam, arena: 28, 16,
/// 24 % less.
constexpr int kSheetsForPyramid = 24;

/// How the light in the haze is summed.
struct BeamSettings {
    BeamMethod method = BeamMethod::kAdaptive;
    int planes = 24;  ///< sheets a beam, or planes a frame (planes)
    /// `adaptive` only: how far a pixel may be off by interpolation, as a share of the screen's
    /// full scale; see usedTolerance().
    std::optional<double> tolerance;
    /// `planes` only: cells across and down on whose corners the smooth factor is evaluated and
    /// between which it is interpolated (Pessoa 2007, equation 8); 0: at every pixel.
    int cellsAcross = 0;
    int cellsDown = 0;
    /// `planes` only: distance between planes in metres; otherwise they are spread evenly from the
    /// near plane to the end of the scene. With it they lie around the middle of that range.
    std::optional<double> spacingMetres;
    /// `planes` only: add their light up in eight bits, exposed but not tone mapped, as graphics
    /// cards of 2007 had to. Needs FrameSettings::ev100.
    bool eightBitBlending = false;

    /// `clipped` and `adaptive` only; the picture is the same without it.
    int sheetsForPyramid = kSheetsForPyramid;

    bool operator==(const BeamSettings&) const = default;

    /// Where none is set: 0.8 / planes, about as much as so few sheets are off themselves at their
    /// worst pixels, but at most 0.1, from where on interpolation would be seen.
    double usedTolerance() const { return tolerance.value_or(std::min(0.8 / planes, 0.1)); }
};

/// The light that falls on surfaces, in place of the light that they send to the eye.
struct IlluminanceView {
    double highestLux = 10000.0;  ///< of the screen's false colours

    bool operator==(const IlluminanceView&) const = default;
};

struct FrameSettings {
    int width = 1280;  ///< pixels
    int height = 720;
    Haze haze;
    BeamSettings beams;
    std::optional<SkyDrawing> sky;  ///< none: black behind everything
    double ambientLux = 1.0;        ///< even light from all around
    std::optional<double> ev100;    ///< exposure; none: found from the picture
    ToneCurve toneCurve = ToneCurve::kNeutral;
    /// Colours are lux by channel then, without haze, beams and sky before or behind them.
    std::optional<IlluminanceView> illuminance;
    bool display = true;        ///< make the exposed, tone-mapped 8-bit picture
    bool beamsOutput = false;   ///< keep the beams apart as well
    bool normalOutput = false;  ///< keep the surfaces' normals
    bool countRuns = false;     ///< count what the shadow maps' pyramid saves, slowly

    bool operator==(const FrameSettings&) const = default;
};

}  // namespace ribalta
