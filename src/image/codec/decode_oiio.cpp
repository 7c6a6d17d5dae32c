#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "image/codec/decode.h"
#include "image/codec/encode.h"

namespace ribalta {
namespace {

using OIIO::ImageInput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

const char* formatName(ImageFormat format) {
    switch (format) {
        case ImageFormat::kPng:
            return "png";
        case ImageFormat::kJpeg:
            return "jpeg";
        case ImageFormat::kTiff:
            return "tiff";
        case ImageFormat::kOpenExr:
            return "openexr";
        case ImageFormat::kHdr:
            return "hdr";
        case ImageFormat::kWebp:
        case ImageFormat::kUnknown:
            break;
    }
    throw std::runtime_error("is of a format that is not decoded here");
}

// OpenImageIO's own words, in one line, behind ours.
[[noreturn]] void broken(ImageFormat format, const std::string& why) {
    std::string line = std::string("is a broken or truncated ") + formatName(format) + " picture";
    if (!why.empty()) {
        line += " (" + why.substr(0, why.find_last_not_of(" \n.") + 1) + ")";
    }
    throw std::runtime_error(line + "; save it anew");
}

/// An open picture in memory. The reader stands before the input that reads through it.
struct OpenPicture {
    ImageFormat format;
    OIIO::Filesystem::IOMemReader reader;
    std::unique_ptr<ImageInput> input;
    ImageSpec spec;

    OpenPicture(std::span<const std::byte> encoded, ImageFormat fileFormat)
        : format(fileFormat), reader(const_cast<std::byte*>(encoded.data()), encoded.size()) {
        input = ImageInput::create(formatName(format));
        if (!input) {
            throw std::runtime_error(std::string("cannot be decoded: this OpenImageIO has no ") +
                                     formatName(format) + " reader");
        }
        // Passed beside a config the proxy would be ignored: it has to stand in it.
        OIIO::Filesystem::IOProxy* proxy = &reader;
        ImageSpec config;
        config.attribute("oiio:ioproxy", TypeDesc::PTR, &proxy);
        config.attribute("oiio:UnassociatedAlpha", 1);
        if (!input->open(formatName(format), spec, config)) {
            broken(format, input->geterror());
        }
        if (spec.deep || spec.depth > 1) {
            throw std::runtime_error("is a deep or volume picture; expected a flat one");
        }
        checkLayout();
    }

    // Readers take memory for whole tiles and for rows of all channels, whatever is asked for.
    void checkLayout() const {
        constexpr int kMostChannels = 1024;
        constexpr int kLargestTile = 8192;
        if (spec.nchannels > kMostChannels) {
            throw std::runtime_error("has " + std::to_string(spec.nchannels) +
                                     " channels, over the limit of " +
                                     std::to_string(kMostChannels) + "; save it with fewer");
        }
        if (spec.tile_width > kLargestTile || spec.tile_height > kLargestTile ||
            std::int64_t(spec.tile_width) * spec.tile_height * spec.nchannels > (1 << 28)) {
            throw std::runtime_error("has tiles of " + std::to_string(spec.tile_width) + " x " +
                                     std::to_string(spec.tile_height) +
                                     " pixels, which are too large; save it without tiles");
        }
    }
};

/// Which of the file's channels are red, green, blue and alpha; equal ones are grey, -1 is opaque.
struct ColourChannels {
    std::array<int, 4> index{0, 0, 0, -1};

