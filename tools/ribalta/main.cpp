// The command `ribalta`: reads the command line, runs one subcommand, turns errors into one line
// and an exit code.
#include <cstdio>
#include <exception>
#include <new>

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "base/progress.h"
#include "inspect_command.h"
#include "render_command.h"

namespace {

constexpr int kUsage = static_cast<int>(ribalta::ErrorKind::kUsage);
constexpr int kJobFailed = static_cast<int>(ribalta::ErrorKind::kJobFailed);

constexpr const char* kExitCodes =
    "Exit codes: 0 done, 1 the job failed, 2 wrong usage, 3 bad input file, 4 no usable OpenGL.";

int fail(const char* message, int exitCode) {
    ribalta::Progress::clearLine();
    std::fprintf(stderr, "ribalta: error: %s\n", message);
    return exitCode;
}

int run(int argc, char** argv) {
    CLI::App app("Previews stage lighting: gobo beams in haze, drawn from glTF scenes.", "ribalta");
    app.set_version_flag("--version", RIBALTA_VERSION);
    app.require_subcommand(1);
    app.footer(kExitCodes);
    ribalta::addRenderCommand(app);
    ribalta::addInspectCommand(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
            return app.exit(error);  // --help, --version
        }
        return fail((std::string(error.what()) + "; see ribalta --help").c_str(), kUsage);
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
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
