#include "lessons/expression/parser.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include "lessons/text_position.h"
#include "pipeline/core/number.h"
#include "pipeline/core/text.h"
#include "pipeline/scene/opacity.h"

namespace lessons {

using pipeline::inQuotes;
using Kind = Node::Kind;

namespace {

constexpr std::size_t kLongest = 4096;
constexpr int kDeepest = 50;     // a formula that people write stays far below
constexpr int kOperators = 500;  // each is one step deeper in what a chain of them is kept as

// "or" and "||" are one sign. Typographic signs are those of the lectures' slides.
using Spellings = std::array<std::string_view, 2>;
constexpr Spellings kOr{"||", "or"}, kAnd{"&&", "and"};
constexpr Spellings kMinus{"-", "−"}, kTimes{"*", "·"};

struct Comparison {
    std::string_view text;
    Kind kind;
};
// Longer ones first. One = is meant as two: nothing is assigned here.
constexpr std::array<Comparison, 10> kComparisons{{{"<=", Kind::LessEqual},
                                                   {">=", Kind::GreaterEqual},
                                                   {"==", Kind::Equal},
                                                   {"!=", Kind::NotEqual},
                                                   {"≤", Kind::LessEqual},
                                                   {"≥", Kind::GreaterEqual},
                                                   {"≠", Kind::NotEqual},
                                                   {"<", Kind::Less},
                                                   {">", Kind::Greater},
                                                   {"=", Kind::Equal}}};

bool isWordPart(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

std::string_view withoutBlanks(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\n");
    return first == text.npos ? std::string_view() : text.substr(first, text.find_last_not_of(" \t\n") - first + 1);
}

std::string_view nameOf(Type type) {
    constexpr std::array<std::string_view, 4> kNames{"a number", "a vector", "a comparison", "words"};
    return kNames[std::size_t(type)];
}

std::string expectedOf(Type wanted, Type found) {
    switch (wanted) {
        case Type::Number:
            return found == Type::Vector ? "a number: one of its channels (.x), or length(…)" : "a number";
        case Type::Vector: return "a vector: [a, b, c], or a buffer of several channels";
        case Type::Truth: return "a comparison such as n_dot_l.0 > 0.5";
        case Type::Words: return "words";
    }
    return {};
}

}  // namespace

Parser::Parser(std::string_view text, const pipeline::SourceLocation& where, const Scope& scope, bool atPixels)
    : m_text(text), m_where(where), m_scene(&scope.scene), m_scope(scope) {
    if (atPixels) m_elements = Elements{true, {}};
}

pipeline::Result<Expression> Parser::parse(std::optional<Type> wanted) {
    if (m_text.size() > kLongest) fail(0, "found more than 4096 characters", "a shorter formula");
    Node root = m_error ? Node() : either();
    skipBlanks();
    if (!m_error && m_at < m_text.size()) fail(m_at, "found " + rest(), "an operator or the end");
    if (wanted) need(*wanted, root);
    if (m_error) return *m_error;
    if (m_elements) wantDrawn();
    return Expression{std::string(withoutBlanks(m_text)), std::move(root), m_buffers, m_operators};
}

Parser::Deeper::Deeper(Parser& parser) : m_parser(parser) {
    if (++m_parser.m_depth > kDeepest)
        m_parser.fail(m_parser.m_at, "found more than 50 parentheses and signs within one another");
}

void Parser::fail(pipeline::SourceLocation where, std::string found, std::string expected) {
    if (!m_error) m_error = pipeline::Error{std::move(where), std::move(found), std::move(expected)};
    m_at = m_text.size();
}
void Parser::fail(std::size_t at, std::string found, std::string expected) {
    fail(placeOf(at), std::move(found), std::move(expected));
}
void Parser::failUnknown(std::size_t at, std::string_view kind, std::string_view name, std::vector<std::string> known) {
    fail(at, "no " + std::string(kind) + ' ' + inQuotes(name) + "; " + pipeline::insteadOf(name, known));
}
pipeline::SourceLocation Parser::placeOf(std::size_t at) const { return advanced(m_where, m_text.substr(0, at)); }
std::string Parser::rest() const { return m_at < m_text.size() ? inQuotes(m_text.substr(m_at)) : "the end"; }

void Parser::skipBlanks() {
    while (m_at < m_text.size() && std::isspace(static_cast<unsigned char>(m_text[m_at]))) ++m_at;
}
bool Parser::take(std::string_view sign) {
    skipBlanks();
    if (!m_text.substr(m_at).starts_with(sign)) return false;
    m_at += sign.size();
    return true;
}
bool Parser::takeWord(std::string_view word) {
    skipBlanks();
    const std::string_view left = m_text.substr(m_at);
    if (!left.starts_with(word)) return false;
    if (isWordPart(word.back()) && left.size() > word.size() && isWordPart(left[word.size()])) return false;
    m_at += word.size();
    return true;
}
void Parser::require(std::string_view sign) {
    if (take(sign)) return;
    fail(m_at, "found " + rest(), fmt::format("'{}'", sign));
}
std::string_view Parser::takeUntil(std::string_view ends, std::size_t& start) {
    skipBlanks();
    start = m_at;
    m_at = std::min(m_text.find_first_of(ends, m_at), m_text.size());
    return withoutBlanks(m_text.substr(start, m_at - start));
}

void Parser::wantDrawn() {
    m_buffers.set(index(pipeline::BufferId::PolygonId));
    // Where only translucent surfaces are seen no polygon stands, and yet something was drawn.
    if (!translucentSides(*m_scene).empty()) m_buffers.set(index(pipeline::BufferId::Layers));
}

void Parser::countOperators(int more) {
    m_operators += more;
    if (m_operators > kOperators) fail(m_at, "found more than 500 operators", "a shorter formula");
}

void Parser::need(Type type, const Node& node) {
    if (!m_error && node.type != type)
        fail(node.where, "found " + std::string(nameOf(node.type)), expectedOf(type, node.type));
}

Node Parser::made(Kind kind, Type type, std::vector<Node> operands) {
    countOperators(1);
    Node node;
    node.kind = kind;
    node.type = type;
    node.where = operands.front().where;
    for (const Node& operand : operands) node.varies |= operand.varies;
    if (type == Type::Vector)
        for (const Node& operand : operands) node.size = std::max(node.size, operand.size);
    node.operands = std::move(operands);
    return node;
}

namespace {
std::vector<Node> both(Node left, Node right) {
    std::vector<Node> nodes;
    nodes.reserve(2);
    nodes.push_back(std::move(left));
    nodes.push_back(std::move(right));
    return nodes;
}
std::vector<Node> one(Node operand) {
    std::vector<Node> nodes;
    nodes.push_back(std::move(operand));
    return nodes;
}
}  // namespace

Node Parser::either() {
    Node left = both();
    while (takeWord(kOr[0]) || takeWord(kOr[1])) {
        need(Type::Truth, left);
        Node right = both();
        need(Type::Truth, right);
        left = made(Kind::Or, Type::Truth, lessons::both(std::move(left), std::move(right)));
    }
    return left;
}

Node Parser::both() {
    Node left = negation();
    while (takeWord(kAnd[0]) || takeWord(kAnd[1])) {
        need(Type::Truth, left);
        Node right = negation();
        need(Type::Truth, right);
        left = made(Kind::And, Type::Truth, lessons::both(std::move(left), std::move(right)));
    }
    return left;
}

Node Parser::negation() {
    skipBlanks();
    const std::size_t at = m_at;
    if (m_text.substr(at).starts_with("!=") || !(take("!") || takeWord("not"))) return comparison();
    const Deeper deeper(*this);
    Node inner = negation();
    need(Type::Truth, inner);
    Node node = made(Kind::Not, Type::Truth, one(std::move(inner)));
    node.where = placeOf(at);
    return node;
}

Node Parser::comparison() {
    Node left = sum();
    skipBlanks();
    const auto found = std::ranges::find_if(kComparisons, [text = m_text.substr(m_at)](const Comparison& comparison) {
        return text.starts_with(comparison.text);
    });
    if (found == kComparisons.end()) return left;
    m_at += found->text.size();
    const bool ofEquality = found->kind == Kind::Equal || found->kind == Kind::NotEqual;
    if (const auto words = wordsFor(left)) {
        if (!ofEquality) fail(left.where, "found words", "a number, or one of = !=");
        Node right = wordAgainst(left, *words);
        return made(found->kind, Type::Truth, lessons::both(std::move(left), std::move(right)));
    }
    Node right = sum();
    if (!ofEquality || left.type != Type::Vector) {
        need(Type::Number, left);
        need(Type::Number, right);
    } else if (right.type != Type::Vector || right.size != left.size) {
        fail(right.where, "found " + std::string(nameOf(right.type)), "a vector of as many numbers");
    }
    return made(found->kind, Type::Truth, lessons::both(std::move(left), std::move(right)));
}

Node Parser::sum() {
    Node left = product();
    for (;;) {
        const bool plus = take("+");
        if (!plus && !take(kMinus[0]) && !take(kMinus[1])) return left;
        Node right = product();
        for (const Node* side : {&left, &right})
            if (side->type != Type::Vector) need(Type::Number, *side);
        if (!m_error && (left.type != right.type || left.size != right.size)) {
            if (left.type == Type::Vector && right.type == Type::Vector)
                fail(right.where, "found a vector of " + std::to_string(right.size) + " numbers",
                     "one of " + std::to_string(left.size));
            else
                need(Type::Number, left.type == Type::Vector ? left : right);
        }
        const Type type = left.type;
        left = made(plus ? Kind::Add : Kind::Subtract, type, lessons::both(std::move(left), std::move(right)));
    }
}

Node Parser::product() {
    Node left = sign();
    for (;;) {
        const bool times = take(kTimes[0]) || take(kTimes[1]);
        if (!times && !take("/")) return left;
        Node right = sign();
        if (left.type != Type::Vector) need(Type::Number, left);
        if (!times || right.type != Type::Vector || left.type == Type::Vector) need(Type::Number, right);
        const Type type = left.type == Type::Vector || right.type == Type::Vector ? Type::Vector : Type::Number;
        left = made(times ? Kind::Multiply : Kind::Divide, type, lessons::both(std::move(left), std::move(right)));
    }
}

Node Parser::sign() {
    skipBlanks();
    const std::size_t at = m_at;
    if (!take(kMinus[0]) && !take(kMinus[1])) return power();
    const Deeper deeper(*this);
    Node inner = sign();
    if (inner.type != Type::Vector) need(Type::Number, inner);
    const Type type = inner.type;
    Node node = made(Kind::Negate, type, one(std::move(inner)));
    node.where = placeOf(at);
    return node;
}

Node Parser::power() {  // binds to the right: 2^3^2 is 2^9
    Node base = component();
    if (!take("^")) return base;
    need(Type::Number, base);
    const Deeper deeper(*this);
    Node exponent = sign();
    need(Type::Number, exponent);
    return made(Kind::Power, Type::Number, lessons::both(std::move(base), std::move(exponent)));
}

Node Parser::component() {
    Node of = primary();
    if (of.type != Type::Vector || m_error || m_at >= m_text.size() || m_text[m_at] != '.') return of;
    ++m_at;
    const int found = channel(of.size, "the vector has " + std::to_string(of.size) + " numbers");
    Node node = made(Kind::Component, Type::Number, one(std::move(of)));
    node.channel = found;
    return node;
}

Node Parser::primary() {
    skipBlanks();
    const std::size_t at = m_at;
    if (take("(")) {
        const Deeper deeper(*this);
        Node inner = either();
        require(")");
        inner.where = placeOf(at);
        return inner;
    }
    if (take("[")) return vector();
    if (at < m_text.size() && std::isalpha(static_cast<unsigned char>(m_text[at]))) return named();
    return number();
}

Node Parser::number() {
    Node node;
    node.where = placeOf(m_at);
    const pipeline::LeadingNumber read = pipeline::leadingNumber(m_text.substr(m_at));
    node.number = read.value;
    if (read.length == 0 || !read.fits || !std::isfinite(node.number))
        fail(m_at, "found " + rest(),
             m_elements ? "a number, a buffer, a function or '('" : "a number, a function or '('");
    else
        m_at += read.length;
    return node;
}

Node Parser::vector() {
    const Deeper deeper(*this);
    const pipeline::SourceLocation where = placeOf(m_at - 1);
    std::vector<Node> numbers;
    do {
        numbers.push_back(sum());
        need(Type::Number, numbers.back());
    } while (!m_error && numbers.size() < 4 && take(","));
    require("]");
    if (numbers.size() == 1) fail(where, "found a vector of one number", "2 to 4 numbers");
    Node node = made(Kind::Vector, Type::Vector, std::move(numbers));
    node.size = int(node.operands.size());
    node.where = where;
    return node;
}

pipeline::Result<Expression> parseExpression(std::string_view text, const pipeline::SourceLocation& where,
                                             const Scope& scope) {
    return Parser(text, where, scope, false).parse({});
}
pipeline::Result<Expression> parseCondition(std::string_view text, const pipeline::SourceLocation& where,
                                            const Scope& scope) {
    return Parser(text, where, scope, true).parse(Type::Truth);
}
pipeline::Result<Expression> parseNumbers(std::string_view text, const pipeline::SourceLocation& where,
                                          const Scope& scope) {
    return Parser(text, where, scope, true).parse(Type::Number);
}

}  // namespace lessons
