// From text to Condition, by recursive descent.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include "lessons/condition.h"
#include "lessons/text_position.h"
#include "pipeline/core/text.h"
#include "pipeline/scene/opacity.h"

namespace lessons {

namespace {

using pipeline::BufferName;
using pipeline::Error;
using pipeline::inQuotes;
using Kind = ConditionNode::Kind;

constexpr int kDeepest = 50;     // parentheses and signs within one another
constexpr int kOperators = 500;  // of a condition: each is one step deeper in what a chain of them is kept as

class Parser {
public:
    Parser(std::string_view text, const pipeline::SourceLocation& where, const pipeline::Scene& scene)
        : m_text(text), m_where(where), m_scene(scene) {}

    // channels: of what is asked for, 0 for true or false, 1 for a number.
    pipeline::Result<Condition> parse(int channels) {
        Condition condition{std::string(m_text), either(), {}};
        skipBlanks();
        if (!m_error && m_at < m_text.size()) fail(m_at, "found " + rest(), "an operator or the end");
        channels == 0 ? needTruth(condition.root, 0) : needNumber(condition.root, 0);
        if (m_error) return *m_error;
        condition.buffers = m_buffers | pipeline::setOf({pipeline::BufferId::PolygonId});
        // Where only translucent surfaces are seen no polygon stands, and yet something was drawn.
        if (!translucentSides(m_scene).empty()) condition.buffers.set(index(pipeline::BufferId::Layers));
        return condition;
    }

private:
    // Only the first error is kept: those behind it may be its consequence.
    void fail(std::size_t at, std::string found, std::string expected = {}) {
        if (!m_error) m_error = Error{advanced(m_where, m_text.substr(0, at)), std::move(found), std::move(expected)};
        m_at = m_text.size();
    }
    std::string rest() const { return m_at < m_text.size() ? inQuotes(m_text.substr(m_at)) : "the end"; }
    void skipBlanks() {
        while (m_at < m_text.size() && std::isspace(static_cast<unsigned char>(m_text[m_at]))) ++m_at;
    }
    bool take(std::string_view sign) {
        skipBlanks();
        if (!m_text.substr(m_at).starts_with(sign)) return false;
        m_at += sign.size();
        return true;
    }
    void require(std::string_view sign) {
        if (take(sign)) return;
        fail(m_at, "found " + rest(), inQuotes(sign));
    }
    std::size_t start() {
        skipBlanks();
        return m_at;
    }

    void needTruth(const ConditionNode& node, std::size_t at) {
        if (node.channels != 0) fail(at, "found a number", "a comparison such as n_dot_l.0 > 0.5");
    }
    void needNumber(const ConditionNode& node, std::size_t at) {
        if (node.channels == 0) fail(at, "found a comparison", "a number");
        if (node.channels == 3) fail(at, "found a vector", "a number: one of its channels (.x), or length(…)");
    }
    void needVector(const ConditionNode& node, std::size_t at) {
        if (node.channels != 3) fail(at, "found no vector", "a buffer of three channels");
    }
    // What an operator makes of what stands before and after it.
    ConditionNode operation(Kind kind, int channels, ConditionNode left, ConditionNode right) {
        ConditionNode node = operation(kind, channels, std::move(left));
        node.operands.push_back(std::move(right));
        return node;
    }
    ConditionNode operation(Kind kind, int channels, ConditionNode operand) {
        if (++m_operators > kOperators) fail(m_at, "found more than 500 operators", "a shorter condition");
        ConditionNode node;
        node.kind = kind;
        node.channels = channels;
        node.operands.reserve(2);
        node.operands.push_back(std::move(operand));
        return node;
    }

