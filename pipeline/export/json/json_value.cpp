#include "pipeline/export/json/json_value.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "pipeline/formats/text/stoppable_text.h"

namespace pipeline {

// Converts between our values and the library's.
struct JsonText {
    using Library = nlohmann::ordered_json;

    // An array or object without its elements.
    static Library shallow(const Json& json) {
        if (json.is(Json::kArray)) return Library::array();
        if (json.is(Json::kObject)) return Library::object();
        return std::visit(
            []<class T>(const T& value) -> Library {
                if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) return value;
                return nullptr;
            },
            json.m_value);
    }
    static Library whole(const Json& json) {
        Library copy = shallow(json);
        if (json.is(Json::kArray))
            for (const Json& element : json) copy.push_back(whole(element));
        else if (json.is(Json::kObject))  // each key once: to look for it takes as long as there are keys
            for (Json::Item& item : json.items())
                copy.get_ref<Library::object_t&>().push_back({std::move(item.key), whole(item.value)});
        return copy;
    }
};

namespace {

// Takes the parser's events.
class JsonReader {
public:
    explicit JsonReader(const JsonLimits& limits) : m_limits(limits) {}
    Json root;

    bool null() { return add(nullptr); }
    bool boolean(bool value) { return add(value); }
    bool number_integer(std::int64_t value) { return add(value); }
    bool number_unsigned(std::uint64_t value) { return add(value); }
    bool number_float(double value, const std::string&) { return add(value); }
    bool string(std::string& text) { return add(std::move(text)); }
    bool binary(nlohmann::json::binary_t&) { return false; }
    bool start_object(std::size_t) { return open(Json::object()); }
    bool start_array(std::size_t) { return open(Json::array()); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }
    bool key(std::string& key) {
        if (m_leftOut == 0) m_key = std::move(key);
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) { return false; }

private:
    bool isLeftOut() const {
        return m_leftOut > 0 || m_open.size() >= m_limits.levels ||
               (m_open.size() == 1 && root.is(Json::kObject) && !m_limits.without.empty() && m_key == m_limits.without);
    }
    Json* place(Json value) {
        if (m_open.empty()) return &(root = std::move(value));
        if (m_open.back()->is(Json::kArray)) return &m_open.back()->push_back(std::move(value));
        return &((*m_open.back())[m_key] = std::move(value));
    }
    bool add(Json value) {
        if (!isLeftOut()) place(std::move(value));
        return true;
    }
    bool open(Json value) {
        if (isLeftOut())
            ++m_leftOut;
        else
            m_open.push_back(place(std::move(value)));
        return true;
    }
    bool close() {
        if (m_leftOut > 0)
            --m_leftOut;
        else
            m_open.pop_back();
        return true;
    }

    JsonLimits m_limits;
    std::vector<Json*> m_open;  // arrays and objects that have not ended
    std::string m_key;          // of the member that comes next
    std::size_t m_leftOut = 0;  // levels inside what is left out
};

}  // namespace

Json::Json(const char* text) {
    if (text) m_value = std::string(text);
}
Json::Json(std::string text) : m_value(std::move(text)) {}
Json::Json(std::string_view text) : m_value(std::string(text)) {}
Json::Json(const Json& other) = default;
Json::Json(Json&& other) noexcept = default;

Json::Json(std::initializer_list<Json> list) {
    const auto isMember = [](const Json& one) {
        return one.is(kArray) && one.elements().size() == 2 && one[0].is(kString);
    };
    if (!std::ranges::all_of(list, isMember)) {
        *this = array(list);
        return;
    }
    m_value = Object();
    for (const Json& one : list) {
        Array& pair = std::get<Array>(one.m_value);
        std::string& key = std::get<std::string>(pair[0].m_value);
        if (!find(key)) add(std::move(key), std::move(pair[1]));
    }
}

Json& Json::operator=(Json other) noexcept {
    m_value.swap(other.m_value);
    return *this;
}

// One after the other: the values of a file may be nested deeper than the stack.
Json::~Json() {
    if (!is(kStructured)) return;
    std::vector<Json> nested;
    const auto take = [&](Json& from) {
        for (Json& element : from.elements())
            if (element.is(kStructured) && !element.elements().empty()) nested.push_back(std::move(element));
    };
    take(*this);
    while (!nested.empty()) {
        Json last = std::move(nested.back());
        nested.pop_back();
        take(last);
    }
}