    int first() const { return std::min({index[0], index[1], index[2], alphaOr(index[0])}); }
    int last() const { return std::max({index[0], index[1], index[2], index[3]}); }
    int alphaOr(int other) const { return index[3] < 0 ? other : index[3]; }
};

ColourChannels colourChannels(const ImageSpec& spec) {
    ColourChannels result;
    const int red = spec.channelindex("R");
    const int green = spec.channelindex("G");
    const int blue = spec.channelindex("B");
    const int grey = spec.channelindex("Y");
    if (red >= 0 && green >= 0 && blue >= 0) {
        result.index = {red, green, blue, spec.channelindex("A")};
    } else if (grey >= 0) {
        result.index = {grey, grey, grey, spec.channelindex("A")};
    } else if (spec.nchannels >= 3) {
        result.index = {0, 1, 2, spec.alpha_channel};
    } else {
        result.index = {0, 0, 0, spec.alpha_channel};
    }
    return result;
}

template <typename T>
std::vector<T> readChannels(OpenPicture& picture, TypeDesc type, int first, int end,
                            const ImageLimits& limits) {
    const ImageSpec& spec = picture.spec;
    const std::uint64_t pixels = std::uint64_t(spec.width) * std::uint64_t(spec.height);
    if (std::uint64_t(end - first) > std::max<std::uint64_t>(4, 4 * limits.maxPixels / pixels)) {
        throw std::runtime_error("has too many channels (" + std::to_string(spec.nchannels) +
                                 ") for its size");
    }
    std::vector<T> values(std::size_t(pixels) * std::size_t(end - first));
    if (!picture.input->read_image(0, 0, first, end, type, values.data())) {
        broken(picture.format, picture.input->geterror());
    }
    return values;
}

/// One row-major picture of four channels, spread from whatever the file has.
template <typename T>
std::vector<T> spreadToRgba(const std::vector<T>& source, std::size_t pixels, int channelCount,
                            const ColourChannels& channels, T opaque) {
    std::vector<T> rgba(pixels * 4);
    for (std::size_t i = 0; i < pixels; ++i) {
        const T* from = &source[i * std::size_t(channelCount)];
        for (std::size_t c = 0; c < 4; ++c) {
            rgba[4 * i + c] = channels.index[c] < 0 ? opaque : from[channels.index[c]];
        }
    }
    return rgba;
}

template <typename T>
void divideByAlpha(std::span<T> rgba, T opaque) {
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        const T alpha = rgba[i + 3];
        if (!(alpha > T(0)) || alpha == opaque) {
            continue;
        }
        for (std::size_t c = 0; c < 3; ++c) {
            if constexpr (std::is_floating_point_v<T>) {
                rgba[i + c] /= alpha;
            } else {
                const std::uint32_t scaled = std::uint32_t(rgba[i + c]) * opaque + alpha / 2;
                rgba[i + c] = T(std::min<std::uint32_t>(scaled / alpha, opaque));
            }
        }
    }
}

template <typename T>
std::vector<T> readRgba(OpenPicture& picture, TypeDesc type, const ImageLimits& limits, T opaque) {
    ColourChannels channels = colourChannels(picture.spec);
    const int first = channels.first();
    const int end = channels.last() + 1;
    const std::vector<T> source = readChannels<T>(picture, type, first, end, limits);
    for (int& index : channels.index) {
        index = index < 0 ? index : index - first;
    }
    const std::size_t pixels = std::size_t(picture.spec.width) * std::size_t(picture.spec.height);
    std::vector<T> rgba = spreadToRgba(source, pixels, end - first, channels, opaque);
    const bool premultiplied =
        channels.index[3] >= 0 && picture.spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0;
    if (premultiplied) {
        divideByAlpha(std::span(rgba), opaque);
    }
    return rgba;
}

// Red, green, blue and perhaps alpha as they stand in the file, as most do, go straight to where
// they stay: large pictures would else be in memory three times.
std::optional<RawBytes> readInPlace(OpenPicture& picture) {
    const ColourChannels channels = colourChannels(picture.spec);
    const auto [red, green, blue, alpha] = channels.index;
    const bool isPremultiplied = picture.spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0;
    if (green != red + 1 || blue != red + 2 || (alpha >= 0 && alpha != red + 3) ||
        (alpha >= 0 && isPremultiplied)) {
        return std::nullopt;
    }
    const std::size_t pixels = std::size_t(picture.spec.width) * std::size_t(picture.spec.height);
    RawBytes rgba(pixels * 4, std::byte(255));
    if (!picture.input->read_image(0, 0, red, channels.last() + 1, TypeDesc::UINT8, rgba.data(),
                                   4)) {
        broken(picture.format, picture.input->geterror());
    }
    return rgba;
}

// Light that is infinite or no number would spread over the whole picture.
void makeFinite(std::vector<float>& values) {
    constexpr float kLargestHalf = 65504.0F;
    for (float& value : values) {
        if (std::isnan(value)) {
            value = 0.0F;
        } else if (std::isinf(value)) {
            value = value > 0.0F ? kLargestHalf : 0.0F;
        }
    }
}

// An EXR may store only a part of its picture, or more than that: the display window is what was
// framed, and what is not stored is transparent black.
std::vector<float> intoDisplayWindow(const std::vector<float>& stored, const ImageSpec& spec) {
    std::vector<float> framed(std::size_t(spec.full_width) * std::size_t(spec.full_height) * 4);
    const int left = std::max(spec.x, spec.full_x);
    const int right = std::min(spec.x + spec.width, spec.full_x + spec.full_width);
    const int top = std::max(spec.y, spec.full_y);
    const int bottom = std::min(spec.y + spec.height, spec.full_y + spec.full_height);
    for (int y = top; y < bottom && left < right; ++y) {
        const std::size_t from =
            std::size_t(y - spec.y) * std::size_t(spec.width) + std::size_t(left - spec.x);
        const std::size_t to = std::size_t(y - spec.full_y) * std::size_t(spec.full_width) +
                               std::size_t(left - spec.full_x);
        std::copy_n(stored.begin() + std::ptrdiff_t(from * 4), std::size_t(right - left) * 4,
                    framed.begin() + std::ptrdiff_t(to * 4));
    }
    return framed;
}

template <typename T>
RawBytes asBytes(const std::vector<T>& values) {
    return RawBytes(std::as_bytes(std::span(values)));
}

}  // namespace

