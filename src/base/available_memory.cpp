#include "base/available_memory.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <string>

namespace ribalta {
namespace {

constexpr const char* kGroup = "/sys/fs/cgroup/";

/// By name, of lines "NAME NUMBER", whatever follows the number.
std::map<std::string, std::uint64_t> numbersIn(const std::string& file) {
    std::ifstream stream(file);
    std::map<std::string, std::uint64_t> numbers;
    std::string name;
    std::uint64_t number = 0;
    std::string rest;
    while (stream >> name >> number && std::getline(stream, rest)) {
        numbers[name] = number;
    }
    return numbers;
}

std::optional<std::uint64_t> numberIn(const std::string& file) {
    std::ifstream stream(file);
    std::uint64_t number = 0;
    return stream >> number ? std::optional(number) : std::nullopt;
}

// Linux: a line "MemAvailable:  123 kB".
std::optional<std::uint64_t> memoryOfSystem() {
    const std::map<std::string, std::uint64_t> numbers = numbersIn("/proc/meminfo");
    const auto found = numbers.find("MemAvailable:");
    return found != numbers.end() ? std::optional(found->second * 1024) : std::nullopt;
}

// Linux, control groups of version 2, as containers see them. Without a limit it says "max", which
// is no number. What is kept of files is given back where it is wanted.
std::optional<std::uint64_t> memoryOfGroup() {
    const std::optional<std::uint64_t> limit = numberIn(std::string(kGroup) + "memory.max");
    const std::optional<std::uint64_t> used = numberIn(std::string(kGroup) + "memory.current");
    if (!limit || !used) {
        return std::nullopt;
    }
    std::map<std::string, std::uint64_t> parts = numbersIn(std::string(kGroup) + "memory.stat");
    const std::uint64_t ofFiles = parts["inactive_file"] + parts["active_file"];
    return *limit - std::min(*limit, *used - std::min(*used, ofFiles));
}

}  // namespace

std::optional<std::uint64_t> availableMemory() {
    const std::optional<std::uint64_t> system = memoryOfSystem();
    const std::optional<std::uint64_t> group = memoryOfGroup();
    return system && group ? std::min(system, group) : system ? system : group;
}

}  // namespace ribalta
