#include "outcome_table.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <system_error>

#include "base/error.h"
#include "gltf/load_gltf.h"

namespace ribalta {
namespace {

bool isSceneName(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    return extension == ".gltf" || extension == ".glb";
}

// Links are not followed: a circle of them would not end.
std::vector<std::filesystem::path> scenesBelow(const std::filesystem::path& folder) {
    namespace fs = std::filesystem;
    std::vector<fs::path> scenes;
    std::error_code failed;
    fs::recursive_directory_iterator entry(folder, failed);
    for (; !failed && entry != fs::recursive_directory_iterator(); entry.increment(failed)) {
        if (entry->is_regular_file(failed) && isSceneName(entry->path())) {
            scenes.push_back(entry->path());
        }
    }
    if (failed) {
        throw Error(ErrorKind::kBadInput, {folder.string(), ""},
                    "cannot be looked through: " + failed.message());
    }
    if (scenes.empty()) {
        throw Error(ErrorKind::kBadInput, {folder.string(), ""},
                    "has no .gltf or .glb in it or below; give another folder");
    }
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

void printLine(const std::filesystem::path& path, const char* outcome, const std::string& message) {
    std::printf("%s\t%s\t%s\n", oneLine(path.string()).c_str(), outcome, oneLine(message).c_str());
    std::fflush(stdout);
}

void loadOne(const std::filesystem::path& path, const LoadOptions& options, OutcomeCounts& counts) {
    try {
        const LoadedScene loaded = loadGltf(path, options);
        const std::vector<Report::Entry>& entries = loaded.report.entries();
        if (entries.empty()) {
            ++counts.loaded;
            printLine(path, "loaded", "");
            return;
        }
        const Report::Entry& first = entries.front();
        ++counts.reported;
        printLine(path, "reported",
                  std::string(name(first.kind)) + ": " +
                      (first.place.pointer.empty() ? "" : first.place.pointer + ": ") +
                      first.message);
    } catch (const Error& error) {
        // The path stands in the line already.
        const std::string text = error.what();
        const std::string prefix = oneLine(path.string()) + ": ";
        ++counts.refused;
        printLine(path, "refused",
                  text.compare(0, prefix.size(), prefix) == 0 ? text.substr(prefix.size()) : text);
    }
}

}  // namespace

OutcomeCounts printOutcomes(const std::vector<std::string>& paths, const LoadOptions& options) {
    OutcomeCounts counts;
    for (const std::string& path : paths) {
        std::error_code failed;
        if (!std::filesystem::is_directory(path, failed)) {
            loadOne(path, options, counts);
            continue;
        }
        for (const std::filesystem::path& scene : scenesBelow(path)) {
            loadOne(scene, options, counts);
        }
    }
    return counts;
}

}  // namespace ribalta
