// From text to Expression, by recursive descent.
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include "lessons/expression.h"
#include "lessons/text_position.h"
#include "pipeline/core/text.h"
#include "pipeline/stages/cull.h"

namespace lessons {

namespace {

using pipeline::Error;
using pipeline::inQuotes;
using Kind = Node::Kind;

// Parentheses and signs within one another; a formula that people write stays far below.
constexpr int kDeepest = 50;
constexpr int kOperators = 500;  // of an expression: each is one step deeper in what a chain of them is kept as

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    return first == text.npos ? std::string_view() : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

template <class Range, class Name>
std::string insteadOfAny(std::string_view text, const Range& range, Name nameOf) {
    std::vector<std::string> names;
    for (const auto& entry : range) names.emplace_back(nameOf(entry));
    return pipeline::insteadOf(text, names);
}

class Parser {
public:
    Parser(std::string_view text, const pipeline::SourceLocation& where, const pipeline::Scene& scene)
        : m_text(text), m_where(where), m_scene(scene) {}

    pipeline::Result<Expression> parse() {
        Expression expression{std::string(trimmed(m_text)), sum()};
        skipBlanks();
        if (!m_error && m_at < m_text.size())
            fail(m_at, "found " + inQuotes(m_text.substr(m_at)), "an operator or the end");
        if (m_error) return *m_error;
        return expression;
    }

private:
    // Only the first error is kept: those behind it may be its consequence.
    void fail(std::size_t at, std::string found, std::string expected = {}) {
        if (!m_error) m_error = Error{placeOf(at), std::move(found), std::move(expected)};
        m_at = m_text.size();
    }
    pipeline::SourceLocation placeOf(std::size_t at) const { return advanced(m_where, m_text.substr(0, at)); }

    void skipBlanks() {
        while (m_at < m_text.size() && (m_text[m_at] == ' ' || m_text[m_at] == '\t')) ++m_at;
    }
    bool take(char c) {
        skipBlanks();
        if (m_at >= m_text.size() || m_text[m_at] != c) return false;
        ++m_at;
        return true;
    }
    void require(char c) {
        if (take(c)) return;
        skipBlanks();
        const std::string found = m_at < m_text.size() ? inQuotes(m_text.substr(m_at, 1)) : "the end";
        fail(m_at, "found " + found, std::string("'") + c + "'");
    }
    // The characters up to one of `ends`, without blanks around them, and where they start.
    std::string_view takeUntil(std::string_view ends, std::size_t& start) {
        skipBlanks();
        start = m_at;
        m_at = std::min(m_text.find_first_of(ends, m_at), m_text.size());
        return trimmed(m_text.substr(start, m_at - start));
    }

    // What an operator makes of what stands before and after it.
    Node operation(Kind kind, Node left, Node right) {
        Node node = operation(kind, std::move(left));
        node.operands.push_back(std::move(right));
        return node;
    }
    Node operation(Kind kind, Node operand) {
        if (++m_operators > kOperators) fail(m_at, "found more than 500 operators", "a shorter expression");
        Node node;
        node.kind = kind;
        node.where = operand.where;
        node.operands.reserve(2);
        node.operands.push_back(std::move(operand));
        return node;
    }

    Node sum() {
        Node left = product();
        for (;;) {
            if (take('+'))
                left = operation(Kind::Add, std::move(left), product());
            else if (take('-'))
                left = operation(Kind::Subtract, std::move(left), product());
            else
                return left;
        }
    }
    Node product() {
        Node left = sign();
        for (;;) {
            if (take('*'))
                left = operation(Kind::Multiply, std::move(left), sign());
            else if (take('/'))
                left = operation(Kind::Divide, std::move(left), sign());
            else
                return left;
        }
    }
    Node sign() {
        if (++m_depth > kDeepest) fail(m_at, "found more than 50 parentheses and signs within one another");
        Node node = take('-') ? operation(Kind::Negate, sign()) : power();
        --m_depth;
        return node;
    }
    Node power() {  // binds to the right: 2^3^2 is 2^9
        Node base = primary();
        return take('^') ? operation(Kind::Power, std::move(base), sign()) : base;
    }
    Node primary() {
        if (take('(')) {
            Node inner = sum();
            require(')');
            return inner;
        }
        skipBlanks();
        if (m_at < m_text.size() && std::isalpha(static_cast<unsigned char>(m_text[m_at]))) return call();
        return number();
    }
    Node number() {
        Node node;
        node.where = placeOf(m_at);
        const char* const first = m_text.data() + m_at;
        const auto [end, error] = std::from_chars(first, m_text.data() + m_text.size(), node.number);
        if (error != std::errc() || !std::isfinite(node.number)) {
            const std::string found = m_at < m_text.size() ? inQuotes(m_text.substr(m_at)) : "the end";
            fail(m_at, "found " + found, "a number, a function or '('");
        } else {
            m_at += std::size_t(end - first);
        }
        return node;
    }

