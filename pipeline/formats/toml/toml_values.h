#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#define TOML_EXCEPTIONS 0
// The library asserts, or promises the optimiser, what a file may well break, and reports it
// right after that: "[=]" is such a file. Both are switched off.
#define TOML_ASSERT(condition) static_assert(true)
#pragma push_macro("NDEBUG")
#undef NDEBUG
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

#include "pipeline/core/result.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/scene/settings_table.h"

// Values of a TOML file of this program, each checked against the range of its setting.
namespace pipeline {

// The table that a text is; at most kMaxTomlBytes of it. An error where it is stopped.
Result<toml::table> parseToml(const SourceText& source);

// The entries of a table in the order of the file, where the library has them by name: so the first errors of a table
// are those that its reader finds first.
struct TomlEntry {
    const toml::key* key;
    const toml::node* node;
};
std::vector<TomlEntry> inFileOrder(const toml::table& table);

// Collects what is wrong with the values of one file.
class TomlValues {
public:
    explicit TomlValues(std::string file) : m_file(std::move(file)) {}

    // `path` names the value in messages: "light.0.color".
    std::optional<double> number(const toml::node& node, const std::string& path, double min, double max);
    std::optional<double> wholeNumber(const toml::node& node, const std::string& path, double min, double max);
    std::optional<std::string> text(const toml::node& node, const std::string& path);
    // A text for a line of a terminal or a file's name.
    std::optional<std::string> name(const toml::node& node, const std::string& path);
    // The index of the choice.
    std::optional<std::size_t> choice(const toml::node& node, const std::string& path,
                                      std::span<const std::string_view> choices);
    // Exactly `count` numbers of an array.
    std::optional<std::vector<double>> numbers(const toml::node& node, const std::string& path, std::size_t count,
                                               double min, double max);
    std::optional<std::vector<int>> wholeNumbers(const toml::node& node, const std::string& path, std::size_t count,
                                                 int min, int max);
    const toml::table* table(const toml::node& node, const std::string& path);
    // [[name]], each of them a table.
    std::vector<const toml::table*> tables(const toml::node& node, const std::string& path, std::size_t most);
    void setting(const toml::node& node, const std::string& path, const Setting& row, Scene& scene, std::size_t index);

    void unknown(const toml::key& key, const std::string& path, std::span<const std::string> known);
    void refuse(const toml::node& node, const std::string& path, std::string expected);
    void fail(const toml::source_region& where, std::string found, std::string expected = {});
    SourceLocation place(const toml::source_region& where) const {
        return {m_file, static_cast<int>(where.begin.line), static_cast<int>(where.begin.column)};
    }
    void add(const Errors& errors);
    // Whether there are kMaxErrors: no use in reading on, for no more are kept.
    bool full() const { return m_errors.size() >= kMaxErrors; }

    // In the order of the file, each once, at most kMaxErrors.
    Errors errors() const;

private:
    std::string m_file;
    Errors m_errors;
};

}  // namespace pipeline
