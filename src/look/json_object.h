// JsonObject: reads an object's members by name and type; what is not as expected is an error that
// names the key.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/error.h"

namespace ribalta {

/// Every reader gives none where the object lacks the key, and throws Error(kBadInput) at its place
/// where the value is of another type or out of range.
class JsonObject {
  public:
    /// `value` must outlive this. Throws Error(kBadInput) where it is no object.
    JsonObject(const nlohmann::json& value, Place place);

    const Place& place() const { return place_; }
    Place place(const std::string& key) const { return place_.at(key); }

    std::optional<double> number(const std::string& key, double low, double high);
    std::optional<int> integer(const std::string& key, int low, int high);
    std::optional<bool> flag(const std::string& key);
    std::optional<std::string> text(const std::string& key);
    std::optional<std::vector<double>> numbers(const std::string& key, std::size_t count,
                                               double low, double high);
    std::optional<JsonObject> object(const std::string& key);
    /// Of an array of objects; none where it is not there.
    std::vector<JsonObject> objects(const std::string& key);
    /// Whether the key is there and holds a text.
    bool isText(const std::string& key);
    /// Whether the key is there with the value null.
    bool isNull(const std::string& key);

    /// Throws Error(kBadInput) that names the first key that no reader was asked for.
    void refuseOthers() const;

  private:
    const nlohmann::json* find(const std::string& key);

    const nlohmann::json* value_;
    Place place_;
    std::set<std::string> known_;
};

}  // namespace ribalta