    Node call() {
        Node node;
        node.kind = Kind::Call;
        const std::size_t start = m_at;
        while (m_at < m_text.size() && (std::isalnum(static_cast<unsigned char>(m_text[m_at])) || m_text[m_at] == '_'))
            ++m_at;
        const std::string_view name = m_text.substr(start, m_at - start);
        node.where = placeOf(start);
        const auto table = functionTable();
        const auto found = std::ranges::find(table, name, &Function::name);
        if (found == table.end()) {
            fail(start, "no function " + inQuotes(name) + "; " +
                            insteadOfAny(name, table, [](const Function& f) { return f.name; }));
            return node;
        }
        node.function = &*found;
        require('(');
        arguments(node);
        require(')');
        if (!fieldsOf(found->takes).empty()) field(node);
        if (!m_error) checkPlace(node);
        return node;
    }
    void arguments(Node& node) {
        switch (node.function->takes) {
            case Takes::Number:
            case Takes::Polygon: numbers(node, 1); return;
            case Takes::TwoNumbers:
            case Takes::PixelField: numbers(node, 2); return;
            case Takes::FragmentField: numbers(node, 3); return;
            case Takes::Buffer: buffer(node, ",)"); return;
            case Takes::Element: element(node); return;
            case Takes::Comparison: comparison(node); return;
            case Takes::Setting: setting(node); return;
            case Takes::Stage: stage(node); return;
        }
    }
    void numbers(Node& node, int count) {
        for (int i = 0; i < count; ++i) {
            if (i > 0) require(',');
            node.operands.push_back(sum());
        }
    }
    void buffer(Node& node, std::string_view ends) {
        std::size_t start = 0;
        const std::string_view name = takeUntil(ends, start);
        node.buffer = pipeline::findBuffer(name);
        if (!node.buffer) {
            fail(start, "no buffer " + inQuotes(name) + "; " + pipeline::insteadOfBuffer(name));
        } else if (node.buffer->light >= int(m_scene.lights.size())) {
            fail(start, "no buffer " + inQuotes(name) + ": this scene has " + std::to_string(m_scene.lights.size()) +
                            (m_scene.lights.size() == 1 ? " light" : " lights"));
        }
    }
    void element(Node& node) {
        buffer(node, ",)");
        if (m_error) return;
        const pipeline::BufferInfo& info = pipeline::bufferInfo(node.buffer->id);
        const bool picture = info.domain == pipeline::Domain::Pixel || info.domain == pipeline::Domain::Texel;
        require(',');
        numbers(node, picture ? 2 : 1);
        if (!take(',')) return;
        std::size_t start = 0;
        const std::string_view text = takeUntil(")", start);
        constexpr std::string_view kLetters = "rgbxyz012";
        const auto letter = text.size() == 1 ? kLetters.find(text[0]) : text.npos;
        if (letter == text.npos)
            return fail(start, "found " + inQuotes(text), "a channel: r, g, b, x, y, z, 0, 1 or 2");
        node.channel = int(letter % 3);
        if (*node.channel >= info.channels)
            fail(start, "no channel " + inQuotes(text) + ": " + node.buffer->text() + " has one value a place");
    }
    void comparison(Node& node) {
        buffer(node, "=!<>,)");
        if (m_error) return;
        constexpr std::array<std::string_view, 6> kComparisons{"<=", ">=", "!=", "=", "<", ">"};
        const std::string_view rest = m_text.substr(m_at);
        const auto sign =
            std::ranges::find_if(kComparisons, [rest](std::string_view c) { return rest.starts_with(c); });
        if (sign == kComparisons.end())
            return fail(m_at, "found " + inQuotes(rest.substr(0, 1)), "one of = != < <= > >=");
        node.word = *sign;
        m_at += sign->size();
        if (node.buffer->id != pipeline::BufferId::PolygonsVerdict) {
            node.operands.push_back(sum());
            return;
        }
        std::size_t start = 0;
        const std::string_view text = takeUntil(")", start);
        Node code;
        code.where = placeOf(start);
        std::vector<std::string> names;
        for (std::size_t i = 0; i < pipeline::kVerdictCount; ++i) names.emplace_back(name(pipeline::Verdict(i)));
        const auto found = std::ranges::find(names, text);
        if (found == names.end())
            return fail(start, "no verdict " + inQuotes(text) + "; " + pipeline::insteadOf(text, names));
        code.number = double(found - names.begin());
        node.operands.push_back(code);
    }
    void setting(Node& node) {
        std::size_t start = 0;
        const std::string_view key = takeUntil(",)", start);
        const auto found = pipeline::findSetting(m_scene, key);
        if (!found) return fail(start, found.errors().front().found, found.errors().front().expected);
        node.setting = *found;
    }
    void stage(Node& node) {
        std::size_t start = 0;
        const std::string_view name = takeUntil(",)", start);
        node.stage = pipeline::findStage(name);
        if (!node.stage)
            fail(start, "no stage " + inQuotes(name) + "; " +
                            insteadOfAny(name, pipeline::kStages,
                                         [](pipeline::StageId s) { return pipeline::stageInfo(s).name; }));
    }
    void field(Node& node) {
        require('.');
        if (m_error) return;
        const std::size_t start = m_at;
        while (m_at < m_text.size() && (std::isalpha(static_cast<unsigned char>(m_text[m_at])) || m_text[m_at] == '_'))
            ++m_at;
        node.word = m_text.substr(start, m_at - start);
        const auto fields = fieldsOf(node.function->takes);
        if (std::ranges::find(fields, node.word) == fields.end())
            fail(start, std::string(node.function->name) + " has no " + inQuotes(node.word) + "; " +
                            insteadOfAny(node.word, fields, [](std::string_view f) { return f; }));
    }