    ConditionNode either() {
        const std::size_t at = start();
        ConditionNode left = both();
        while (take("||")) {
            needTruth(left, at);
            const std::size_t next = start();
            ConditionNode right = both();
            needTruth(right, next);
            left = operation(Kind::Or, 0, std::move(left), std::move(right));
        }
        return left;
    }
    ConditionNode both() {
        const std::size_t at = start();
        ConditionNode left = negation();
        while (take("&&")) {
            needTruth(left, at);
            const std::size_t next = start();
            ConditionNode right = negation();
            needTruth(right, next);
            left = operation(Kind::And, 0, std::move(left), std::move(right));
        }
        return left;
    }
    ConditionNode negation() {
        const std::size_t at = start();
        if (m_text.substr(at).starts_with("!=") || !take("!")) return comparison();
        Deeper deeper(*this);
        ConditionNode inner = negation();
        needTruth(inner, at + 1);
        return operation(Kind::Not, 0, std::move(inner));
    }
    ConditionNode comparison() {
        struct Sign {
            std::string_view text;
            Kind kind;
        };
        // Longer ones first. One = is meant as two: nothing is assigned here.
        static constexpr std::array<Sign, 7> kSigns{{{"<=", Kind::LessEqual},
                                                     {">=", Kind::GreaterEqual},
                                                     {"==", Kind::Equal},
                                                     {"!=", Kind::NotEqual},
                                                     {"<", Kind::Less},
                                                     {">", Kind::Greater},
                                                     {"=", Kind::Equal}}};
        const std::size_t at = start();
        ConditionNode left = sum();
        skipBlanks();
        const auto found = std::ranges::find_if(
            kSigns, [text = m_text.substr(m_at)](const Sign& sign) { return text.starts_with(sign.text); });
        if (found == kSigns.end()) return left;
        m_at += found->text.size();
        needNumber(left, at);
        const std::size_t next = start();
        ConditionNode right = sum();
        needNumber(right, next);
        return operation(found->kind, 0, std::move(left), std::move(right));
    }
    ConditionNode sum() {
        const std::size_t at = start();
        ConditionNode left = product();
        for (;;) {
            const bool plus = take("+");
            if (!plus && !take("-")) return left;
            ConditionNode right = product();
            if (left.channels != right.channels || left.channels == 0)
                fail(at, "found two of different kinds around " + std::string(plus ? "+" : "-"),
                     "two numbers or two vectors");
            const int channels = left.channels;
            left = operation(plus ? Kind::Add : Kind::Subtract, channels, std::move(left), std::move(right));
        }
    }
    ConditionNode product() {
        const std::size_t at = start();
        ConditionNode left = sign();
        for (;;) {
            const bool times = take("*");
            if (!times && !take("/")) return left;
            const std::size_t next = start();
            ConditionNode right = sign();
            if (left.channels == 0) needNumber(left, at);
            if (!times || right.channels == 0 || left.channels == 3) needNumber(right, next);
            const int channels = std::max(left.channels, right.channels);
            left = operation(times ? Kind::Multiply : Kind::Divide, channels, std::move(left), std::move(right));
        }
    }
    ConditionNode sign() {
        const std::size_t at = start();
        if (!take("-")) return power();
        Deeper deeper(*this);
        ConditionNode inner = sign();
        if (inner.channels == 0) needNumber(inner, at + 1);
        const int channels = inner.channels;
        return operation(Kind::Negate, channels, std::move(inner));
    }
    ConditionNode power() {  // binds to the right: 2^3^2 is 2^9
        const std::size_t at = start();
        ConditionNode base = primary();
        if (!take("^")) return base;
        needNumber(base, at);
        const std::size_t next = start();
        Deeper deeper(*this);
        ConditionNode exponent = sign();
        needNumber(exponent, next);
        return operation(Kind::Power, 1, std::move(base), std::move(exponent));
    }
    ConditionNode primary() {
        if (take("(")) {
            Deeper deeper(*this);
            ConditionNode inner = either();
            require(")");
            return inner;
        }
        const std::size_t at = start();
        if (m_at < m_text.size() && std::isalpha(static_cast<unsigned char>(m_text[m_at]))) return named();
        ConditionNode node;
        const char* const first = m_text.data() + at;
        const auto [end, error] = std::from_chars(first, m_text.data() + m_text.size(), node.number);
        if (error != std::errc() || !std::isfinite(node.number))
            fail(at, "found " + rest(), "a number, a buffer, a function or '('");
        else
            m_at += std::size_t(end - first);
        return node;
    }

