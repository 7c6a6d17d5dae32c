#include "image/decode_jpeg.h"

#include <memory>
#include <new>
#include <type_traits>

#include <turbojpeg.h>

namespace ribalta {

std::optional<Image> decodePlainJpeg(std::span<const std::byte> encoded,
                                     const ImageLimits& limits) {
    struct Destroy {
        void operator()(void* decoder) const { tjDestroy(decoder); }
    };
    const std::unique_ptr<std::remove_pointer_t<tjhandle>, Destroy> decoder(tjInitDecompress());
    if (!decoder) {
        throw std::bad_alloc();
    }
    const auto* bytes = reinterpret_cast<const unsigned char*>(encoded.data());
    int width = 0;
    int height = 0;
    int subsampling = 0;
    int space = 0;
    if (tjDecompressHeader3(decoder.get(), bytes, encoded.size(), &width, &height, &subsampling,
                            &space) != 0 ||
        !sizeFault(width, height, limits).empty() || space == TJCS_CMYK || space == TJCS_YCCK) {
        return std::nullopt;
    }
    Image image;
    image.width = width;
    image.height = height;
    image.pixels = RawBytes(std::size_t(width) * std::size_t(height) * 4);
    // A few bytes may else ask for hours of passes over the picture. Missing alpha comes out
    // opaque.
    constexpr int kFlags = TJFLAG_LIMITSCANS;
    if (tjDecompress2(decoder.get(), bytes, encoded.size(),
                      reinterpret_cast<unsigned char*>(image.pixels.data()), width, 0, height,
                      TJPF_RGBA, kFlags) != 0) {
        return std::nullopt;
    }
    return image;
}

}  // namespace ribalta
