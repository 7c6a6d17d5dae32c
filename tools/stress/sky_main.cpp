// The program ribalta_stress_sky: looks at the sky of ordinary and extreme planets from ordinary
// and extreme places for a given time. Prints for each failure the command that repeats it, and at
// the end the worst of each class.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <map>
#include <optional>

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "check_sky.h"
#include "gl/context.h"
#include "gl/debug_output.h"

namespace ribalta::stress {
namespace {

struct Options {
    double seconds = 20.0;
    std::uint64_t seed = 1;
    std::optional<int> cases;
    std::optional<int> firstCase;
    bool verbose = false;
};

struct Tally {
    int cases = 0;
    int failed = 0;
    double worstRays = 0.0;
    double worstPicture = 0.0;
    double worstSun = 0.0;
};

bool check(const SkySetUp& setUp, bool verbose, Tally& tally, long long& rays) {
    if (verbose) {
        std::printf("%s", describe(setUp).c_str());
        std::fflush(stdout);  // a case that never ends is known by its numbers
    }
    SkyFindings findings = checkSky(setUp);
    for (const std::string& error : takeGlErrors()) {
        findings.faults.push_back("OpenGL: " + error);
    }
    ++tally.cases;
    tally.worstRays = std::max(tally.worstRays, findings.worstRays);
    tally.worstPicture = std::max(tally.worstPicture, findings.worstPicture);
    tally.worstSun = std::max(tally.worstSun, findings.worstSun);
    rays += findings.rays;
    if (findings.faults.empty()) {
        return true;
    }
    ++tally.failed;
    std::printf("FAILED (%s): tools/stress.sh sky --seed %llu --case %d --verbose\n",
                skyKindNames()[std::size_t(setUp.kind)],
                static_cast<unsigned long long>(setUp.seed), setUp.number);
    const std::size_t shown = verbose ? findings.faults.size() : 1;
    for (std::size_t i = 0; i < std::min(shown, findings.faults.size()); ++i) {
        std::printf("  %s\n", findings.faults[i].c_str());
    }
    std::fflush(stdout);
    return false;
}

/// The number of cases that failed.
int runCases(const Options& options) {
    const Context context;
    std::map<int, Tally> tallies;
    long long rays = 0;
    int failed = 0;
    int done = 0;
    const auto start = std::chrono::steady_clock::now();
    const auto isOver = [&] {
        if (options.cases || options.firstCase) {
            return done >= options.cases.value_or(1);
        }
        return std::chrono::steady_clock::now() - start >=
               std::chrono::duration<double>(options.seconds);
    };
    for (; !isOver(); ++done) {
        const SkySetUp setUp = makeSkySetUp(options.seed, options.firstCase.value_or(0) + done);
        failed += check(setUp, options.verbose, tallies[setUp.kind], rays) ? 0 : 1;
    }
    std::printf("\n%-34s %6s %6s   %s\n", "sky", "cases", "failed",
                "largest step, of what is allowed: rays, pictures, light on the scene");
    for (const auto& [kind, tally] : tallies) {
        std::printf("  %-32s %6d %6d %10.3f %10.3f %10.3f\n", skyKindNames()[std::size_t(kind)],
                    tally.cases, tally.failed, tally.worstRays, tally.worstPicture, tally.worstSun);
    }
    std::printf("\nseed %llu: %d cases, %lld rays and pixels, %d failed\n",
                static_cast<unsigned long long>(options.seed), done, rays, failed);
    return failed;
}

int run(int argc, char** argv) {
    Options options;
    CLI::App app(
        "Looks at the sky of ordinary and extreme planets and checks every ray and picture: "
        "finite, "
        "not negative, and neighbours no farther apart than in the double-precision answer.",
        "ribalta_stress_sky");
    app.add_option("--seconds", options.seconds, "How long to go on")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    app.add_option("--seed", options.seed, "Which cases")->capture_default_str();
    app.add_option("--cases", options.cases, "How many cases, however long they take")
        ->check(CLI::PositiveNumber);
    app.add_option("--case", options.firstCase, "This case of the seed, or the first of --cases")
        ->check(CLI::NonNegativeNumber);
    app.add_flag("--verbose", options.verbose, "Every case's numbers and every fault");
    app.footer("Exit codes: 0 all is well, 1 a case failed, 2 wrong usage, 4 no usable OpenGL.");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : int(ErrorKind::kUsage);
    }
    return runCases(options) == 0 ? 0 : 1;
}

}  // namespace
}  // namespace ribalta::stress

int main(int argc, char** argv) {
    try {
        return ribalta::stress::run(argc, argv);
    } catch (const ribalta::Error& error) {
        std::fprintf(stderr, "ribalta_stress_sky: error: %s\n", error.what());
        return error.exitCode();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "ribalta_stress_sky: error: %s\n", error.what());
        return 1;
    }
}