    ConditionNode named() {
        const std::size_t at = m_at;
        const auto isPart = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.'; };
        while (m_at < m_text.size() && isPart(m_text[m_at])) ++m_at;
        const std::string_view name = m_text.substr(at, m_at - at);
        if (take("(")) return call(name, at);
        ConditionNode node;
        if (name == "x" || name == "y") {
            node.kind = name == "x" ? Kind::Column : Kind::Row;
            return node;
        }
        return bufferNamed(name, at);
    }
    ConditionNode call(std::string_view name, std::size_t at) {
        Deeper deeper(*this);
        std::vector<ConditionNode> operands;
        const bool ofVectors = name == "length" || name == "dot";
        const auto table = functionTable();
        const auto found = std::ranges::find_if(table, [name](const Function& f) {
            return f.name == name && (f.takes == Takes::Number || f.takes == Takes::TwoNumbers);
        });
        if (!ofVectors && found == table.end()) {
            std::vector<std::string> names{"length", "dot"};
            for (const Function& f : table)
                if (f.takes == Takes::Number || f.takes == Takes::TwoNumbers) names.emplace_back(f.name);
            fail(at, "no function " + inQuotes(name) + " of numbers; " + pipeline::insteadOf(name, names));
            return {};
        }
        const std::size_t count = name == "dot" || (!ofVectors && found->takes == Takes::TwoNumbers) ? 2 : 1;
        for (std::size_t i = 0; i < count; ++i) {
            if (i > 0) require(",");
            const std::size_t next = start();
            operands.push_back(sum());
            ofVectors ? needVector(operands.back(), next) : needNumber(operands.back(), next);
        }
        require(")");
        ConditionNode node;
        node.kind = !ofVectors ? Kind::Call : count == 2 ? Kind::Dot : Kind::Length;
        node.channels = 1;
        node.operands = std::move(operands);
        if (!ofVectors) node.function = &*found;
        return node;
    }

    // "n_dot_l.0", "normal.x"; where there is one light, "n_dot_l" and "diffuse.r" too.
    ConditionNode bufferNamed(std::string_view name, std::size_t at) {
        ConditionNode node;
        node.kind = Kind::Buffer;
        constexpr std::string_view kLetters = "rgbxyz012";
        const std::size_t dot = name.rfind('.');
        const std::string_view last = dot == name.npos ? "" : name.substr(dot + 1), front = name.substr(0, dot);
        const auto letter = last.size() == 1 ? kLetters.find(last[0]) : last.npos;
        node.buffer = find(name);
        if (!node.buffer && letter != last.npos) {
            node.buffer = find(front);
            node.channel = int(letter % 3);
        }
        if (!node.buffer) {
            const std::string light = std::string(name) + ".0";
            if (pipeline::findBuffer(light) && m_scene.lights.size() != 1)
                fail(at,
                     fmt::format("{} is of one light, and this scene has {}", inQuotes(name), m_scene.lights.size()),
                     m_scene.lights.empty() ? std::string() : inQuotes(light));
            else
                fail(at, "no buffer " + inQuotes(name) + "; " + pipeline::insteadOfBuffer(name));
            return node;
        }
        const pipeline::BufferInfo& info = pipeline::bufferInfo(node.buffer->id);
        if (info.domain != pipeline::Domain::Pixel)
            fail(at, inQuotes(name) + " does not stand on pixels", "a buffer of the picture");
        if (node.buffer->light >= int(m_scene.lights.size()))
            fail(at, fmt::format("no buffer {}: this scene has {} {}", inQuotes(name), m_scene.lights.size(),
                                 m_scene.lights.size() == 1 ? "light" : "lights"));
        if (node.channel >= info.channels)
            fail(at, "no channel " + inQuotes(last) + ": " + node.buffer->text() + " has one value a pixel");
        node.channels = node.channel < 0 ? info.channels : 1;
        m_buffers.set(index(node.buffer->id));
        return node;
    }
    std::optional<BufferName> find(std::string_view name) const {
        if (const auto found = pipeline::findBuffer(name)) return found;
        return m_scene.lights.size() == 1 ? pipeline::findBuffer(std::string(name) + ".0") : std::nullopt;
    }

    struct Deeper {
        explicit Deeper(Parser& parser) : m_parser(parser) {
            if (++m_parser.m_depth > kDeepest)
                m_parser.fail(m_parser.m_at, "found more than 50 parentheses and signs within one another");
        }
        ~Deeper() { --m_parser.m_depth; }
        Parser& m_parser;
    };

    std::string_view m_text;
    pipeline::SourceLocation m_where;
    const pipeline::Scene& m_scene;
    std::size_t m_at = 0;
    int m_depth = 0, m_operators = 0;
    pipeline::BufferSet m_buffers;
    std::optional<Error> m_error;
};

}  // namespace

pipeline::Result<Condition> parseCondition(std::string_view text, const pipeline::SourceLocation& where,
                                           const pipeline::Scene& scene) {
    return Parser(text, where, scene).parse(0);
}

pipeline::Result<Condition> parseNumbers(std::string_view text, const pipeline::SourceLocation& where,
                                         const pipeline::Scene& scene) {
    return Parser(text, where, scene).parse(1);
}

}  // namespace lessons