    // A place that is written as a number is checked here; a computed one when it is evaluated.
    void checkPlace(const Node& node) {
        const auto check = [&](const Node& operand, double count, const char* what) {
            if (operand.kind != Kind::Number) return;
            if (operand.number >= 0 && operand.number < count && operand.number == std::trunc(operand.number)) return;
            if (m_error) return;
            m_error = Error{operand.where, "found " + pipeline::shortestText(operand.number),
                            std::string(what) + " from 0 to " + pipeline::shortestText(count - 1)};
        };
        double vertices = 0, polygons = 0;
        for (const pipeline::Object& object : m_scene.objects) {
            vertices += double(object.mesh->positions.size());
            polygons += double(object.mesh->polygonCount());
        }
        const auto checkPixel = [&] {
            check(node.operands[0], m_scene.settings.width, "x");
            check(node.operands[1], m_scene.settings.height, "y");
        };
        if (!fieldsOf(node.function->takes).empty()) checkPixel();
        if (node.function->takes == Takes::Polygon) check(node.operands[0], polygons, "a polygon");
        if (node.function->takes != Takes::Element) return;
        switch (pipeline::bufferInfo(node.buffer->id).domain) {
            case pipeline::Domain::Vertex: check(node.operands[0], vertices, "a vertex"); break;
            case pipeline::Domain::Polygon: check(node.operands[0], polygons, "a polygon"); break;
            case pipeline::Domain::Pixel: checkPixel(); break;
            case pipeline::Domain::Texel: break;  // its size is the runner's affair
        }
    }

    std::string_view m_text;
    pipeline::SourceLocation m_where;
    const pipeline::Scene& m_scene;
    std::size_t m_at = 0;
    int m_depth = 0, m_operators = 0;
    std::optional<Error> m_error;
};

}  // namespace

pipeline::Result<Expression> parseExpression(std::string_view text, const pipeline::SourceLocation& where,
                                             const pipeline::Scene& scene) {
    return Parser(text, where, scene).parse();
}

}  // namespace lessons
