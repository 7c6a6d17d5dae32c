// The command `ribalta`: reads the command line, runs one subcommand, turns errors into one line
// and an exit code.
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "base/freed_memory.h"
#include "base/log.h"
#include "compare_command.h"
#include "inspect_command.h"
#include "process.h"
#include "reference_command.h"
#include "render_command.h"
#include "sky_command.h"
#include "sweep_command.h"
#include "view_command.h"

namespace {

constexpr int kUsage = static_cast<int>(ribalta::ErrorKind::kUsage);
constexpr int kJobFailed = static_cast<int>(ribalta::ErrorKind::kJobFailed);

constexpr const char* kExitCodes =
    "Exit codes: 0 done, 1 the job failed, 2 wrong usage, 3 bad input file, 4 no usable OpenGL.";

int fail(const std::string& message, int exitCode) {
    ribalta::logError(message);
    return exitCode;
}

// What the parser found wrong, and the help that says how it is right.
std::string usageError(const CLI::App& app, const CLI::ParseError& error) {
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    const std::string help =
        "; see " +
        (chosen.empty() ? std::string("ribalta") : "ribalta " + chosen.front()->get_name()) +
        " --help";
    if (!chosen.empty()) {
        return error.what() + help;
    }
    std::string subcommands;
    for (const CLI::App* subcommand : app.get_subcommands(nullptr)) {
        subcommands += (subcommands.empty() ? "" : ", ") + subcommand->get_name();
    }
    const std::vector<std::string> unknown = app.remaining();
    return (unknown.empty() ? "no subcommand"
                            : "no subcommand or option '" + unknown.front() + "'") +
           "; there are: " + subcommands + help;
}

// CLI11 takes the next argument for the value of "--option=".
const char* findEmptyValue(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument = argv[i];
        if (argument == "--") {
            return nullptr;
        }
        if (argument.starts_with("--") && argument.find('=') == argument.size() - 1) {
            return argv[i];
        }
    }
    return nullptr;
}

int run(int argc, char** argv) {
    CLI::App app("Previews stage lighting: gobo beams in haze, drawn from glTF scenes.", "ribalta");
    constexpr int kHelpColumn = 36;
    app.get_formatter()->column_width(kHelpColumn);
    app.set_version_flag("--version", RIBALTA_VERSION);
    app.require_subcommand(1);
    app.footer(kExitCodes);
    ribalta::addRenderCommand(app);
    ribalta::addViewCommand(app);
    ribalta::addInspectCommand(app);
    ribalta::addCompareCommand(app);
    ribalta::addSweepCommand(app);
    ribalta::addReferenceCommand(app);
    ribalta::addSkyCommand(app);
    if (const char* const empty = findEmptyValue(argc, argv)) {
        return fail(std::string(empty) + " has no value; see ribalta --help", kUsage);
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::Success)) {
            return fail(usageError(app, error), kUsage);
        }
        app.exit(error);  // --help, --version
    }
    ribalta::finishStdout();
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    ribalta::keepFreedMemory();
    ribalta::prepareProcess();
    try {
        return run(argc, argv);
    } catch (const ribalta::Error& error) {
        return fail(error.what(), error.exitCode());
    } catch (const std::bad_alloc&) {
        return fail("out of memory; try a smaller picture or scene", kJobFailed);
    } catch (const std::exception& error) {
        return fail(error.what(), kJobFailed);
    }
}
