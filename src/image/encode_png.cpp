#include "image/encode_png.h"

#include <csetjmp>
#include <cstddef>
#include <new>
#include <string>
#include <utility>

#include <png.h>

namespace ribalta {
namespace {

// Of zlib's 1 to 9. With 6 a frame takes two and a half times as long and is a twelfth smaller.
constexpr int kCompression = 4;

// What libpng's calls share. Their memory is theirs to free, whichever way they end.
struct Writing {
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::vector<unsigned char> bytes{};
    std::string wrong{};

    Writing() = default;
    ~Writing() { png_destroy_write_struct(&png, &info); }
    Writing(const Writing&) = delete;
    Writing& operator=(const Writing&) = delete;
};

[[noreturn]] void onError(png_structp png, png_const_charp message) {
    static_cast<Writing*>(png_get_error_ptr(png))->wrong = message;
    png_longjmp(png, 1);
}

void onWarning(png_structp /*png*/, png_const_charp /*message*/) {}

void append(png_structp png, png_bytep bytes, std::size_t count) {
    auto& writing = *static_cast<Writing*>(png_get_io_ptr(png));
    try {
        writing.bytes.insert(writing.bytes.end(), bytes, bytes + count);
    } catch (const std::bad_alloc&) {
        png_error(png, "out of memory");
    }
}

// False where libpng jumped out: nothing with a destructor may live in here.
bool writeAll(Writing& writing, int width, int height, const std::uint8_t* rgb) {
    if (setjmp(png_jmpbuf(writing.png)) != 0) {
        return false;
    }
    png_set_write_fn(writing.png, &writing, append, nullptr);
    png_set_IHDR(writing.png, writing.info, png_uint_32(width), png_uint_32(height), 8,
                 PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(writing.png, writing.info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_compression_level(writing.png, kCompression);
    png_set_filter(writing.png, PNG_FILTER_TYPE_BASE, PNG_ALL_FILTERS);
    png_write_info(writing.png, writing.info);
    for (int y = 0; y < height; ++y) {
        png_write_row(writing.png, rgb + std::size_t(y) * std::size_t(width) * 3);
    }
    png_write_end(writing.png, writing.info);
    return true;
}

}  // namespace

std::string encodePng(int width, int height, std::span<const std::uint8_t> rgb,
                      std::vector<unsigned char>& result) {
    Writing writing;
    writing.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &writing, onError, onWarning);
    writing.info = writing.png == nullptr ? nullptr : png_create_info_struct(writing.png);
    if (writing.info == nullptr) {
        return "does not fit into memory; scale it down";
    }
    if (!writeAll(writing, width, height, rgb.data())) {
        return "cannot be encoded: " + writing.wrong;
    }
    result = std::move(writing.bytes);
    return "";
}

}  // namespace ribalta
