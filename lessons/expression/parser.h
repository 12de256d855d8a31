#pragma once
#include <deque>

#include "lessons/expression/function_table.h"

namespace lessons {

// What a channel is called: the letter's place modulo 3 is its index.
inline constexpr std::string_view kChannelLetters = "rgbxyz012";

// The names of a table's entries, for messages.
template <class Range, class Name>
std::vector<std::string> namesIn(const Range& range, Name nameOf) {
    std::vector<std::string> names;
    for (const auto& entry : range) names.emplace_back(nameOf(entry));
    return names;
}

// From text to a tree, by recursive descent: the grammar in parser.cpp, names in names.cpp, calls
// in calls.cpp.
class Parser {
public:
    // atPixels: names of buffers stand for their numbers at each pixel.
    Parser(std::string_view text, const pipeline::SourceLocation& where, const Scope& scope, bool atPixels);
    pipeline::Result<Expression> parse(std::optional<Type> wanted);

private:
    struct Deeper;  // counts how deep parentheses, signs and calls stand in one another

    // Only the first error is kept: those behind it may be its consequence.
    void fail(pipeline::SourceLocation where, std::string found, std::string expected = {});
    void fail(std::size_t at, std::string found, std::string expected = {});
    void failUnknown(std::size_t at, std::string_view kind, std::string_view name, std::vector<std::string> known);
    pipeline::SourceLocation placeOf(std::size_t at) const;
    std::string rest() const;
    void skipBlanks();
    bool take(std::string_view sign);
    bool takeWord(std::string_view word);  // a whole word
    void require(std::string_view sign);
    // The characters up to one of `ends`, without blanks around them, and where they start.
    std::string_view takeUntil(std::string_view ends, std::size_t& start);

    void wantDrawn();  // the buffers that say where something was drawn
    // A name stands for all that is in it: names of names must not grow without end.
    void countOperators(int more);
    void need(Type type, const Node& node);
    Node made(Node::Kind kind, Type type, std::vector<Node> operands);

    Node either();
    Node both();
    Node negation();
    Node comparison();
    Node sum();
    Node product();
    Node sign();
    Node power();
    Node component();
    Node primary();
    Node number();
    Node vector();

    Node named();
    Node elementNamed(std::string_view name, std::size_t at);
    Node pickNamed(std::string_view field, std::size_t at);
    std::optional<pipeline::BufferName> findHere(std::string_view name) const;
    // What a word may be that is compared with the node, or nothing where the node is no word.
    std::optional<std::vector<std::string>> wordsFor(const Node& node) const;
    Node wordAgainst(const Node& node, const std::vector<std::string>& known);

    Node call(std::string_view name, std::size_t at);
    void arguments(Node& node);
    void values(Node& node, int count, Type type);
    void choice(Node& node);
    void buffer(Node& node, std::string_view ends);
    // The letter of a channel here, below `channels`; `otherwise` says how many there are.
    int channel(int channels, const std::string& otherwise);
    void element(Node& node);
    void condition(Node& node);
    void setting(Node& node);
    void stage(Node& node);
    pipeline::Result<pipeline::Scene> changes(Node& node, std::string_view end);
    void changed(Node& node);
    void field(Node& node);
    void checkPlace(const Node& node);

    // Elements that names of buffers go through: pixels, or those of the first buffer that is named.
    struct Elements {
        bool pixels = false;
        std::optional<pipeline::BufferName> like;
    };

    std::string_view m_text;
    pipeline::SourceLocation m_where;
    const pipeline::Scene* m_scene;
    const Scope& m_scope;
    std::deque<pipeline::Scene> m_changedScenes;  // of with()
    std::optional<Elements> m_elements;
    std::size_t m_at = 0;
    int m_depth = 0, m_operators = 0;
    pipeline::BufferSet m_buffers;
    std::optional<pipeline::Error> m_error;
};

struct Parser::Deeper {
    explicit Deeper(Parser& parser);
    ~Deeper() { --m_parser.m_depth; }
    Deeper(const Deeper&) = delete;
    Parser& m_parser;
};

}  // namespace lessons
