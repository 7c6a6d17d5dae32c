#include "frame_files.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <string>

#include "base/error.h"
#include "base/read_file.h"
#include "image/essential_chunks.h"
#include "image/read_image.h"

namespace ribalta {
namespace {

constexpr int kDigits = 4;

std::string digits(int frame, std::size_t count) {
    char text[32];
    std::snprintf(text, sizeof text, "%0*d", int(std::min<std::size_t>(count, 20)), frame);
    return text;
}

int sideAt(const std::vector<std::byte>& bytes, std::size_t offset) {
    std::uint32_t side = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        side = side << 8U | std::to_integer<std::uint32_t>(bytes[offset + i]);
    }
    return int(side);
}

bool isWholePng(const std::filesystem::path& path, int width, int height) {
    // Where the first chunk, the header, holds both sides (PNG specification, section 11.2.2).
    constexpr std::size_t kWidthAt = 16;
    constexpr std::size_t kHeightAt = 20;
    const std::vector<std::byte> bytes = readFile(path);
    return bytes.size() > kHeightAt + 4 && imageFormat(bytes) == ImageFormat::kPng &&
           sideAt(bytes, kWidthAt) == width && sideAt(bytes, kHeightAt) == height &&
           essentialChunks(bytes, ImageFormat::kPng).wrong.empty();
}

}  // namespace

std::string endingOf(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

bool isVideo(const std::filesystem::path& path) {
    const std::string ending = endingOf(path);
    return ending == ".mp4" || ending == ".webm" || ending == ".mkv";
}

std::filesystem::path numbered(const std::filesystem::path& picture, int frame) {
    std::string name = picture.filename().string();
    const std::size_t last = name.rfind('#');
    if (last == std::string::npos) {
        name =
            picture.stem().string() + "_" + digits(frame, kDigits) + picture.extension().string();
    } else {
        const std::size_t before = name.find_last_not_of('#', last);
        const std::size_t first = before == std::string::npos ? 0 : before + 1;
        name.replace(first, last + 1 - first, digits(frame, last + 1 - first));
    }
    return picture.parent_path() / name;
}

std::vector<std::filesystem::path> allFrameFiles(const std::vector<std::filesystem::path>& outputs,
                                                 const FrameRange& range) {
    std::vector<std::filesystem::path> files;
    for (const std::filesystem::path& output : outputs) {
        if (isVideo(output)) {
            files.push_back(output);
            continue;
        }
        for (int frame = range.first; frame <= range.last; ++frame) {
            files.push_back(numbered(output, frame));
        }
    }
    std::vector<std::filesystem::path> sorted = files;
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end()) {
        throw Error(ErrorKind::kUsage, {twice->string(), ""},
                    "is what two of the outputs call one of their frames; give other names");
    }
    return files;
}

std::filesystem::file_time_type newestOf(const std::vector<std::filesystem::path>& files) {
    auto newest = std::filesystem::file_time_type::min();
    for (const std::filesystem::path& file : files) {
        std::error_code missing;
        const auto written = std::filesystem::last_write_time(file, missing);
        newest = missing ? newest : std::max(newest, written);
    }
    return newest;
}

bool isWholePicture(const std::filesystem::path& path, int width, int height,
                    const FrameLayers& layers) {
    std::error_code missing;
    if (!std::filesystem::is_regular_file(path, missing)) {
        return false;
    }
    try {
        if (endingOf(path) == ".png") {
            return isWholePng(path, width, height);
        }
        const FloatImage image = readFloatImage(path);
        const auto has = [&](bool wanted, const char* channel) {
            return !wanted || image.channel(channel) >= 0;
        };
        return image.width == width && image.height == height && has(layers.beams, "beams.R") &&
               has(layers.transmittance, "transmittance.R") && has(layers.depth, "Z") &&
               has(layers.normal, "normal.X");
    } catch (const Error&) {
        return false;  // it cannot be read, and so is not whole
    }
}

}  // namespace ribalta
