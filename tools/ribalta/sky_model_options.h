// Which model computes the sky, and the options that belong to one model alone.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "render/baseline_sky_settings.h"

namespace CLI {
class App;
}

namespace ribalta {

/// The integral in double precision.
struct ReferenceSky {
    int orders = 4;
};
/// The renderer's own.
struct AutoSky {
    int orders = 4;
};
using SkyModel = std::variant<ReferenceSky, AutoSky, PrecomputedSkySettings, ChapmanSky>;

/// The texts of --model, --orders and of what belongs to one model alone. Must outlive the parsing
/// of the command it is added to.
struct SkyModelOptions {
    std::string model = "reference";
    std::optional<int> orders;
    std::string tableSize;
    std::string transmittanceSize;
    std::string irradianceSize;
    std::string precision;
    std::string texels;
    std::string chapmanForm;
    std::optional<int> segments;

    void addTo(CLI::App& command);
    /// All but --model and --orders.
    void addDetailsTo(CLI::App& command);

    /// What they mean. Throws CLI::ValidationError that says what was expected, in the words of a
    /// command that calls --model and --orders so.
    SkyModel parsed(const std::string& modelOption = "--model",
                    const std::string& ordersOption = "--orders") const;
};

}  // namespace ribalta
