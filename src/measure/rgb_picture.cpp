#include "measure/rgb_picture.h"

#include <algorithm>
#include <cmath>

namespace ribalta {
namespace {

bool isFinite(const glm::vec3& color) {
    return std::isfinite(color.x) && std::isfinite(color.y) && std::isfinite(color.z);
}

std::string sizeText(const RgbPicture& picture) {
    return std::to_string(picture.width) + "x" + std::to_string(picture.height);
}

// "R, G, B and the layers beams, transmittance", or the channels where no layer has a red one.
std::string describeLayers(const FloatImage& image) {
    std::string names;
    for (const std::string& channel : image.channels) {
        if (channel.ends_with(".R")) {
            names += (names.empty() ? "" : ", ") + channel.substr(0, channel.size() - 2);
        }
    }
    if (!names.empty()) {
        return "the layers " + names;
    }
    for (const std::string& channel : image.channels) {
        names += (names.empty() ? "" : ", ") + channel;
    }
    return "the channels " + names;
}

}  // namespace

RgbPicture pickLayer(const FloatImage& image, const std::string& layer, const Place& place) {
    const std::string prefix = layer.empty() ? "" : layer + ".";
    int channels[3] = {image.channel(prefix + "R"), image.channel(prefix + "G"),
                       image.channel(prefix + "B")};
    if (layer.empty() && channels[0] < 0 && channels[1] < 0 && channels[2] < 0) {
        std::fill_n(channels, 3, image.channel("Y"));
    }
    if (*std::min_element(channels, channels + 3) < 0) {
        throw Error(ErrorKind::kBadInput, place,
                    (layer.empty() ? "has no channels R, G, B" : "has no layer '" + layer + "'") +
                        "; it has " + describeLayers(image));
    }
    RgbPicture picture{image.width, image.height, {}};
    picture.pixels.reserve(std::size_t(image.width) * std::size_t(image.height));
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            picture.pixels.emplace_back(image.at(x, y, channels[0]), image.at(x, y, channels[1]),
                                        image.at(x, y, channels[2]));
        }
    }
    return picture;
}

void refuseNonFinite(const RgbPicture& picture, const Place& place) {
    const auto bad = [](const glm::vec3& color) { return !isFinite(color); };
    const auto first = std::find_if(picture.pixels.begin(), picture.pixels.end(), bad);
    if (first == picture.pixels.end()) {
        return;
    }
    const auto count = std::count_if(first, picture.pixels.end(), bad);
    const auto index = first - picture.pixels.begin();
    throw Error(ErrorKind::kBadInput, place,
                std::to_string(count) + " of " + std::to_string(picture.pixels.size()) +
                    " pixels hold a NaN or an infinity, the first at " +
                    std::to_string(index % picture.width) + "," +
                    std::to_string(index / picture.width) +
                    " from the top left; no error can be given for them");
}

void refuseOtherSize(const RgbPicture& picture, const RgbPicture& expected, const Place& place) {
    if (picture.width != expected.width || picture.height != expected.height) {
        throw Error(ErrorKind::kBadInput, place,
                    "is " + sizeText(picture) + " pixels, the other picture " + sizeText(expected) +
                        "; draw both at one --size");
    }
}

}  // namespace ribalta
