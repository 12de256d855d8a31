#pragma once
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pipeline {

// A place in a text file. Line and column count from 1, columns in characters
// (UTF-8 code points). 0 where the place is not known or does not apply.
struct SourceLocation {
    std::string file;
    int line = 0;
    int column = 0;
    bool operator==(const SourceLocation&) const = default;
};

// What is wrong in the user's data, and what would be right.
struct Error {
    SourceLocation where;
    std::string found;     // "found \"x4\"", "pyramid.des announces 9 vertices"
    std::string expected;  // "a vertex index from 0 to 4"
    // Of the settings that it comes from, the likeliest first: "light.0.x", or "light.0" for all of them. Who knows
    // where a key was given fills in `where`.
    std::vector<std::string> keys{};

    Error() = default;
    Error(SourceLocation at, std::string wrong, std::string right = {})
        : where(std::move(at)), found(std::move(wrong)), expected(std::move(right)) {}
    bool operator==(const Error&) const = default;
};

// As many as are reported in one go.
inline constexpr std::size_t kMaxErrors = 20;
using Errors = std::vector<Error>;

// "FILE:LINE:COLUMN: what was found, expected what". Parts that are not known are left out.
std::string format(const Error& error);
// One line an error.
std::string format(const Errors& errors);

// A T, or the reasons there is none. Only for data from outside the program.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : m_content(std::move(value)) {}
    Result(Error error) : m_content(Errors{std::move(error)}) {}
    Result(Errors errors) : m_content(std::move(errors)) {}

    explicit operator bool() const { return m_content.index() == 0; }
    const T& value() const& { return std::get<0>(m_content); }
    T&& value() && { return std::get<0>(std::move(m_content)); }
    const T& operator*() const& { return value(); }
    const T* operator->() const { return &value(); }
    const Errors& errors() const { return std::get<1>(m_content); }

private:
    std::variant<T, Errors> m_content;
};

}  // namespace pipeline
