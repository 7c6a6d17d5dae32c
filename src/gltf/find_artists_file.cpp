#include "gltf/find_artists_file.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <system_error>

#include "gltf/read_uri.h"

namespace ribalta::gltf {
namespace {

namespace fs = std::filesystem;

// Files of a folder that are looked through for one in other letters; a stage has few.
constexpr int kMostLookedThrough = 10000;

bool isThere(const std::string& path, const fs::path& folder, bool allowOutside,
             const Place& place) {
    try {
        std::error_code failed;
        return fs::is_regular_file(resolvePath(path, folder, place, allowOutside), failed);
    } catch (const Error&) {
        return false;
    }
}

std::string trimmed(const std::string& text) {
    const auto isOutside = [](char c) {
        return std::isspace(static_cast<unsigned char>(c)) != 0 || c == '"' || c == '\'';
    };
    const auto first = std::find_if_not(text.begin(), text.end(), isOutside);
    const auto last = std::find_if_not(text.rbegin(), text.rend(), isOutside).base();
    return first < last ? std::string(first, last) : std::string();
}

bool isAbsolute(const std::string& path) {
    const bool hasDrive = path.size() > 2 &&
                          std::isalpha(static_cast<unsigned char>(path[0])) != 0 &&
                          path[1] == ':' && path[2] == '/';
    return hasDrive || path.starts_with('/') || path.starts_with("file:");
}

bool isSameInOtherLetters(const std::string& a, const std::string& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
        return std::tolower(static_cast<unsigned char>(x)) ==
               std::tolower(static_cast<unsigned char>(y));
    });
}

// The entry of a folder that has the name but for the case of its letters; the first by name.
std::optional<std::string> entryInOtherLetters(const fs::path& folder, const std::string& name) {
    std::optional<std::string> found;
    std::error_code failed;
    int looked = 0;
    for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, failed), end;
         !failed && entry != end && looked < kMostLookedThrough;
         entry.increment(failed), ++looked) {
        const std::string here = entry->path().filename().string();
        if (isSameInOtherLetters(here, name) && (!found || here < *found)) {
            found = here;
        }
    }
    return found;
}

std::optional<std::string> pathInOtherLetters(const std::string& path, const fs::path& folder) {
    fs::path found;
    for (const fs::path& part : fs::path(path)) {
        if (part == "." || part.empty()) {
            continue;
        }
        if (part == "..") {
            return std::nullopt;
        }
        const auto entry = entryInOtherLetters(folder / found, part.string());
        if (!entry) {
            return std::nullopt;
        }
        found /= *entry;
    }
    return found.empty() ? std::nullopt : std::optional(found.string());
}

}  // namespace

std::optional<FoundFile> findArtistsFile(const std::string& written, const fs::path& folder,
                                         bool allowOutside, const Place& place) {
    if (isThere(written, folder, allowOutside, place)) {
        return FoundFile{written, ""};
    }
    std::string path = written;
    std::string note;
    const auto become = [&](std::string other, const char* why) {
        if (other != path) {
            path = std::move(other);
            note += (note.empty() ? "" : ", ") + std::string(why);
        }
        return !note.empty() && isThere(path, folder, allowOutside, place);
    };
    const auto found = [&] { return FoundFile{path, note}; };
    if (become(trimmed(path), "without spaces or quotes around it")) {
        return found();
    }
    std::string slashes = path;
    std::replace(slashes.begin(), slashes.end(), '\\', '/');
    if (become(slashes, "with slashes for backslashes")) {
        return found();
    }
    if (path.starts_with("//") && become(path.substr(2), "without Blender's // in front")) {
        return found();
    }
    if (become(percentDecode(path), "with its %-codes decoded")) {
        return found();
    }
    if (isAbsolute(path) &&
        become(fs::path(path).filename().string(), "by its name beside the scene")) {
        return found();
    }
    if (const auto other = pathInOtherLetters(path, folder);
        other && become(*other, "in other upper and lower case letters")) {
        return found();
    }
    return std::nullopt;
}

void tellOfFound(const std::string& written, const FoundFile& found, const Place& place,
                 Report& report) {
    constexpr std::size_t kLongest = 200;
    if (!found.note.empty()) {
        report.repaired(place, "is \"" + written.substr(0, kLongest) +
                                   "\", which is not there; \"" + found.path + "\" is used, " +
                                   found.note);
    }
}

std::filesystem::path findUri(const std::string& uri, const fs::path& folder, bool allowOutside,
                              const Place& place, Report& report) {
    try {
        fs::path named = resolveUri(uri, folder, place, allowOutside);
        std::error_code failed;
        if (fs::is_regular_file(named, failed)) {
            return named;
        }
    } catch (const Error&) {
        // Thrown again below, unless the file that is meant is found.
    }
    std::optional<FoundFile> found = findArtistsFile(uri, folder, allowOutside, place);
    if (!found) {
        return resolveUri(uri, folder, place, allowOutside);
    }
    if (found->note.empty()) {
        found->note = "whose name has the %-codes themselves";
    }
    tellOfFound(uri, *found, place, report);
    return resolvePath(found->path, folder, place, allowOutside);
}

}  // namespace ribalta::gltf
