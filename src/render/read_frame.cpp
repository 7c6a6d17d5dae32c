#include "render/read_frame.h"

#include <cmath>
#include <limits>

#include "optics/shader_lib.h"

namespace ribalta {
namespace {

// A texture's level 0 as floats, `channels` a texel, rows from below.
std::vector<float> readFloats(const Texture2D& texture, GLenum format, std::size_t channels) {
    std::vector<float> values(std::size_t(texture.size().width) *
                              std::size_t(texture.size().height) * channels);
    texture.read(format, GL_FLOAT, std::as_writable_bytes(std::span(values)));
    return values;
}

// What the depth texture says of a pixel: metres along the view axis and along its ray.
struct Distance {
    double alongAxis = std::numeric_limits<double>::infinity();
    double alongRay = std::numeric_limits<double>::infinity();
};

Distance distanceOf(const Camera& camera, const glm::dvec2& half, double depth,
                    const glm::dvec2& ndc) {
    if (depth <= 0.0) {
        return {};
    }
    const double n = camera.nearMetres;
    const double f = camera.farMetres;
    if (camera.isOrthographic()) {
        const double distance = f - depth * (f - n);
        return {distance, distance};
    }
    const double distance = std::isinf(f) ? n / depth : n * f / (depth * (f - n) + n);
    const glm::dvec2 slope = ndc * half;
    return {distance, distance * std::sqrt(1.0 + glm::dot(slope, slope))};
}

}  // namespace

FloatImage readFrame(const FramePlan& plan, const FrameTargets& targets,
                     const FrameLayers& layers) {
    const int width = plan.settings.width;
    const int height = plan.settings.height;
    FloatImage image;
    image.width = width;
    image.height = height;
    image.channels = {"R", "G", "B"};
    const auto addLayer = [&](const std::string& name, const char* letters) {
        for (const char* letter = letters; *letter != '\0'; ++letter) {
            image.channels.push_back(name + "." + *letter);
        }
    };
    std::vector<float> beams;
    std::vector<float> normals;
    std::vector<float> depth;
    const std::vector<float> color = readFloats(targets.color, GL_RGB, 3);
    if (layers.beams) {
        addLayer("beams", "RGB");
        beams = readFloats(targets.beams, GL_RGB, 3);
    }
    if (layers.transmittance) {
        addLayer("transmittance", "RGB");
    }
    if (layers.normal) {
        addLayer("normal", "XYZ");
        normals = readFloats(targets.normals, GL_RGB, 3);
    }
    if (layers.depth) {
        image.channels.emplace_back("Z");
    }
    if (layers.depth || layers.transmittance) {
        depth = readFloats(targets.depth, GL_DEPTH_COMPONENT, 1);
    }

    const glm::dvec2 half = viewHalfExtent(plan.camera, width, height);
    const double extinction = plan.settings.haze.extinctionPerMetre();
    const glm::dmat3& worldFromView = plan.camera.frame.worldFromLocal;
    image.values.reserve(std::size_t(width) * std::size_t(height) * image.channels.size());
    const auto appendThree = [&](const std::vector<float>& from, std::size_t texel) {
        image.values.insert(image.values.end(), &from[3 * texel], &from[3 * texel] + 3);
    };
    for (int y = height - 1; y >= 0; --y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t texel = std::size_t(y) * std::size_t(width) + std::size_t(x);
            const glm::dvec2 ndc((2.0 * x + 1.0) / width - 1.0, (2.0 * y + 1.0) / height - 1.0);
            appendThree(color, texel);
            if (layers.beams) {
                appendThree(beams, texel);
            }
            Distance distance;
            if (!depth.empty()) {
                distance = distanceOf(plan.camera, half, double(depth[texel]), ndc);
            }
            if (layers.transmittance) {
                const double left =
                    extinction > 0.0 ? shader::transmittance(extinction, distance.alongRay) : 1.0;
                image.values.insert(image.values.end(), 3, float(left));
            }
            if (layers.normal) {
                const glm::dvec3 view(normals[3 * texel], normals[3 * texel + 1],
                                      normals[3 * texel + 2]);
                const glm::dvec3 world = worldFromView * view;
                for (int c = 0; c < 3; ++c) {
                    image.values.push_back(float(world[c]));
                }
            }
            if (layers.depth) {
                image.values.push_back(float(distance.alongAxis));
            }
        }
    }
    return image;
}

std::vector<std::uint8_t> readDisplay(const FrameTargets& targets) {
    const auto width = std::size_t(targets.display.size().width);
    const auto height = std::size_t(targets.display.size().height);
    std::vector<std::uint8_t> fromBelow(width * height * 3);
    targets.display.read(GL_RGB, GL_UNSIGNED_BYTE, std::as_writable_bytes(std::span(fromBelow)));
    std::vector<std::uint8_t> fromAbove;
    fromAbove.reserve(fromBelow.size());
    for (std::size_t y = height; y-- > 0;) {
        const auto row = fromBelow.begin() + std::ptrdiff_t(y * width * 3);
        fromAbove.insert(fromAbove.end(), row, row + std::ptrdiff_t(width * 3));
    }
    return fromAbove;
}

}  // namespace ribalta
