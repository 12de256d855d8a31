// Names in an expression: buffers at an element, what was picked, names that a lesson gives, and words.
#include <algorithm>
#include <array>
#include <cctype>
#include <numbers>

#include <fmt/format.h>

#include "lessons/expression/parser.h"
#include "pipeline/core/text.h"
#include "pipeline/stages/cull.h"

namespace lessons {

using pipeline::BufferName;
using pipeline::inQuotes;
using Kind = Node::Kind;

namespace {

bool isNamePart(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.'; }

std::vector<std::string> verdictNames() {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < pipeline::kVerdictCount; ++i) names.emplace_back(name(pipeline::Verdict(i)));
    return names;
}

// Whether two buffers have their numbers at the same elements.
bool haveSameElements(const BufferName& a, const BufferName& b) {
    const pipeline::Domain domain = bufferInfo(a.id).domain;
    return domain == bufferInfo(b.id).domain && (domain != pipeline::Domain::Texel || a.light == b.light);
}

}  // namespace

std::string whyNoName(std::string_view name) {
    const bool isWord = !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) &&
                        std::ranges::all_of(name, [](char c) { return isNamePart(c) && c != '.'; });
    if (!isWord) return "A name has letters, digits and _, and begins with a letter.";
    constexpr std::array<std::string_view, 7> kTaken{"x", "y", "pi", "pick", "and", "or", "not"};
    if (std::ranges::find(kTaken, name) != kTaken.end()) return "The name means something already.";
    if (pipeline::findBuffer(name) || pipeline::findBuffer(std::string(name) + ".0")) return "A buffer has this name.";
    for (const pipeline::BufferInfo& info : pipeline::bufferTable())  // "polygons" would hide "polygons.verdict"
        if (info.name.starts_with(std::string(name) + '.')) return "Buffers' names begin with it.";
    if (std::ranges::find(functionTable(), name, &Function::name) != functionTable().end())
        return "A function has this name.";
    return {};
}

Node Parser::named() {
    const std::size_t at = m_at;
    while (m_at < m_text.size() && isNamePart(m_text[m_at])) ++m_at;
    const std::string_view name = m_text.substr(at, m_at - at), front = name.substr(0, name.find('.'));
    if (take("(")) return call(name, at);
    Node node;
    node.where = placeOf(at);
    if (name == "pi") {
        node.number = std::numbers::pi;
        return node;
    }
    if (front == "pick") return pickNamed(name.substr(std::min(name.size(), front.size() + 1)), at);
    if (m_scope.names)
        if (const auto found = m_scope.names->find(front); found != m_scope.names->end()) {
            m_at = at + front.size();  // a component may follow
            countOperators(found->second.operators);
            m_buffers |= found->second.buffers;
            node = found->second.root;
            node.where = placeOf(at);
            return node;
        }
    if (m_elements) return elementNamed(name, at);
    if (pipeline::findBuffer(name))
        fail(at, fmt::format("found the buffer {} without a place", inQuotes(name)),
             fmt::format("buffer({0}, …), largest({0}) or count({0} > …)", name));
    std::vector<std::string> known = namesIn(functionTable(), [](const Function& f) { return f.name; });
    if (m_scope.names)
        for (const auto& [given, expression] : *m_scope.names) known.push_back(given);
    failUnknown(at, m_scope.names ? "function or name" : "function", name, known);
    return node;
}

Node Parser::pickNamed(std::string_view field, std::size_t at) {
    Node node;
    node.kind = Kind::Picked;
    node.where = placeOf(at);
    if (!m_scope.mayPick) fail(at, "found \"pick\" where nothing is picked", "it in a question that asks for a click");
    const auto fields = pickFields();
    const auto found = std::ranges::find(fields, field, &PickField::name);
    if (found == fields.end())
        failUnknown(at, "pick.…", field, namesIn(fields, [](const PickField& f) { return f.name; }));
    else
        node.picked = &*found;
    return node;
}

std::optional<BufferName> Parser::findHere(std::string_view name) const {
    if (const auto found = pipeline::findBuffer(name)) return found;
    return m_scene->lights.size() == 1 ? pipeline::findBuffer(std::string(name) + ".0") : std::nullopt;
}

