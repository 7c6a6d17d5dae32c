#include "look/json_object.h"

#include <cmath>
#include <utility>

namespace ribalta {
namespace {

using nlohmann::json;

std::string shown(const json& value) {
    constexpr std::size_t kLongest = 60;
    const std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
    return text.size() <= kLongest ? text : text.substr(0, kLongest) + "...";
}

std::string shown(double number) {
    std::string text = json(number).dump();
    if (text.ends_with(".0")) {
        text.resize(text.size() - 2);
    }
    return text;
}

[[noreturn]] void refuse(const Place& place, const json& value, const std::string& expected) {
    throw Error(ErrorKind::kBadInput, place, "is " + shown(value) + ", expected " + expected);
}

double numberIn(const json& value, const Place& place, double low, double high) {
    const double number = value.is_number() ? value.get<double>() : low;
    if (!value.is_number() || !std::isfinite(number) || number < low || number > high) {
        refuse(place, value, "a number in " + shown(low) + " .. " + shown(high));
    }
    return number;
}

}  // namespace

JsonObject::JsonObject(const json& value, Place place) : value_(&value), place_(std::move(place)) {
    if (!value.is_object()) {
        refuse(place_, value, "an object");
    }
}

const json* JsonObject::find(const std::string& key) {
    known_.insert(key);
    const auto found = value_->find(key);
    return found == value_->end() ? nullptr : &*found;
}

std::optional<double> JsonObject::number(const std::string& key, double low, double high) {
    const json* value = find(key);
    return value == nullptr ? std::nullopt
                            : std::optional<double>(numberIn(*value, place(key), low, high));
}

std::optional<int> JsonObject::integer(const std::string& key, int low, int high) {
    const json* value = find(key);
    if (value == nullptr) {
        return std::nullopt;
    }
    const double number = value->is_number() ? value->get<double>() : low - 0.5;
    if (number != std::floor(number) || number < low || number > high) {
        refuse(place(key), *value,
               "a whole number in " + std::to_string(low) + " .. " + std::to_string(high));
    }
    return int(number);
}

std::optional<bool> JsonObject::flag(const std::string& key) {
    const json* value = find(key);
    if (value == nullptr) {
        return std::nullopt;
    }
    if (!value->is_boolean()) {
        refuse(place(key), *value, "true or false");
    }
    return value->get<bool>();
}

std::optional<std::string> JsonObject::text(const std::string& key) {
    const json* value = find(key);
    if (value == nullptr) {
        return std::nullopt;
    }
    if (!value->is_string()) {
        refuse(place(key), *value, "a text");
    }
    return value->get<std::string>();
}

std::optional<std::vector<double>> JsonObject::numbers(const std::string& key, std::size_t count,
                                                       double low, double high) {
    const json* value = find(key);
    if (value == nullptr) {
        return std::nullopt;
    }
    if (!value->is_array() || value->size() != count) {
        refuse(place(key), *value, "an array of " + std::to_string(count) + " numbers");
    }
    std::vector<double> list;
    for (std::size_t i = 0; i < count; ++i) {
        list.push_back(numberIn((*value)[i], place(key).at(i), low, high));
    }
    return list;
}

std::optional<JsonObject> JsonObject::object(const std::string& key) {
    const json* value = find(key);
    return value == nullptr ? std::nullopt
                            : std::optional<JsonObject>(std::in_place, *value, place(key));
}

std::vector<JsonObject> JsonObject::objects(const std::string& key) {
    const json* value = find(key);
    std::vector<JsonObject> list;
    if (value == nullptr) {
        return list;
    }
    if (!value->is_array()) {
        refuse(place(key), *value, "an array of objects");
    }
    for (std::size_t i = 0; i < value->size(); ++i) {
        list.emplace_back((*value)[i], place(key).at(i));
    }
    return list;
}

bool JsonObject::isText(const std::string& key) {
    const json* value = find(key);
    return value != nullptr && value->is_string();
}

bool JsonObject::isNull(const std::string& key) {
    const json* value = find(key);
    return value != nullptr && value->is_null();
}

void JsonObject::refuseOthers() const {
    for (const auto& [key, value] : value_->items()) {
        if (known_.contains(key)) {
            continue;
        }
        std::string known;
        for (const std::string& name : known_) {
            known += (known.empty() ? "" : ", ") + name;
        }
        throw Error(ErrorKind::kBadInput, place_.at(key),
                    "is not known here; there are: " + known + "; correct or remove it");
    }
}

}  // namespace ribalta