void checkSize(std::int64_t width, std::int64_t height, const ImageLimits& limits) {
    const std::string fault = sizeFault(width, height, limits);
    if (!fault.empty()) {
        throw std::runtime_error(fault);
    }
}

Image decodeWithOiio(std::span<const std::byte> encoded, ImageFormat format,
                     const ImageLimits& limits) {
    OpenPicture picture(encoded, format);
    const ImageSpec& spec = picture.spec;
    checkSize(spec.width, spec.height, limits);
    Image image;
    image.width = spec.width;
    image.height = spec.height;
    if (spec.format.is_floating_point()) {
        image.type = Image::Type::kFloat32;
        std::vector<float> rgba = readRgba<float>(picture, TypeDesc::FLOAT, limits, 1.0F);
        makeFinite(rgba);
        const bool windowed = spec.x != spec.full_x || spec.y != spec.full_y ||
                              spec.width != spec.full_width || spec.height != spec.full_height;
        if (format == ImageFormat::kOpenExr && windowed) {
            checkSize(spec.full_width, spec.full_height, limits);
            rgba = intoDisplayWindow(rgba, spec);
            image.width = spec.full_width;
            image.height = spec.full_height;
        }
        image.pixels = asBytes(rgba);
    } else if (spec.format.size() == 1) {
        if (auto inPlace = readInPlace(picture)) {
            image.pixels = std::move(*inPlace);
        } else {
            image.pixels = asBytes(readRgba<std::uint8_t>(picture, TypeDesc::UINT8, limits, 255));
        }
    } else {
        const auto wide = readRgba<std::uint16_t>(picture, TypeDesc::UINT16, limits, 65535);
        image.pixels = RawBytes(wide.size());
        std::transform(wide.begin(), wide.end(), image.pixels.begin(), [](std::uint16_t value) {
            return std::byte((std::uint32_t(value) * 255 + 32767) / 65535);
        });
    }
    return image;
}

FloatImage decodeFloatWithOiio(std::span<const std::byte> encoded, ImageFormat format,
                               const ImageLimits& limits) {
    OpenPicture picture(encoded, format);
    const ImageSpec& spec = picture.spec;
    checkSize(spec.width, spec.height, limits);
    FloatImage image;
    image.width = spec.width;
    image.height = spec.height;
    image.channels = spec.channelnames;
    image.values = readChannels<float>(picture, TypeDesc::FLOAT, 0, spec.nchannels, limits);
    for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
        const std::string name = attribute.name().string();
        if (!name.starts_with(kFactPrefix)) {
            continue;
        }
        const std::string fact = name.substr(std::string_view(kFactPrefix).size());
        if (attribute.type() == TypeDesc::STRING) {
            image.facts.emplace(fact, attribute.get_string());
        } else if (attribute.type() == TypeDesc::DOUBLE) {
            image.facts.emplace(fact, attribute.get<double>());
        }
    }
    return image;
}

}  // namespace ribalta
