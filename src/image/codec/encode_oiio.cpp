#include <memory>
#include <stdexcept>
#include <variant>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "image/codec/encode.h"

namespace ribalta {
namespace {

using OIIO::ImageOutput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

std::vector<unsigned char> encode(const char* format, ImageSpec spec, const TypeDesc& type,
                                  const void* values) {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput sink(bytes);
    OIIO::Filesystem::IOProxy* proxy = &sink;
    spec.attribute("oiio:ioproxy", TypeDesc::PTR, &proxy);
    const std::unique_ptr<ImageOutput> output = ImageOutput::create(format);
    if (!output) {
        throw std::runtime_error(std::string("cannot be encoded: this OpenImageIO has no ") +
                                 format + " writer");
    }
    if (!output->open(format, spec) || !output->write_image(type, values) || !output->close()) {
        throw std::runtime_error("cannot be encoded: " + output->geterror());
    }
    return bytes;
}

}  // namespace

std::vector<unsigned char> encodeExr(const FloatImage& image) {
    ImageSpec spec(image.width, image.height, static_cast<int>(image.channels.size()),
                   TypeDesc::FLOAT);
    spec.channelnames = image.channels;
    spec.attribute("compression", "zip");
    for (const auto& [name, fact] : image.facts) {
        if (const auto* number = std::get_if<double>(&fact)) {
            spec.attribute(kFactPrefix + name, TypeDesc::DOUBLE, number);
        } else {
            spec.attribute(kFactPrefix + name, std::get<std::string>(fact));
        }
    }
    return encode("openexr", spec, TypeDesc::FLOAT, image.values.data());
}

}  // namespace ribalta
