#include "sky_command.h"

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <CLI/CLI.hpp>

#include "atmosphere_options.h"
#include "base/log.h"
#include "base/parallel_for.h"
#include "base/progress.h"
#include "base/read_file.h"
#include "base/temporary_file.h"
#include "gl/context.h"
#include "reference/integrate_sky.h"
#include "render/evaluate_baseline_sky.h"
#include "render/evaluate_sky.h"
#include "render/passes/sky_precomputed.h"
#include "scene/atmosphere.h"
#include "sky_model_options.h"
#include "sky_points.h"

namespace ribalta {
namespace {

struct SkyPointsOptions {
    std::string points;
    std::string output;
    SkyModelOptions model;
    AtmosphereOptions atmosphere;
    bool verbose = false;
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

void logCost(const SkyCost& cost) {
    char line[160];
    std::snprintf(line, sizeof line,
                  "tables: %.0f KB kept, %.0f KB at most; %.3f s, %.3f s of processors, %.3f s by "
                  "the driver's clock; %d dispatches",
                  double(cost.keptBytes) / 1024.0, double(cost.peakBytes) / 1024.0,
                  cost.wallSeconds, cost.cpuSeconds, cost.gpuSeconds, cost.dispatches);
    logVerbose(line);
}

std::vector<SkyLight> evaluate(const SkyModel& model, const Atmosphere& air,
                               const std::vector<SkyRay>& rays) {
    if (const auto* reference = std::get_if<ReferenceSky>(&model)) {
        return integrate(air, reference->orders, rays);
    }
    const Context context;
    if (const auto* own = std::get_if<AutoSky>(&model)) {
        return evaluateSky(air, {own->orders, false}, rays);
    }
    if (const auto* chapman = std::get_if<ChapmanSky>(&model)) {
        return evaluateChapmanSky(air, *chapman, rays);
    }
    const PrecomputedSky sky(air, std::get<PrecomputedSkySettings>(model));
    logCost(sky.cost());
    return evaluatePrecomputedSky(sky, rays);
}

void writeSkyTable(const SkyPointsOptions& options) {
    setVerbose(options.verbose);
    const SkyModel model = options.model.parsed();
    const Atmosphere air = options.atmosphere.parsed();
    if (std::holds_alternative<ChapmanSky>(model) && !options.atmosphere.given(true).empty()) {
        throw CLI::ValidationError(options.atmosphere.given(true),
                                   "is of haze, which --model chapman has none of; leave it out");
    }
    const bool toFile = options.output != "-";
    if (toFile) {
        const TemporaryFile probe(options.output);
    }
    const std::vector<std::byte> bytes = readFile(options.points);
    const SkyPoints points =
        parseSkyPoints({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, options.points);
    const std::string table = skyTable(points, evaluate(model, air, points.rays));
    if (toFile) {
        writeFileAtomically(options.output, table);
    } else {
        std::fwrite(table.data(), 1, table.size(), stdout);
    }
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
            "the ground reflects straight into the ray)")
        ->type_name("FILE.csv|-")
        ->required();
    options->model.addTo(*command);
    options->atmosphere.addTo(*command);
    command->add_flag("--verbose", options->verbose, "say what tables took");
    command->callback([options] { writeSkyTable(*options); });
}

}  // namespace ribalta