Json Json::array(std::initializer_list<Json> list) {
    Json json;
    Array& elements = json.m_value.emplace<Array>();
    elements.reserve(list.size());
    for (const Json& one : list) elements.emplace_back().m_value.swap(one.m_value);
    return json;
}
Json Json::object() {
    Json json;
    json.m_value = Object();
    return json;
}

std::optional<Json> Json::read(std::string_view text, const JsonLimits& limits, const Stop& stop) {
    JsonReader reader(limits);
    StopCheck check(stop);
    const bool isRead = nlohmann::json::sax_parse(StoppableIterator(text.data(), &check),
                                                  StoppableIterator(text.data() + text.size(), &check), &reader);
    return isRead && !stop.stop_requested() ? std::optional(std::move(reader.root)) : std::nullopt;
}

Json Json::parse(std::string_view text) {
    if (std::optional<Json> json = read(text)) return std::move(*json);
    [[maybe_unused]] const auto none = nlohmann::json::parse(text);  // throws
    return {};
}

std::string Json::dump(int indent) const {
    return JsonText::whole(*this).dump(indent, ' ', false, JsonText::Library::error_handler_t::replace);
}

template <class T>
T Json::get() const {
    return JsonText::shallow(*this).get<T>();
}
template bool Json::get() const;
template double Json::get() const;
template long long Json::get() const;
template std::size_t Json::get() const;
template std::string Json::get() const;

std::string Json::text() const {
    const auto* const text = std::get_if<std::string>(&m_value);
    return text ? *text : std::string();
}

std::span<Json> Json::elements() {
    if (auto* const array = std::get_if<Array>(&m_value)) return *array;
    if (auto* const object = std::get_if<Object>(&m_value)) return object->values;
    return {this, is(kNull) ? std::size_t{0} : std::size_t{1}};
}

Json& Json::push_back(Json value) {
    if (!is(kArray)) m_value = Array();
    return std::get<Array>(m_value).emplace_back(std::move(value));
}

std::vector<Json::Item> Json::items() const {
    std::vector<Item> items;
    items.reserve(elements().size());
    const auto* const object = std::get_if<Object>(&m_value);
    for (const Json& value : *this) {
        const std::size_t i = items.size();
        items.push_back({object ? object->keys[i] : is(kArray) ? std::to_string(i) : std::string(), value});
    }
    return items;
}

const Json* Json::find(std::string_view key) const {
    const auto* const object = std::get_if<Object>(&m_value);
    if (!object) return nullptr;
    const auto found = std::ranges::find(object->keys, key);
    return found == object->keys.end() ? nullptr : &object->values[std::size_t(found - object->keys.begin())];
}

const Json& Json::operator[](std::string_view key) const {
    static const Json missing;
    const Json* const found = find(key);
    return found ? *found : missing;
}
Json& Json::operator[](std::string_view key) {
    const Json* const found = find(key);
    return found ? const_cast<Json&>(*found) : add(std::string(key), {});
}
const Json& Json::at(std::string_view key) const {
    const Json* const found = find(key);
    if (!found) static_cast<void>(JsonText::shallow(*this).at(std::string(key)));  // throws
    return *found;
}

Json& Json::add(std::string key, Json value) {
    if (!is(kObject)) m_value = Object();
    Object& object = std::get<Object>(m_value);
    object.keys.push_back(std::move(key));
    return object.values.emplace_back(std::move(value));
}

void update(Json& object, const Json& other) {
    for (const auto& [key, value] : other.items()) object[key] = value;
}

bool operator==(const Json& a, const Json& b) {
    if (!a.is(Json::kStructured) || !b.is(Json::kStructured)) return JsonText::shallow(a) == JsonText::shallow(b);
    const auto *const first = std::get_if<Json::Object>(&a.m_value), *const second =
                                                                         std::get_if<Json::Object>(&b.m_value);
    if ((first == nullptr) != (second == nullptr) || (first && first->keys != second->keys)) return false;
    return std::ranges::equal(a, b);
}

}  // namespace pipeline
