// Target: what is done with a picture before a library sees it.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "image/claimed_size.h"
#include "image/essential_chunks.h"
#include "image/image_format.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ribalta;
    const auto bytes = std::as_bytes(std::span(data, size));
    const ImageFormat format = imageFormat(bytes);
    if (describeUnknownImage(bytes).empty()) {
        std::abort();
    }
    const EssentialChunks essential = essentialChunks(bytes, format);
    if (essential.wrong.empty() && !essential.encoded.empty() &&
        (essential.encoded.size() > size || imageFormat(essential.encoded) != format)) {
        std::abort();
    }
    const auto claimed = claimedSize(bytes, format);
    return claimed && claimed->bytesPerPixel <= 0 ? -1 : 0;
}
