#include "image/read_image.h"

#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/read_file.h"
#include "image/claimed_size.h"
#include "image/decode_jpeg.h"
#include "image/decode_png.h"
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

std::string faultOf(std::span<const std::byte> encoded, ImageFormat format,
                    const ImageLimits& limits) {
    // Libraries take memory for a size that is merely claimed, some as soon as a file is opened.
    const std::optional<ClaimedSize> claimed = claimedSize(encoded, format);
    return claimed ? sizeFault(claimed->width, claimed->height, limits) : "";
}

// Without the image module, whose libraries take longer to open than a picture to decode.
std::optional<Image> decodeDirectly(std::span<const std::byte> encoded, ImageFormat format,
                                    const ImageLimits& limits) {
    if (format == ImageFormat::kPng) {
        return decodePlainPng(encoded, limits);
    }
    // A library of JPEGs fills in grey what is missing.
    if (format == ImageFormat::kJpeg && essentialChunks(encoded, format).wrong.empty()) {
        return decodePlainJpeg(encoded, limits);
    }
    return std::nullopt;
}

// Decodes by one of the codec's two functions, with what is wrong as an Error.
template <typename Result>
Result decodeBy(std::string (*ImageCodec::*decode)(std::span<const std::byte>, ImageFormat,
                                                   const ImageLimits&, Result&),
                std::span<const std::byte> encoded, const Place& place, const ImageLimits& limits) {
    const ImageFormat format = knownFormat(encoded, place);
    EssentialChunks essential = essentialChunks(encoded, format);
    // A copy in any case: libraries check what they look at again.
    if (essential.encoded.empty()) {
        essential.encoded.assign(encoded.begin(), encoded.end());
    }
    std::string wrong =
        essential.wrong.empty() ? faultOf(essential.encoded, format, limits) : essential.wrong;
    Result result;
    if (wrong.empty()) {
        wrong = (imageCodec().*decode)(essential.encoded, format, limits, result);
    }
    if (!wrong.empty()) {
        throw Error(ErrorKind::kBadInput, place, wrong);
    }
    return result;
}

}  // namespace

Image decodeImage(std::span<const std::byte> encoded, const Place& place,
                  const ImageLimits& limits) {
    std::optional<Image> direct;
    try {
        direct = decodeDirectly(encoded, imageFormat(encoded), limits);
    } catch (const std::bad_alloc&) {
        throw Error(ErrorKind::kBadInput, place, "does not fit into memory; scale it down");
    }
    Image image =
        direct ? std::move(*direct) : decodeBy(&ImageCodec::decode, encoded, place, limits);
    image.name = place.text();
    return image;
}

FloatImage readFloatImage(const std::filesystem::path& path) {
    const std::vector<std::byte> encoded = readFile(path);
    return decodeBy(&ImageCodec::decodeFloat, encoded, {path.string(), ""}, ImageLimits{});
}

}  // namespace ribalta
