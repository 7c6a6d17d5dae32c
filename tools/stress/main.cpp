// The program ribalta_stress: draws random and adversarial set-ups for a given time and checks
// every picture. Prints for each failure the command that repeats it, and at the end the worst of
// each class.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "check_set_up.h"
#include "gl/context.h"
#include "gl/debug_output.h"
#include "make_set_up.h"
#include "render/beam_method.h"

namespace ribalta::stress {
namespace {

struct Options {
    double seconds = 20.0;
    std::uint64_t seed = 1;
    std::optional<int> cases;
    std::optional<int> firstCase;
    std::string beams = "all";
    bool verbose = false;
};

/// Of the cases of one class and method.
struct Tally {
    int cases = 0;
    int failed = 0;
    double worstError = 0.0;
    double worstMotion = 0.0;
    double worstShare = 0.0;

    void add(const Findings& findings) {
        ++cases;
        failed += findings.faults.empty() ? 0 : 1;
        worstError = std::max(worstError, findings.worstError);
        worstMotion = std::max(worstMotion, findings.worstMotion);
        worstShare = std::max(worstShare, findings.worstShare);
    }
};

class Run {
  public:
    explicit Run(const Options& options) : options_(options) {
        for (const Named<BeamMethod>& each : beamMethods()) {
            if (options.beams == "all" || options.beams == each.name) {
                methods_.push_back(each.value);
            }
        }
    }

    /// The number of cases that failed.
    int run() {
        const auto start = std::chrono::steady_clock::now();
        const auto isOver = [&](int done) {
            if (options_.cases || options_.firstCase) {
                return done >= options_.cases.value_or(1);
            }
            return std::chrono::steady_clock::now() - start >=
                   std::chrono::duration<double>(options_.seconds);
        };
        for (int done = 0; !isOver(done); ++done) {
            check(makeSetUp(options_.seed, options_.firstCase.value_or(0) + done));
        }
        print();
        return failed_;
    }

  private:
    void check(const SetUp& setUp) {
        if (options_.verbose) {
            std::printf("%s", describe(setUp).c_str());
            std::fflush(stdout);  // a case that never ends is known by its numbers
        }
        bool failed = report(setUp, "all", "reference", checkReference(setUp));
        for (const BeamMethod method : methods_) {
            Findings findings = checkSetUp(setUp, method, stage_);
            for (const std::string& error : takeGlErrors()) {
                findings.faults.push_back("OpenGL: " + error);
            }
            const std::string methodName(name(method));
            failed = report(setUp, methodName, methodName, findings) || failed;
        }
        ++cases_;
        failed_ += failed ? 1 : 0;
    }

    bool report(const SetUp& setUp, const std::string& option, const std::string& column,
                const Findings& findings) {
        tallies_[column][setUp.kind].add(findings);
        pixels_ += findings.pixels;
        if (options_.verbose) {
            std::printf("  %s: error %.3g, motion %.3g of the brightest, %.3g of the bound\n",
                        column.c_str(), findings.worstError, findings.worstMotion,
                        findings.worstShare);
        }
        if (findings.faults.empty()) {
            return false;
        }
        std::printf("FAILED (%s, %s): tools/stress.sh --seed %llu --case %d --beams %s --verbose\n",
                    kindNames()[std::size_t(setUp.kind)], column.c_str(),
                    static_cast<unsigned long long>(setUp.seed), setUp.number, option.c_str());
        const std::size_t shown = options_.verbose ? findings.faults.size() : 1;
        for (std::size_t i = 0; i < std::min(shown, findings.faults.size()); ++i) {
            std::printf("  %s\n", findings.faults[i].c_str());
        }
        std::fflush(stdout);
        return true;
    }

    void print() const {
        for (const auto& [column, kinds] : tallies_) {
            std::printf("\n%-34s %6s %6s %12s %12s %14s\n", column.c_str(), "cases", "failed",
                        "worst error", "worst motion", "share of bound");
            for (const auto& [kind, tally] : kinds) {
                std::printf("  %-32s %6d %6d %12.2e %12.2e %14.3f\n",
                            kindNames()[std::size_t(kind)], tally.cases, tally.failed,
                            tally.worstError, tally.worstMotion, tally.worstShare);
            }
        }
        std::printf("\nseed %llu: %d cases, %lld pixels compared, %d failed\n",
                    static_cast<unsigned long long>(options_.seed), cases_, pixels_, failed_);
    }

    Options options_;
    std::vector<BeamMethod> methods_;
    Context context_;
    Stage stage_;
    std::map<std::string, std::map<int, Tally>> tallies_;
    int cases_ = 0;
    int failed_ = 0;
    long long pixels_ = 0;
};

int run(int argc, char** argv) {
    Options options;
    CLI::App app(
        "Draws random and adversarial set-ups of lamps, haze and cameras and checks every "
        "picture: finite, not negative, within a bound of the double-precision answer, the "
        "same after a rigid motion.",
        "ribalta_stress");
    app.add_option("--seconds", options.seconds, "How long to go on")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    app.add_option("--seed", options.seed, "Which cases")->capture_default_str();
    app.add_option("--cases", options.cases, "How many cases, however long they take")
        ->check(CLI::PositiveNumber);
    app.add_option("--case", options.firstCase, "This case of the seed, or the first of --cases")
        ->check(CLI::NonNegativeNumber);
    std::vector<std::string> names = {"all"};
    for (const Named<BeamMethod>& each : beamMethods()) {
        names.emplace_back(each.name);
    }
    app.add_option("--beams", options.beams, "Method")
        ->check(CLI::IsMember(names))
        ->capture_default_str();
    app.add_flag("--verbose", options.verbose, "Every case's numbers and every fault");
    app.footer("Exit codes: 0 all is well, 1 a case failed, 2 wrong usage, 4 no usable OpenGL.");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : int(ErrorKind::kUsage);
    }
    return Run(options).run() == 0 ? 0 : 1;
}

}  // namespace
}  // namespace ribalta::stress

int main(int argc, char** argv) {
    try {
        return ribalta::stress::run(argc, argv);
    } catch (const ribalta::Error& error) {
        std::fprintf(stderr, "ribalta_stress: error: %s\n", error.what());
        return error.exitCode();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "ribalta_stress: error: %s\n", error.what());
        return 1;
    }
}
