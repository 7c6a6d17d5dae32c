// Image: decoded pixels in memory. No file formats, no graphics API.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "base/raw_bytes.h"

namespace ribalta {

/// A decoded picture for textures and light maps. Always four channels (R, G, B, A; grey is
/// spread, a missing alpha is opaque), rows from the top, alpha not premultiplied.
struct Image {
    /// How one channel is held.
    enum class Type {
        kUint8,    ///< 0..255; colours sRGB-encoded unless the file format is linear
        kFloat32,  ///< scene-linear, from EXR, HDR and other float formats
    };

    std::string name;  ///< for messages: the file's name or the glTF image's
    int width = 0;     ///< pixels
    int height = 0;    ///< pixels
    Type type = Type::kUint8;
    RawBytes pixels;  ///< width * height * 4 channels, tightly packed

    std::size_t bytesPerPixel() const { return type == Type::kUint8 ? 4 : 16; }
};

/// What a picture says of itself: printable text, or a number, which keeps all its digits.
using ImageFact = std::variant<std::string, double>;

/// Float channels with names of their own, as in an EXR: pictures that are measured or written.
struct FloatImage {
    int width = 0;
    int height = 0;
    std::vector<std::string> channels;         ///< e.g. R, G, B, beams.R, Z
    std::vector<float> values;                 ///< rows from the top, channels interleaved
    std::map<std::string, ImageFact> facts{};  ///< by name; an EXR keeps them

    /// Index of a channel by name, or -1.
    int channel(const std::string& name) const;
    float at(int x, int y, int channel) const {
        const std::size_t pixel = std::size_t(y) * std::size_t(width) + std::size_t(x);
        return values[pixel * channels.size() + std::size_t(channel)];
    }
};

/// A checkerboard of magenta and black that no one takes for the real picture: the visible
/// stand-in for an image that is missing or broken.
Image makeStandInImage(const std::string& name);

}  // namespace ribalta
