#include "image/read_image.h"

#include <string>
#include <vector>

#include "base/read_file.h"
#include "image/image_codec.h"
#include "image/image_format.h"

namespace ribalta {
namespace {

ImageFormat knownFormat(std::span<const std::byte> encoded, const Place& place) {
    const ImageFormat format = imageFormat(encoded);
    if (format == ImageFormat::kUnknown) {
        throw Error(ErrorKind::kBadInput, place,
                    "holds " + describeUnknownImage(encoded) +
                        "; save it as PNG, JPEG, WebP, TIFF, OpenEXR or Radiance HDR");
    }
    return format;
}

}  // namespace

Image decodeImage(std::span<const std::byte> encoded, const Place& place,
                  const ImageLimits& limits) {
    const ImageFormat format = knownFormat(encoded, place);
    Image image;
    const std::string wrong = imageCodec().decode(encoded, format, limits, image);
    if (!wrong.empty()) {
        throw Error(ErrorKind::kBadInput, place, wrong);
    }
    image.name = place.text();
    return image;
}

FloatImage readFloatImage(const std::filesystem::path& path) {
    const Place place{path.string(), ""};
    const std::vector<std::byte> encoded = readFile(path);
    const ImageFormat format = knownFormat(encoded, place);
    FloatImage image;
    const std::string wrong = imageCodec().decodeFloat(encoded, format, ImageLimits{}, image);
    if (!wrong.empty()) {
        throw Error(ErrorKind::kBadInput, place, wrong);
    }
    return image;
}

}  // namespace ribalta
