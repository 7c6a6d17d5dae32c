// The image module's one exported function. Nothing thrown inside leaves it.

#include <exception>
#include <new>

#include <OpenImageIO/imageio.h>

#include "image/codec/decode.h"
#include "image/codec/encode.h"
#include "image/image_codec.h"

namespace ribalta {
namespace {

template <typename Work>
std::string answer(const Work& work) {
    try {
        work();
        return "";
    } catch (const std::bad_alloc&) {
        return "does not fit into memory; scale it down";
    } catch (const std::exception& error) {
        return error.what();
    } catch (...) {
        return "made the picture library fail without a reason; save it anew";
    }
}

std::string decode(std::span<const std::byte> encoded, ImageFormat format,
                   const ImageLimits& limits, Image& result) {
    return answer([&] {
        result = format == ImageFormat::kWebp ? decodeWebp(encoded, limits)
                                              : decodeWithOiio(encoded, format, limits);
    });
}

FloatImage asFloat(const Image& image) {
    FloatImage result{image.width, image.height, {"R", "G", "B", "A"}, {}};
    result.values.reserve(image.pixels.size());
    for (const std::byte value : image.pixels) {
        result.values.push_back(static_cast<float>(value) / 255.0F);
    }
    return result;
}

std::string decodeFloat(std::span<const std::byte> encoded, ImageFormat format,
                        const ImageLimits& limits, FloatImage& result) {
    return answer([&] {
        result = format == ImageFormat::kWebp ? asFloat(decodeWebp(encoded, limits))
                                              : decodeFloatWithOiio(encoded, format, limits);
    });
}

std::string exr(const FloatImage& image, std::vector<unsigned char>& result) {
    return answer([&] { result = encodeExr(image); });
}

}  // namespace
}  // namespace ribalta

extern "C" __attribute__((visibility("default"))) const ribalta::ImageCodec* ribaltaImageCodec() {
    static const ribalta::ImageCodec codec = [] {
        // Callers decode several pictures at once, each on a thread of theirs. OpenEXR alone keeps
        // its pool, one for the process and as wide as the machine: compressing a frame takes a
        // second.
        OIIO::attribute("threads", 1);
        return ribalta::ImageCodec{&ribalta::decode, &ribalta::decodeFloat, &ribalta::exr};
    }();
    return &codec;
}
