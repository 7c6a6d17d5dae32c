// The options that say what the planet's air, ground and sun are.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "scene/atmosphere.h"

namespace CLI {
class App;
}

namespace ribalta {

/// The texts of --rayleigh-only and of an option for each number of an atmosphere but the sun's
/// width. Must outlive the parsing of the command it is added to.
struct AtmosphereOptions {
    static constexpr std::size_t kCount = 10;

    std::array<std::optional<std::string>, kCount> texts;  ///< in the order of the help
    bool rayleighOnly = false;

    void addTo(CLI::App& command);

    /// The first that is given, "" where none is; `ofHaze`: of Mie's alone.
    std::string given(bool ofHaze = false) const;
    /// Earth's but for what is given. Throws CLI::ValidationError that names the option, what was
    /// found and what was expected.
    Atmosphere parsed() const;
};

}  // namespace ribalta
