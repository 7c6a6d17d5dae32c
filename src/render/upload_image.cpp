#include "render/upload_image.h"

#include <algorithm>
#include <cstring>

#include "base/log.h"
#include "gl/framebuffer.h"

namespace ribalta {
namespace {

// The mean of each 2 x 2 pixels; an odd last row or column is left out.
template <typename Channel>
void halveChannels(const Image& image, Image& half) {
    const auto* from = reinterpret_cast<const Channel*>(image.pixels.data());
    auto* to = reinterpret_cast<Channel*>(half.pixels.data());
    const int down = image.height > 1 ? 1 : 0;
    const int right = image.width > 1 ? 1 : 0;
    const auto texel = [&](int x, int y, int c) {
        return float(from[(std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * 4 +
                          std::size_t(c)]);
    };
    for (int y = 0; y < half.height; ++y) {
        for (int x = 0; x < half.width; ++x) {
            for (int c = 0; c < 4; ++c) {
                const float sum = texel(2 * x, 2 * y, c) + texel(2 * x + right, 2 * y, c) +
                                  texel(2 * x, 2 * y + down, c) +
                                  texel(2 * x + right, 2 * y + down, c);
                *to++ = Channel(0.25F * sum);
            }
        }
    }
}

Image halved(const Image& image) {
    Image half;
    half.name = image.name;
    half.type = image.type;
    half.width = std::max(1, image.width / 2);
    half.height = std::max(1, image.height / 2);
    half.pixels =
        RawBytes(std::size_t(half.width) * std::size_t(half.height) * half.bytesPerPixel());
    if (image.type == Image::Type::kUint8) {
        halveChannels<std::uint8_t>(image, half);
    } else {
        halveChannels<float>(image, half);
    }
    return half;
}

GLenum pixelTypeOf(const Image& image) {
    return image.type == Image::Type::kUint8 ? GL_UNSIGNED_BYTE : GL_FLOAT;
}

}  // namespace

Texture2D uploadImage(const Image& image, bool colors) {
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (image.width > limit || image.height > limit) {
        logWarning("image '" + image.name + "' is larger than this OpenGL's limit of " +
                   std::to_string(limit) + " pixels and is halved");
        return uploadImage(halved(image), colors);
    }
    const bool bytes = image.type == Image::Type::kUint8;
    const GLenum format = bytes ? (colors ? GL_SRGB8_ALPHA8 : GL_RGBA8) : GL_RGBA16F;
    Texture2D texture(
        image.name.empty() ? "image" : image.name, format,
        {image.width, image.height, 0, Texture2D::fullLevels(image.width, image.height)});
    texture.write(0, pixelTypeOf(image), image.pixels.data());
    texture.makeMipmaps();
    texture.setSampling(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_REPEAT, GL_REPEAT);
    return texture;
}

Texture2D uploadSquareLayers(const std::string& label, const std::vector<const Image*>& images) {
    int side = 1;
    bool floats = false;
    for (const Image* image : images) {
        side = std::max({side, image->width, image->height});
        floats = floats || image->type == Image::Type::kFloat32;
    }
    side = std::min(side, kMaxLayerSide);

    Texture2D layers(label, floats ? GL_RGBA16F : GL_SRGB8_ALPHA8,
                     {side, side, int(images.size()), Texture2D::fullLevels(side, side)});
    // Filtering between sizes happens on light, not on encoded values.
    glEnable(GL_FRAMEBUFFER_SRGB);
    GLuint framebuffers[2];
    glCreateFramebuffers(2, framebuffers);
    for (std::size_t i = 0; i < images.size(); ++i) {
        const Image& image = *images[i];
        if (image.width == side && image.height == side &&
            (image.type == Image::Type::kFloat32) == floats) {
            layers.write(int(i), pixelTypeOf(image), image.pixels.data());
            continue;
        }
        const Texture2D source = uploadImage(image, true);
        // From the smallest level that is not smaller than the layer.
        int level = 0;
        while (std::max(source.size().width, source.size().height) >> (level + 1) >= side) {
            ++level;
        }
        glNamedFramebufferTexture(framebuffers[0], GL_COLOR_ATTACHMENT0, source.name(), level);
        glNamedFramebufferTextureLayer(framebuffers[1], GL_COLOR_ATTACHMENT0, layers.name(), 0,
                                       GLint(i));
        glBlitNamedFramebuffer(framebuffers[0], framebuffers[1], 0, 0,
                               std::max(1, source.size().width >> level),
                               std::max(1, source.size().height >> level), 0, 0, side, side,
                               GL_COLOR_BUFFER_BIT, GL_LINEAR);
    }
    glDeleteFramebuffers(2, framebuffers);
    glDisable(GL_FRAMEBUFFER_SRGB);
    layers.makeMipmaps();
    layers.setSampling(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE);
    return layers;
}

}  // namespace ribalta
