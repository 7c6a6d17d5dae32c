#include "gltf/plain_nodes.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include <simdjson.h>

namespace ribalta::gltf {
namespace {

namespace dom = simdjson::dom;

template <typename T>
bool isRead(const dom::element& value, T& into) {
    return value.get(into) == simdjson::SUCCESS;
}

// An array at the document's top, where it has that once.
std::optional<dom::array> arrayOf(const dom::element& document, std::string_view key) {
    std::optional<dom::array> found;
    for (const auto& [name, value] : dom::object(document)) {
        dom::array array;
        if (name == key) {
            if (found || !isRead(value, array)) {
                return std::nullopt;
            }
            found = array;
        }
    }
    return found;
}

std::size_t countOf(const dom::element& document, std::string_view key) {
    const std::optional<dom::array> array = arrayOf(document, key);
    return array ? array->size() : 0;
}

class PlainReader {
  public:
    PlainReader(const dom::element& document, std::pmr::memory_resource& memory)
        : nodes_(countOf(document, "nodes")),
          meshes_(countOf(document, "meshes")),
          cameras_(countOf(document, "cameras")),
          memory_(memory) {}

    /// Of a node that is left to the tree nothing is read.
    JsonShare read(const dom::element& value, FileNode& node) const {
        dom::object object;
        if (!isRead(value, object)) {
            return JsonShare::kAll;
        }
        JsonShare left = JsonShare::kNone;
        for (const auto& [key, each] : object) {
            const std::optional<bool> isGood = readMember(key, each, node);
            if (isGood == false) {
                node = FileNode();
                return JsonShare::kAll;
            }
            if (!isGood && key != "extras") {  // which are read of lamps alone
                left = JsonShare::kOthers;
            }
        }
        return left;
    }

  private:
    // Whether the member keeps its rule; none where it is no plain one.
    std::optional<bool> readMember(std::string_view key, const dom::element& value,
                                   FileNode& node) const {
        if (key == "name") {
            return readName(value, node.name);
        }
        if (key == "children") {
            return readChildren(value, node.children);
        }
        if (key == "matrix") {
            return readNumbers(value, 16, node.matrix);
        }
        if (key == "translation") {
            return readNumbers(value, 3, node.translation);
        }
        if (key == "rotation") {
            return readNumbers(value, 4, node.rotation);
        }
        if (key == "scale") {
            return readNumbers(value, 3, node.scale);
        }
        if (key == "mesh") {
            return readIndex(value, meshes_, node.mesh);
        }
        if (key == "camera") {
            return readIndex(value, cameras_, node.camera);
        }
        return std::nullopt;
    }

    bool readName(const dom::element& value, std::string_view& name) const {
        if (!isRead(value, name)) {
            return false;
        }
        const std::span<char> text = roomFor<char>(name.size(), memory_);
        std::copy(name.begin(), name.end(), text.begin());
        name = {text.data(), text.size()};
        return true;
    }

    static bool readIndex(const dom::element& value, std::size_t count, int& index) {
        std::uint64_t number = 0;
        if (!isRead(value, number) || number >= count) {
            return false;
        }
        index = int(number);
        return true;
    }

    bool readChildren(const dom::element& value, std::span<int>& children) const {
        dom::array array;
        if (!isRead(value, array) || array.size() == 0) {
            return false;
        }
        children = roomFor<int>(array.size(), memory_);
        return readEach(array, children, [&](const dom::element& each, int& child) {
            return readIndex(each, nodes_, child);
        });
    }

    bool readNumbers(const dom::element& value, std::size_t length,
                     std::span<const double>& numbers) const {
        dom::array array;
        if (!isRead(value, array) || array.size() != length) {
            return false;
        }
        const std::span<double> room = roomFor<double>(length, memory_);
        numbers = room;
        return readEach(array, room, isRead<double>);
    }

    template <typename T, typename ReadOne>
    static bool readEach(const dom::array& array, std::span<T> list, const ReadOne& readOne) {
        std::size_t i = 0;
        for (const dom::element& each : array) {
            if (i == list.size() || !readOne(each, list[i++])) {
                return false;
            }
        }
        return true;
    }

    std::size_t nodes_;
    std::size_t meshes_;
    std::size_t cameras_;
    std::pmr::memory_resource& memory_;
};

}  // namespace

std::span<const std::string_view> plainMembers() {
    static constexpr std::string_view kMembers[] = {
        "name", "children", "matrix", "translation", "rotation", "scale", "mesh", "camera",
    };
    return kMembers;
}

std::vector<JsonShare> readPlainNodes(const dom::element& document,
                                      const std::function<void(std::size_t)>& expect,
                                      std::pmr::memory_resource& memory,
                                      std::vector<FileNode>& nodes) {
    std::vector<JsonShare> left;
    const std::optional<dom::array> array = arrayOf(document, "nodes");
    if (!array) {
        return left;
    }
    expect(array->size());
    nodes.reserve(array->size());
    const PlainReader reader(document, memory);
    for (const dom::element& each : *array) {
        left.push_back(reader.read(each, nodes.emplace_back()));
    }
    return left;
}

}  // namespace ribalta::gltf
