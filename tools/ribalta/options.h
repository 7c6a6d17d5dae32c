// What subcommands' options have in common: options that several take, and their texts into values.
// The latter throw CLI::ValidationError that says what was expected.
#pragma once

#include <optional>
#include <string>

#include "render/frame_settings.h"
#include "scene/camera.h"
#include "scene/scene.h"

namespace CLI {
class App;
}

namespace ribalta {

/// Options that several subcommands take. What they fill must outlive the parsing.
void addSceneOption(CLI::App& command, std::string& scene);
void addCameraOption(CLI::App& command, std::optional<std::string>& camera);
void addSizeOption(CLI::App& command, std::optional<std::string>& size);
void addAmbientOption(CLI::App& command, std::optional<double>& lux);
void addToneCurveOption(CLI::App& command, std::optional<ToneCurve>& curve);

struct PictureSize {
    int width = 1280;
    int height = 720;
};

/// "1280x720"; each side 1..16384 pixels.
PictureSize parseSize(const std::string& text);
/// The same, and `otherwise` where there is no text.
PictureSize parseSize(const std::optional<std::string>& text, const PictureSize& otherwise = {});

/// "20x20": cells across and down, each 1..1024.
PictureSize parseCells(const std::string& text);

/// "0.03" or "0.03,0.01": scattering and absorption in 1/m into `haze`.
void parseHaze(const std::string& text, Haze& haze);

/// "gibbons", "isotropic", "hg:0.6", "cornette-shanks:0.8", "rayleigh" into `phase`; K is kept.
void parsePhase(const std::string& text, PhaseFunction& phase);

/// "auto" or a number.
std::optional<double> parseExposure(const std::string& text);

/// Checks for CLI11: an empty text where `text` is a finite number above zero (not below zero),
/// otherwise what was expected.
std::string expectPositive(const std::string& text);
std::string expectNotNegative(const std::string& text);
/// The same for a number in 0..1, and for an even light in lux.
std::string expectShare(const std::string& text);
std::string expectLux(const std::string& text);

/// The camera of that name or index (from 0); without a text the first one, or one that frames the
/// scene where the file has none. Throws Error(kUsage) that says which there are.
Camera chooseCamera(const Scene& scene, const std::optional<std::string>& nameOrIndex,
                    double aspectRatio);

}  // namespace ribalta
