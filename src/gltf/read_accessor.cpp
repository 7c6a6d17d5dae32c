#include "gltf/read_accessor.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <string>

#include "gltf/bad_input.h"
#include "gltf/read_buffers.h"

namespace ribalta::gltf {
namespace {

// Component types by glTF's numbers (section 3.6.2.2).
enum ComponentType : int {
    kInt8 = 5120,
    kUint8 = 5121,
    kInt16 = 5122,
    kUint16 = 5123,
    kUint32 = 5125,
    kFloat32 = 5126,
};

std::size_t componentBytes(int type) {
    switch (type) {
        case kInt8:
        case kUint8:
            return 1;
        case kInt16:
        case kUint16:
            return 2;
        default:
            return 4;
    }
}

// glTF data is little-endian, and so is every machine this runs on.
template <typename T>
T load(const std::byte* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
}

float loadFloat(const std::byte* bytes, int type, bool normalized) {
    switch (type) {
        case kInt8: {
            const auto value = float(load<std::int8_t>(bytes));
            return normalized ? std::max(value / 127.0F, -1.0F) : value;
        }
        case kUint8: {
            const auto value = float(load<std::uint8_t>(bytes));
            return normalized ? value / 255.0F : value;
        }
        case kInt16: {
            const auto value = float(load<std::int16_t>(bytes));
            return normalized ? std::max(value / 32767.0F, -1.0F) : value;
        }
        case kUint16: {
            const auto value = float(load<std::uint16_t>(bytes));
            return normalized ? value / 65535.0F : value;
        }
        case kUint32:
            return float(load<std::uint32_t>(bytes));
        default:
            return load<float>(bytes);
    }
}

std::uint32_t loadIndex(const std::byte* bytes, int type) {
    switch (type) {
        case kUint8:
            return load<std::uint8_t>(bytes);
        case kUint16:
            return load<std::uint16_t>(bytes);
        default:
            return load<std::uint32_t>(bytes);
    }
}

// Elements at a fixed distance, known to lie inside their buffer view.
struct Elements {
    ViewBytes bytes;
    std::size_t offset = 0;
    std::size_t stride = 0;

    const std::byte* at(std::size_t index) const { return bytes.data() + offset + index * stride; }
};

// `count` elements of `size` bytes, `stride` apart, from `offset` in a buffer view.
Elements locate(const Import& import, std::size_t view, std::size_t offset, std::size_t count,
                std::size_t size, std::size_t stride, const Place& place) {
    ViewBytes bytes = viewBytes(import, view);
    if (stride < size) {
        badInput(place, "has elements of " + std::to_string(size) +
                            " bytes in a buffer view with a stride of " + std::to_string(stride) +
                            "; export the file again");
    }
    // count >= 1; divisions instead of products, which could overflow.
    if (offset > bytes.size() || size > bytes.size() - offset ||
        (bytes.size() - offset - size) / stride < count - 1) {
        badInput(place, "needs " + std::to_string(count) + " elements of " + std::to_string(size) +
                            " bytes, " + std::to_string(stride) + " apart from byte " +
                            std::to_string(offset) + "; its buffer view has " +
                            std::to_string(bytes.size()) + " bytes");
    }
    return {std::move(bytes), offset, stride};
}

// Replaces elements as the accessor's sparse part says.
template <typename Store>
void applySparse(const Import& import, const tinygltf::Accessor& accessor, std::size_t elementBytes,
                 const Place& place, const Store& store) {
    const auto& sparse = accessor.sparse;
    const auto count = std::size_t(sparse.count);
    const Place here = place.at("sparse");
    if (count > accessor.count) {
        badInput(here.at("count"), "is " + std::to_string(count) + ", the accessor has only " +
                                       std::to_string(accessor.count) + " elements");
    }
    const std::size_t indexBytes = componentBytes(sparse.indices.componentType);
    const Elements indices = locate(import, std::size_t(sparse.indices.bufferView),
                                    std::size_t(sparse.indices.byteOffset), count, indexBytes,
                                    indexBytes, here.at("indices"));
    const Elements values =
        locate(import, std::size_t(sparse.values.bufferView), std::size_t(sparse.values.byteOffset),
               count, elementBytes, elementBytes, here.at("values"));
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t target = loadIndex(indices.at(i), sparse.indices.componentType);
        if (target >= accessor.count) {
            badInput(here.at("indices"), "element " + std::to_string(i) + " is " +
                                             std::to_string(target) + ", the accessor has only " +
                                             std::to_string(accessor.count) + " elements");
        }
        store(target, values.at(i));
    }
}

// Calls store(element, bytes) for all of an accessor's elements, sparse replacements last.
// `reserve` is called once, when the count is known to be affordable; it takes four bytes a
// component.
template <typename Reserve, typename Store>
void forEachElement(const Import& import, std::size_t index, int components,
                    const Reserve& reserveAffordable, const Store& store) {
    const tinygltf::Accessor& accessor = import.model.accessors.at(index);
    const Place place = import.file.at("accessors").at(index);
    const std::size_t size = componentBytes(accessor.componentType) * std::size_t(components);
    const auto reserve = [&](std::size_t count) {
        import.budget->takeReads(count, place);
        import.budget->expectVertices(count, place);
        import.budget->expectMemory(4 * std::uint64_t(count) * std::uint64_t(components), place);
        reserveAffordable(count);
    };
    if (accessor.bufferView >= 0) {
        const auto view = std::size_t(accessor.bufferView);
        const std::size_t stride = import.model.bufferViews.at(view).byteStride;
        const Elements elements = locate(import, view, accessor.byteOffset, accessor.count, size,
                                         stride == 0 ? size : stride, place);
        reserve(accessor.count);
        for (std::size_t i = 0; i < accessor.count; ++i) {
            store(i, elements.at(i));
        }
    } else {
        if (accessor.count > kMaxElementsWithoutData) {
            badInput(place, "has " + std::to_string(accessor.count) +
                                " elements and no data; at most " +
                                std::to_string(kMaxElementsWithoutData) + " are read so");
        }
        reserve(accessor.count);
    }
    if (accessor.sparse.isSparse) {
        applySparse(import, accessor, size, place, store);
    }
}

int componentsOf(const tinygltf::Accessor& accessor) {
    switch (accessor.type) {
        case TINYGLTF_TYPE_SCALAR:
            return 1;
        case TINYGLTF_TYPE_VEC2:
            return 2;
        case TINYGLTF_TYPE_VEC3:
            return 3;
        case TINYGLTF_TYPE_VEC4:
            return 4;
        default:
            return 0;
    }
}

template <int N>
std::vector<glm::vec<N, float>> readVectors(const Import& import, std::size_t index,
                                            int components = N, float fill = 0.0F) {
    const tinygltf::Accessor& accessor = import.model.accessors.at(index);
    if (componentsOf(accessor) != components) {
        badInput(import.file.at("accessors").at(index).at("type"),
                 "is not VEC" + std::to_string(components) +
                     ", as its use as a vertex attribute asks; export the file again");
    }
    const std::size_t step = componentBytes(accessor.componentType);
    std::vector<glm::vec<N, float>> result;
    forEachElement(
        import, index, components,
        [&](std::size_t count) { result.assign(count, glm::vec<N, float>(0.0F)); },
        [&](std::size_t element, const std::byte* bytes) {
            glm::vec<N, float>& value = result[element];
            for (int c = 0; c < components; ++c) {
                value[c] = loadFloat(bytes + std::size_t(c) * step, accessor.componentType,
                                     accessor.normalized);
            }
            for (int c = components; c < N; ++c) {
                value[c] = fill;
            }
        });
    return result;
}

}  // namespace

