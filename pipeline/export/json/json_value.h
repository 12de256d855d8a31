#pragma once
#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "pipeline/core/stop.h"

namespace pipeline {

// What a reader leaves out: elements below so many levels, and one member of the outermost object.
struct JsonLimits {
    std::size_t levels = std::size_t(-1);
    std::string_view without{};
};

template <class T>
concept JsonNumber = std::is_arithmetic_v<T>;  // true and false also
template <JsonNumber T>                        // the type that stores it
using JsonStored =
    std::conditional_t<std::is_floating_point_v<T>, double,
                       std::conditional_t<std::is_same_v<T, bool>, bool,
                                          std::conditional_t<std::is_signed_v<T>, std::int64_t, std::uint64_t>>>;
template <class T>
concept JsonList = requires(const T& values) {  // a vector or a std::array, no text
    values.data();
    requires !std::is_same_v<typename T::value_type, char>;
};

// A JSON value. nlohmann's library reads and writes the text; its header takes seconds to compile, so that only
// json_value.cpp includes it. Members stand in the order in which they are written. Numbers that JSON has no text for
// (infinities, NaN) are written as null, bytes that are no UTF-8 as U+FFFD.
class Json {
public:
    enum Kind : unsigned {  // a bit each, in the order of m_value
        kNull = 1,
        kBoolean = 2,
        kNegative = 4,  // also every whole number that was given as a signed one
        kUnsigned = 8,
        kReal = 16,
        kString = 32,
        kArray = 64,
        kObject = 128,
        kWhole = kNegative | kUnsigned,
        kNumber = kWhole | kReal,
        kStructured = kArray | kObject
    };

    Json() = default;        // null
    Json(const char* text);  // a null pointer: null
    Json(std::string text);
    Json(std::string_view text);
    template <JsonNumber T>
    Json(T value) : m_value(static_cast<JsonStored<T>>(value)) {}
    // An object where every element is a pair of a text and a value, else an array.
    Json(std::initializer_list<Json> list);
    template <JsonList T>
    Json(const T& values) : Json(array()) {
        for (const auto& value : values) push_back(value);
    }
    template <class T, class Less>
    Json(const std::map<std::string, T, Less>& values) : Json(object()) {
        for (const auto& [key, value] : values) add(key, value);
    }
    Json(const Json& other);
    Json(Json&& other) noexcept;
    Json& operator=(Json other) noexcept;
    ~Json();

    static Json array(std::initializer_list<Json> list = {});
    static Json object();

    // Throws the library's exception, which says where and why a text is no JSON.
    static Json parse(std::string_view text);
    // Nothing where the text is no JSON, or the reading was stopped.
    static std::optional<Json> read(std::string_view text, const JsonLimits& limits = {}, const Stop& stop = {});
    // indent: spaces a level; below 0 all is in one line.
    std::string dump(int indent = -1) const;

    // kinds: one of them, or several.
    bool is(unsigned kinds) const { return ((1u << m_value.index()) & kinds) != 0; }
    // Throws the library's exception where the value is of another kind. T: bool, double, long long, std::size_t,
    // std::string.
    template <class T>
    T get() const;
    std::string text() const;  // of a string; empty for every other value

    // Those of an array, the values of an object; none of null, itself for every other value. A range is also the Json.
    std::span<Json> elements();
    std::span<const Json> elements() const { return const_cast<Json*>(this)->elements(); }
    friend Json* begin(Json& json) { return json.elements().data(); }
    friend Json* end(Json& json) { return begin(json) + json.elements().size(); }
    friend const Json* begin(const Json& json) { return json.elements().data(); }
    friend const Json* end(const Json& json) { return begin(json) + json.elements().size(); }
    Json& operator[](std::size_t i) { return elements()[i]; }
    const Json& operator[](std::size_t i) const { return elements()[i]; }
    Json& push_back(Json value);  // null becomes an array

    struct Item {
        std::string key;  // the number of an array's element
        const Json& value;
    };
    std::vector<Item> items() const;
    const Json* find(std::string_view key) const;        // null pointer: no such member, or no object
    Json& operator[](std::string_view key);              // null becomes an object, a missing member null
    const Json& operator[](std::string_view key) const;  // a missing member is null
    const Json& at(std::string_view key) const;          // throws the library's exception for a missing member
    Json& add(std::string key, Json value);              // a member that the object does not have yet

    // Numbers are compared by their values, objects with the order of their members.
    friend bool operator==(const Json& a, const Json& b);

private:
    friend struct JsonText;
    using Array = std::vector<Json>;
    struct Object {
        std::vector<std::string> keys;
        std::vector<Json> values;
    };
    // Mutable: the elements of an initialiser list are const, and are moved out of it.
    mutable std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double, std::string, Array, Object> m_value;
};

// Adds or replaces all members of the other object.
void update(Json& object, const Json& other);

}  // namespace pipeline
