// Names: values that people know by a word, each listed with its word in one table.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/check.h"

namespace ribalta {

template <typename Value>
struct Named {
    Value value;
    std::string_view name;
};

/// The word of a value, which must be in the table.
template <typename Value>
std::string_view nameIn(std::span<const Named<Value>> table, const Value& value) {
    const auto found = std::find_if(table.begin(), table.end(),
                                    [&](const Named<Value>& each) { return each.value == value; });
    CHECK(found != table.end());
    return found->name;
}

/// The value of a word; none: the table has no such word.
template <typename Value>
std::optional<Value> valueIn(std::span<const Named<Value>> table, std::string_view name) {
    for (const Named<Value>& each : table) {
        if (each.name == name) {
            return each.value;
        }
    }
    return std::nullopt;
}

/// All words of a table.
template <typename Value>
std::string listOf(std::span<const Named<Value>> table, std::string_view separator = ", ") {
    std::string list;
    for (const Named<Value>& each : table) {
        list += list.empty() ? std::string_view() : separator;
        list += each.name;
    }
    return list;
}

}  // namespace ribalta