std::vector<float> readScalars(const Import& import, std::size_t index) {
    const tinygltf::Accessor& accessor = import.model.accessors.at(index);
    if (accessor.type != TINYGLTF_TYPE_SCALAR) {
        badInput(import.file.at("accessors").at(index).at("type"),
                 "is not SCALAR, as its use as a list of numbers asks; export the file again");
    }
    std::vector<float> result;
    forEachElement(
        import, index, 1, [&](std::size_t count) { result.assign(count, 0.0F); },
        [&](std::size_t element, const std::byte* bytes) {
            result[element] = loadFloat(bytes, accessor.componentType, accessor.normalized);
        });
    return result;
}

std::vector<glm::vec2> readVec2(const Import& import, std::size_t accessor) {
    return readVectors<2>(import, accessor);
}

std::vector<glm::vec3> readVec3(const Import& import, std::size_t accessor) {
    return readVectors<3>(import, accessor);
}

std::vector<glm::vec4> readVec4(const Import& import, std::size_t accessor) {
    return readVectors<4>(import, accessor);
}

std::vector<glm::mat4> readMat4(const Import& import, std::size_t index) {
    const tinygltf::Accessor& accessor = import.model.accessors.at(index);
    if (accessor.type != TINYGLTF_TYPE_MAT4 || accessor.componentType != kFloat32) {
        badInput(import.file.at("accessors").at(index),
                 "does not hold MAT4 of floats, as inverse bind matrices are; export the file "
                 "again");
    }
    std::vector<glm::mat4> result;
    forEachElement(
        import, index, 16, [&](std::size_t count) { result.assign(count, glm::mat4(0.0F)); },
        [&](std::size_t element, const std::byte* bytes) {
            for (int i = 0; i < 16; ++i) {
                result[element][i / 4][i % 4] = load<float>(bytes + std::size_t(i) * 4);
            }
        });
    return result;
}

std::vector<glm::vec4> readColors(const Import& import, std::size_t accessor) {
    const int components = componentsOf(import.model.accessors.at(accessor));
    return readVectors<4>(import, accessor, components == 3 ? 3 : 4, 1.0F);
}

std::vector<std::uint32_t> readIndices(const Import& import, std::size_t index) {
    const tinygltf::Accessor& accessor = import.model.accessors.at(index);
    const Place place = import.file.at("accessors").at(index);
    const int type = accessor.componentType;
    if (accessor.type != TINYGLTF_TYPE_SCALAR ||
        (type != kUint8 && type != kUint16 && type != kUint32)) {
        badInput(place,
                 "holds no unsigned integer scalars, as its use as indices asks; export "
                 "the file again");
    }
    std::vector<std::uint32_t> result;
    forEachElement(
        import, index, 1, [&](std::size_t count) { result.assign(count, 0); },
        [&](std::size_t element, const std::byte* bytes) {
            result[element] = loadIndex(bytes, type);
        });
    return result;
}

}  // namespace ribalta::gltf
