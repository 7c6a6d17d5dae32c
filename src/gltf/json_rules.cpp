// checkMembers: one rule against one member.
#include "gltf/json_rules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/check.h"
#include "gltf/import.h"
#include "gltf/tally.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;
using Is = JsonRule::Is;
using OnFault = JsonRule::OnFault;

constexpr std::size_t kMostRules = 16;

std::string shown(const json& value) {
    if (value.is_primitive()) {
        const std::string text = value.dump();
        return text.size() > 60 ? text.substr(0, 57) + "..." : text;
    }
    return value.is_array() ? "an array of " + std::to_string(value.size()) : "an object";
}

std::string shown(double number) {
    std::string text = json(number).dump();
    if (text.ends_with(".0")) {
        text.resize(text.size() - 2);
    }
    return text;
}

// Stores 3.0 as 3; false where the value is no integer that fits.
bool makeInteger(json& value) {
    if (value.is_number_unsigned()) {
        return value.get<std::uint64_t>() < (std::uint64_t(1) << 63U);
    }
    if (value.is_number_integer()) {
        return true;
    }
    if (value.is_number_float()) {
        const double number = value.get<double>();
        if (std::floor(number) == number && std::abs(number) <= 9007199254740992.0) {
            value = static_cast<std::int64_t>(number);
            return true;
        }
    }
    return false;
}

void checkInteger(json& value, const JsonRule& rule, const Where& where) {
    if (!makeInteger(value)) {
        throw JsonFault{where.place(), "is " + shown(value) + ", expected an integer"};
    }
    const auto number = value.get<std::int64_t>();
    if (double(number) < rule.low || double(number) > rule.high) {
        throw JsonFault{where.place(),
                        "is " + std::to_string(number) + ", expected " +
                            (std::isinf(rule.high) ? "at least " + shown(rule.low)
                                                   : shown(rule.low) + " to " + shown(rule.high))};
    }
    if (number % rule.multipleOf != 0) {
        throw JsonFault{where.place(), "is " + std::to_string(number) +
                                           ", expected a multiple of " +
                                           std::to_string(rule.multipleOf)};
    }
    if (!rule.values.empty() &&
        std::find(rule.values.begin(), rule.values.end(), number) == rule.values.end()) {
        throw JsonFault{where.place(),
                        "is " + std::to_string(number) + ", which glTF 2.0 does not know"};
    }
}

// How many elements the top-level array has that indices are into.
std::size_t countOf(const json& root, const char* into) {
    const json& target = member(root, into);
    return target.is_array() ? target.size() : 0;
}

void checkIndex(json& value, const char* into, std::size_t count, const Where& where) {
    if (!makeInteger(value)) {
        throw JsonFault{where.place(),
                        "is " + shown(value) + ", expected an index into /" + std::string(into)};
    }
    const auto number = value.get<std::int64_t>();
    if (number < 0 || std::uint64_t(number) >= count) {
        throw JsonFault{where.place(), "is " + std::to_string(number) + ", but the file has " +
                                           counted(count, into)};
    }
}

void checkNumber(json& value, const JsonRule& rule, const Where& where, Report& report) {
    if (!value.is_number()) {
        throw JsonFault{where.place(), "is " + shown(value) + ", expected a number"};
    }
    const double number = value.get<double>();
    const double clamped = std::clamp(number, rule.low, rule.high);
    if (number == clamped) {
        return;
    }
    const std::string what = "is " + shown(value) + ", outside " +
                             (std::isinf(rule.high) ? "of at least " + shown(rule.low)
                                                    : shown(rule.low) + " to " + shown(rule.high));
    if (rule.onFault == OnFault::kError) {
        throw JsonFault{where.place(), what};
    }
    report.repaired(where.place(), what + "; " + shown(clamped) + " is used");
    value = clamped;
}

void checkArrayOf(const json& value, const char* what, const Where& where) {
    if (!value.is_array()) {
        throw JsonFault{where.place(), "is " + shown(value) + ", expected an array of " + what};
    }
}

void checkNumbers(json& value, const JsonRule& rule, const Where& where, Report& report) {
    checkArrayOf(value, "numbers", where);
    if (rule.length != 0 && value.size() != rule.length) {
        throw JsonFault{where.place(), "has " + std::to_string(value.size()) +
                                           " numbers, expected " + std::to_string(rule.length)};
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
        checkNumber(value[i], rule, Where(where, i), report);
    }
}

