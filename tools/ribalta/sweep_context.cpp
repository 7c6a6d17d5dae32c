#include "sweep_context.h"

#include <ctime>
#include <fstream>
#include <string>
#include <thread>

#include <sys/utsname.h>

#include "base/error.h"

namespace ribalta {
namespace {

using Json = nlohmann::json;

#ifdef NDEBUG
constexpr const char* kBuildType = "release";
#else
constexpr const char* kBuildType = "debug";
#endif

std::string now() {
    const std::time_t time = std::time(nullptr);
    std::tm parts{};
    localtime_r(&time, &parts);
    char text[40];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S%z", &parts);
    return text;
}

// "model name : Intel ..." of the first processor; empty where the system does not say.
std::string processorName() {
    std::ifstream stream("/proc/cpuinfo");
    std::string line;
    while (std::getline(stream, line)) {
        if (line.starts_with("model name")) {
            const std::size_t colon = line.find(": ");
            return colon == std::string::npos ? "" : line.substr(colon + 2);
        }
    }
    return "";
}

// As the user typed it, its folders left out of the program's name.
std::string commandLine() {
    std::ifstream stream("/proc/self/cmdline");
    std::string line;
    std::string argument;
    while (std::getline(stream, argument, '\0')) {
        if (line.empty()) {
            argument = std::filesystem::path(argument).filename().string();
        }
        const bool plain = argument.find_first_of(" '\"\\$*") == std::string::npos;
        line += line.empty() ? "" : " ";
        line += plain ? argument : '\'' + argument + '\'';
    }
    return oneLine(line);
}

std::string systemName() {
    utsname names{};
    uname(&names);
    return std::string(names.sysname) + " " + names.release + " " + names.machine;
}

}  // namespace

Json sweepContext(const Context& context, const std::string& program) {
    return {{"date", now()},
            {"executable", "ribalta"},
            {"command", commandLine()},
            {"version", RIBALTA_VERSION},
            {"program", program},
            {"renderer", context.renderer()},
            {"opengl", context.version()},
            {"software_renderer", context.isSoftware()},
            {"cpu", processorName()},
            {"num_cpus", std::thread::hardware_concurrency()},
            {"system", systemName()},
            {"library_build_type", kBuildType}};
}

void makeFolder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        throw Error(ErrorKind::kJobFailed, {folder.string(), ""},
                    "cannot be made: " + error.message() + "; choose another folder");
    }
}

}  // namespace ribalta
