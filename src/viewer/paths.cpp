#include "viewer/paths.h"

#include <algorithm>
#include <system_error>

namespace ribalta {

std::filesystem::path plainPath(const std::filesystem::path& file) {
    std::error_code failed;
    const std::filesystem::path absolute = std::filesystem::absolute(file, failed);
    return (failed ? file : absolute).lexically_normal();
}

bool isThere(const std::filesystem::path& file) {
    std::error_code failed;
    return !file.empty() && std::filesystem::exists(file, failed);
}

bool isAmong(const std::filesystem::path& file, const std::vector<std::filesystem::path>& files) {
    return std::any_of(files.begin(), files.end(), [&](const std::filesystem::path& each) {
        return plainPath(each) == plainPath(file);
    });
}

std::filesystem::path lookBeside(const std::filesystem::path& scene) {
    std::filesystem::path file = scene;
    return file.replace_extension(".look.json");
}

}  // namespace ribalta