void checkString(const json& value, const JsonRule& rule, const Where& where) {
    if (!value.is_string()) {
        throw JsonFault{where.place(), "is " + shown(value) + ", expected a string"};
    }
    const auto& text = value.get_ref<const std::string&>();
    if (!rule.words.empty() &&
        std::find(rule.words.begin(), rule.words.end(), text) == rule.words.end()) {
        std::string known;
        for (const std::string_view word : rule.words) {
            known += (known.empty() ? "" : ", ") + std::string(word);
        }
        throw JsonFault{where.place(), "is " + shown(value) + ", expected one of " + known};
    }
}

void checkObject(json& value, const JsonRule& rule, const Where& where, const json& root,
                 Report& report) {
    if (!value.is_object()) {
        throw JsonFault{where.place(), "is " + shown(value) + ", expected an object"};
    }
    checkMembers(value, rule.members, where, root, report);
}

void checkIndexMap(json& value, const char* into, const Where& where, const json& root) {
    if (!value.is_object()) {
        throw JsonFault{where.place(), "is " + shown(value) + ", expected an object"};
    }
    const std::size_t count = countOf(root, into);
    for (auto& [key, index] : value.items()) {
        checkIndex(index, into, count, Where(where, key));
    }
}

void checkValue(json& value, const JsonRule& rule, const Where& where, const json& root,
                Report& report) {
    switch (rule.is) {
        case Is::kNumber:
            return checkNumber(value, rule, where, report);
        case Is::kInteger:
            return checkInteger(value, rule, where);
        case Is::kBool:
            if (!value.is_boolean()) {
                throw JsonFault{where.place(), "is " + shown(value) + ", expected true or false"};
            }
            return;
        case Is::kString:
            return checkString(value, rule, where);
        case Is::kIndex:
            return checkIndex(value, rule.into, countOf(root, rule.into), where);
        case Is::kNumbers:
            return checkNumbers(value, rule, where, report);
        case Is::kObject:
            return checkObject(value, rule, where, root, report);
        case Is::kIndexMap:
            return checkIndexMap(value, rule.into, where, root);
        case Is::kIndices:
        case Is::kIndexMaps:
        case Is::kStrings:
        case Is::kObjects:
            break;
    }
    checkArrayOf(value,
                 rule.is == Is::kObjects || rule.is == Is::kIndexMaps ? "objects"
                 : rule.is == Is::kIndices                            ? "indices"
                                                                      : "strings",
                 where);
    const std::size_t count = rule.is == Is::kIndices ? countOf(root, rule.into) : 0;
    for (std::size_t i = 0; i < value.size(); ++i) {
        const Where here(where, i);
        if (value[i].is_discarded()) {
            continue;  // read already, where no rule had anything to say
        }
        if (rule.is == Is::kObjects) {
            checkObject(value[i], rule, here, root, report);
        } else if (rule.is == Is::kIndices) {
            checkIndex(value[i], rule.into, count, here);
        } else if (rule.is == Is::kIndexMaps) {
            checkIndexMap(value[i], rule.into, here, root);
        } else {
            checkString(value[i], rule, here);
        }
    }
    if (value.empty()) {
        report.hint(where.place(), "is empty; glTF 2.0 asks to leave it out instead");
    }
}

}  // namespace

void checkMembers(json& object, std::span<const JsonRule> rules, const Where& where,
                  const json& root, Report& report) {
    // By rule: what is told follows the rules' order, whatever the members' is.
    std::array<json*, kMostRules> members{};
    CHECK(rules.size() <= members.size());
    for (auto& [key, value] : object.get_ref<json::object_t&>()) {
        for (std::size_t i = 0; i < rules.size(); ++i) {
            if (rules[i].key == key) {
                members[i] = &value;
            }
        }
    }
    for (std::size_t i = 0; i < rules.size(); ++i) {
        const JsonRule& rule = rules[i];
        json* const found = members[i];
        const Where here(where, rule.key);
        try {
            if (found == nullptr) {
                if (rule.required) {
                    throw JsonFault{where.place(), "lacks \"" + std::string(rule.key) +
                                                       "\", which glTF 2.0 requires"};
                }
                continue;
            }
            checkValue(*found, rule, here, root, report);
        } catch (const JsonFault& fault) {
            if (rule.onFault == OnFault::kError) {
                throw;
            }
            report.repaired(fault.place, fault.message + "; the default is used");
            if (found != nullptr) {
                object.erase(std::string(rule.key));
            }
        }
    }
}

}  // namespace ribalta::gltf
