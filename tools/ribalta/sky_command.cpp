#include "sky_command.h"

#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/check.h"
#include "base/error.h"
#include "base/parallel_for.h"
#include "base/progress.h"
#include "base/read_file.h"
#include "base/temporary_file.h"
#include "gl/context.h"
#include "parse_number.h"
#include "reference/integrate_sky.h"
#include "render/evaluate_sky.h"
#include "scene/atmosphere.h"
#include "sky_points.h"

namespace ribalta {
namespace {

enum class SkyModel { kReference, kAuto };

const std::map<std::string, SkyModel>& modelsByName() {
    static const std::map<std::string, SkyModel> models = {{"reference", SkyModel::kReference},
                                                           {"auto", SkyModel::kAuto}};
    return models;
}

struct SkyPointsOptions {
    std::string points;
    std::string output;
    std::string model = "reference";
    int orders = 4;
    bool rayleighOnly = false;
};

std::vector<SkyLight> integrate(const Atmosphere& air, int orders,
                                const std::vector<SkyRay>& rays) {
    SkySettings settings;
    settings.orders = orders;
    std::optional<Progress> progress(std::in_place, "tables");
    const SkyIntegrator sky(air, settings, rays);
    progress.emplace("rays", rays.size());
    std::vector<SkyLight> lights(rays.size());
    parallelFor(rays.size(), [&](std::size_t i) {
        lights[i] = sky.along(rays[i]);
        progress->step();
    });
    return lights;
}

std::vector<SkyLight> evaluate(const SkyPointsOptions& options, const std::vector<SkyRay>& rays) {
    const Atmosphere air = options.rayleighOnly ? withoutMie(Atmosphere()) : Atmosphere();
    switch (modelsByName().at(options.model)) {
        case SkyModel::kReference:
            return integrate(air, options.orders, rays);
        case SkyModel::kAuto: {
            const Context context;
            return evaluateSky(air, {options.orders, false}, rays);
        }
    }
    checkFailed("a model that is known", __FILE__, __LINE__);
}

void writeSkyTable(const SkyPointsOptions& options) {
    const bool toFile = options.output != "-";
    if (toFile) {
        const TemporaryFile probe(options.output);
    }
    const std::vector<std::byte> bytes = readFile(options.points);
    const SkyPoints points =
        parseSkyPoints({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, options.points);
    const std::string table = skyTable(points, evaluate(options, points.rays));
    if (toFile) {
        writeFileAtomically(options.output, table);
    } else {
        std::fwrite(table.data(), 1, table.size(), stdout);
    }
}

std::string expectModel(const std::string& text) {
    if (modelsByName().contains(text)) {
        return "";
    }
    std::string names;
    for (const auto& [name, model] : modelsByName()) {
        names += (names.empty() ? "" : ", ") + name;
    }
    return "there is no model '" + text + "'; there are: " + names;
}

std::string expectOrders(const std::string& text) {
    const std::optional<int> value = parseNumber<int>(text);
    return value && *value >= 1 && *value <= kMostSkyOrders
               ? ""
               : "'" + text + "' is not a whole number in 1.." + std::to_string(kMostSkyOrders);
}

}  // namespace

void addSkyCommand(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "sky", "Says what light of the sky listed rays bring, for a sun of irradiance 1.");
    const auto options = std::make_shared<SkyPointsOptions>();
    command
        ->add_option("--points", options->points,
                     "rays, one a line under a line of names: alt_km (height of the eye over the "
                     "ground), the cosines mu (ray and zenith), mu_s (sun and zenith), nu (ray and "
                     "sun), and d_km where a ray ends")
        ->type_name("FILE.csv")
        ->required();
    command
        ->add_option(
            "-o,--output", options->output,
            "table to write, - is stdout: the columns of the rays and, each of r, g, b, "
            "T_ (transmittance), L_ (light that the air scatters in, 1/sr), Lg_ (with what "
            "the ground, of albedo 0.1, reflects straight into the ray)")
        ->type_name("FILE.csv|-")
        ->required();
    command
        ->add_option("--model", options->model,
                     "what computes it: reference, the integral in double precision; auto, the "
                     "renderer's own shaders")
        ->type_name("NAME")
        ->check(expectModel, "")
        ->capture_default_str();
    command
        ->add_option("--orders", options->orders,
                     "how often light may be scattered or reflected, 1..20")
        ->type_name("COUNT")
        ->check(expectOrders, "")
        ->capture_default_str();
    command->add_flag("--rayleigh-only", options->rayleighOnly, "air without haze (Mie)");
    command->callback([options] { writeSkyTable(*options); });
}

}  // namespace ribalta
