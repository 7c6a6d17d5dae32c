#include "image/write_image.h"

#include <string>
#include <string_view>
#include <vector>

#include "base/check.h"
#include "base/error.h"
#include "base/temporary_file.h"
#include "image/encode_png.h"
#include "image/image_codec.h"

namespace ribalta {
namespace {

// Encoded in memory first, so that a full disk is seen by our own write and not by a library.
void writeWhole(const std::filesystem::path& path, const std::string& wrong,
                const std::vector<unsigned char>& bytes) {
    if (!wrong.empty()) {
        throw Error(ErrorKind::kJobFailed, {path.string(), ""}, wrong);
    }
    writeFileAtomically(
        path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

}  // namespace

void writePng(const std::filesystem::path& path, int width, int height,
              std::span<const std::uint8_t> rgb) {
    CHECK(width > 0 && height > 0 && rgb.size() == std::size_t(width) * std::size_t(height) * 3);
    std::vector<unsigned char> bytes;
    const std::string wrong = encodePng(width, height, rgb, bytes);
    writeWhole(path, wrong, bytes);
}

void writeExr(const std::filesystem::path& path, const FloatImage& image) {
    CHECK(image.width > 0 && image.height > 0 && !image.channels.empty());
    CHECK(image.values.size() ==
          std::size_t(image.width) * std::size_t(image.height) * image.channels.size());
    std::vector<unsigned char> bytes;
    const std::string wrong = imageCodec().encodeExr(image, bytes);
    writeWhole(path, wrong, bytes);
}

}  // namespace ribalta