// "n_dot_l.0", "normal.x"; where there is one light, "n_dot_l" and "diffuse.r" too.
Node Parser::elementNamed(std::string_view name, std::size_t at) {
    Node node;
    node.where = placeOf(at);
    node.varies = true;
    const auto isPixel = [](const BufferName& b) { return bufferInfo(b.id).domain == pipeline::Domain::Pixel; };
    if (name == "x" || name == "y") {
        if (!m_elements->pixels && m_elements->like && !isPixel(*m_elements->like))
            fail(at, inQuotes(name) + " is of a pixel, and " + m_elements->like->text() + " is not per pixel");
        m_elements->pixels = true;
        node.kind = name == "x" ? Kind::Column : Kind::Row;
        return node;
    }
    node.kind = Kind::Element;
    const std::size_t dot = name.rfind('.');
    const std::string_view last = dot == name.npos ? "" : name.substr(dot + 1), front = name.substr(0, dot);
    const auto letter = last.size() == 1 ? kChannelLetters.find(last[0]) : last.npos;
    node.buffer = findHere(name);
    if (!node.buffer && letter != last.npos) {
        node.buffer = findHere(front);
        node.channel = int(letter % 3);
    }
    if (!node.buffer) {
        const std::string light = std::string(name) + ".0";
        const std::size_t lights = m_scene->lights.size();
        if (pipeline::findBuffer(light) && lights != 1)
            fail(at, fmt::format("{} is of one light, and this scene has {}", inQuotes(name), lights),
                 lights == 0 ? std::string() : inQuotes(light));
        else
            fail(at, "no buffer " + inQuotes(name) + "; " + pipeline::insteadOfBuffer(name));
        return node;
    }
    const pipeline::BufferInfo& info = pipeline::bufferInfo(node.buffer->id);
    if (m_elements->pixels && !isPixel(*node.buffer))
        fail(at, inQuotes(name) + " does not stand on pixels", "a buffer of the picture");
    else if (m_elements->like && !haveSameElements(*m_elements->like, *node.buffer))
        fail(at, fmt::format("{} and {} have different elements", m_elements->like->text(), node.buffer->text()),
             "buffers of the same elements, as of pixels");
    if (node.buffer->light >= int(m_scene->lights.size()))
        fail(at, fmt::format("no buffer {}: this scene has {}", inQuotes(name),
                             pipeline::plural(std::int64_t(m_scene->lights.size()), "light")));
    if (node.channel && *node.channel >= info.channels)
        fail(at, "no channel " + inQuotes(last) + ": " + node.buffer->text() + " has one value a pixel");
    node.size = node.channel ? 1 : info.channels;
    node.type = node.size == 1 ? Type::Number : Type::Vector;
    if (!m_elements->like) m_elements->like = node.buffer;
    m_buffers.set(index(node.buffer->id));
    return node;
}

std::optional<std::vector<std::string>> Parser::wordsFor(const Node& node) const {
    if (node.kind == Kind::Element && node.buffer->id == pipeline::BufferId::PolygonsVerdict) return verdictNames();
    if (node.type != Type::Words) return {};
    if (node.setting) return namesIn(node.setting->setting->choices, [](std::string_view choice) { return choice; });
    if (node.function && node.function->name == "verdict") return verdictNames();
    if (node.function && node.function->name == "first_difference") {
        auto stages = namesIn(pipeline::kStages, [](pipeline::StageId s) { return pipeline::stageInfo(s).name; });
        stages.emplace_back("none");
        return stages;
    }
    return std::vector<std::string>();
}

// A verdict of an element stands for its number, which is what the buffer holds.
Node Parser::wordAgainst(const Node& node, const std::vector<std::string>& known) {
    skipBlanks();
    if (node.type == Type::Number && m_at < m_text.size() && std::isdigit(static_cast<unsigned char>(m_text[m_at])))
        return number();
    std::size_t start = 0;
    std::string_view text;
    if (take("\"")) {
        text = takeUntil("\"", start);
        require("\"");
    } else {
        text = takeUntil("),;]&|", start);
        for (const std::string_view sign : {" and ", " or "})
            if (const auto end = text.find(sign); end != text.npos) text = text.substr(0, end);
        m_at = start + text.size();
    }
    const auto found = std::ranges::find(known, text);
    if (!known.empty() && found == known.end()) failUnknown(start, node.setting ? "choice" : "verdict", text, known);
    Node word;
    word.where = placeOf(start);
    if (node.type == Type::Number) {
        word.number = double(found - known.begin());
        return word;
    }
    word.kind = Kind::Words;
    word.type = Type::Words;
    word.word = text;
    return word;
}

}  // namespace lessons
