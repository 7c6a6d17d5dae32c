#include "atmosphere_options.h"

#include <vector>

#include <CLI/CLI.hpp>

#include "parse_number.h"

namespace ribalta {
namespace {

struct Parameter {
    const char* option;
    const char* name;  ///< as faultOf() has it
    const char* help;
    const char* type;
    double Atmosphere::*number;  ///< or null
    glm::dvec3 Atmosphere::*colour;
    bool ofHaze;
};

constexpr const char* kColour = "X|R,G,B";

constexpr std::array<Parameter, AtmosphereOptions::kCount> kParameters = {{
    {"--rayleigh-scattering", "rayleighScattering",
     "the air's at the ground, in 1/m (default: 5.8e-6,13.5e-6,33.1e-6)", kColour, nullptr,
     &Atmosphere::rayleighScatteringPerMetre, false},
    {"--rayleigh-height", "rayleighScaleHeight",
     "metres over which it thins out to 1/e (default: 8000)", "METRES",
     &Atmosphere::rayleighScaleHeightMetres, nullptr, false},
    {"--mie-scattering", "mieScattering", "the air's haze at the ground, in 1/m (default: 4e-6)",
     kColour, nullptr, &Atmosphere::mieScatteringPerMetre, true},
    {"--mie-extinction", "mieExtinction",
     "what that scatters and absorbs, in 1/m (default: 1.11 times what it scatters)", kColour,
     nullptr, &Atmosphere::mieExtinctionPerMetre, true},
    {"--mie-height", "mieScaleHeight", "metres over which it thins out to 1/e (default: 1200)",
     "METRES", &Atmosphere::mieScaleHeightMetres, nullptr, true},
    {"--mie-g", "mieG",
     "how far it scatters straight on: the asymmetry of Cornette and Shanks' phase function, "
     "-1 < g < 1 (default: 0.8)",
     "G", &Atmosphere::mieG, nullptr, true},
    {"--planet-radius", "groundRadius", "metres (default: 6.36e6)", "METRES",
     &Atmosphere::groundRadiusMetres, nullptr, false},
    {"--air-top", "top", "where the air ends, metres above the planet's ground (default: 60000)",
     "METRES", &Atmosphere::topMetres, nullptr, false},
    {"--ground-albedo", "groundAlbedo", "what the planet's ground reflects, 0..1 (default: 0.1)",
     kColour, nullptr, &Atmosphere::groundAlbedo, false},
    {"--sun-illuminance", "sunIlluminance", "lux of the sun above the air (default: 128000)",
     kColour, nullptr, &Atmosphere::sunIlluminanceLux, false},
}};

[[noreturn]] void refuse(const std::string& option, const std::string& message) {
    throw CLI::ValidationError(option, message);
}

/// Numbers between commas; none where one of them is no number.
std::optional<std::vector<double>> parseNumbers(const std::string& text) {
    std::vector<double> numbers;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find(',', start), text.size());
        const auto number = parseNumber<double>(text.substr(start, end - start));
        if (!number) {
            return std::nullopt;
        }
        numbers.push_back(*number);
        start = end + 1;
    }
    return numbers;
}

void put(const Parameter& parameter, const std::string& text, Atmosphere& air) {
    const std::optional<std::vector<double>> numbers = parseNumbers(text);
    if (parameter.number != nullptr) {
        if (!numbers || numbers->size() != 1) {
            refuse(parameter.option, "'" + text + "' is not a number");
        }
        air.*parameter.number = numbers->front();
        return;
    }
    if (!numbers || (numbers->size() != 1 && numbers->size() != 3)) {
        refuse(parameter.option, "'" + text + "' is not a number, or three of them: R,G,B");
    }
    for (int c = 0; c < 3; ++c) {
        (air.*parameter.colour)[c] = numbers->size() == 1 ? numbers->front() : (*numbers)[c];
    }
}

}  // namespace

void AtmosphereOptions::addTo(CLI::App& command) {
    for (std::size_t i = 0; i < kCount; ++i) {
        command
            .add_option(kParameters[i].option, texts[i],
                        std::string("with a sky: ") + kParameters[i].help)
            ->type_name(kParameters[i].type);
    }
    command.add_flag("--rayleigh-only", rayleighOnly, "with a sky: air without haze (Mie)");
}

std::string AtmosphereOptions::given(bool ofHaze) const {
    for (std::size_t i = 0; i < kCount; ++i) {
        if (texts[i] && (kParameters[i].ofHaze || !ofHaze)) {
            return kParameters[i].option;
        }
    }
    return rayleighOnly && !ofHaze ? "--rayleigh-only" : "";
}

Atmosphere AtmosphereOptions::parsed() const {
    if (rayleighOnly && !given(true).empty()) {
        refuse(given(true), "is of the haze that --rayleigh-only leaves out; give one of them");
    }
    Atmosphere air;
    for (std::size_t i = 0; i < kCount; ++i) {
        if (!texts[i]) {
            continue;
        }
        const glm::dvec3 before = air.mieScatteringPerMetre;
        put(kParameters[i], *texts[i], air);
        // Haze absorbs as large a part as it did, unless what follows says otherwise.
        if (air.mieScatteringPerMetre != before) {
            air.mieExtinctionPerMetre *= air.mieScatteringPerMetre / before;
        }
    }
    if (const std::optional<AtmosphereFault> fault = faultOf(air)) {
        const std::size_t slash = fault->name.find('/');
        const std::string channel =
            slash == std::string::npos ? "" : fault->name.substr(slash + 1) + " ";
        for (const Parameter& parameter : kParameters) {
            if (fault->name.substr(0, slash) == parameter.name) {
                refuse(parameter.option, channel + fault->message);
            }
        }
    }
    return rayleighOnly ? withoutMie(air) : checked(air);
}

}  // namespace ribalta
