#include "image/read_image.h"

#include <optional>
#include <string>
#include <vector>

#include "base/read_file.h"
#include "image/claimed_size.h"
#include "image/essential_chunks.h"
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

// Decodes by one of the codec's two functions, with what is wrong as an Error.
template <typename Result>
Result decodeBy(std::string (*ImageCodec::*decode)(std::span<const std::byte>, ImageFormat,
                                                   const ImageLimits&, Result&),
                std::span<const std::byte> encoded, const Place& place, const ImageLimits& limits) {
    const ImageFormat format = knownFormat(encoded, place);
    const EssentialChunks essential = essentialChunks(encoded, format);
    std::string wrong = essential.wrong;
    // Libraries take memory for a size that is merely claimed, some as soon as a file is opened.
    const std::optional<ClaimedSize> claimed = claimedSize(encoded, format);
    if (wrong.empty() && claimed) {
        wrong = sizeFault(claimed->width, claimed->height, limits);
    }
    Result result;
    if (wrong.empty()) {
        const std::span<const std::byte> whole =
            essential.encoded.empty() ? encoded : std::span(essential.encoded);
        wrong = (imageCodec().*decode)(whole, format, limits, result);
    }
    if (!wrong.empty()) {
        throw Error(ErrorKind::kBadInput, place, wrong);
    }
    return result;
}

}  // namespace

Image decodeImage(std::span<const std::byte> encoded, const Place& place,
                  const ImageLimits& limits) {
    Image image = decodeBy(&ImageCodec::decode, encoded, place, limits);
    image.name = place.text();
    return image;
}

FloatImage readFloatImage(const std::filesystem::path& path) {
    const std::vector<std::byte> encoded = readFile(path);
    return decodeBy(&ImageCodec::decodeFloat, encoded, {path.string(), ""}, ImageLimits{});
}

}  // namespace ribalta
