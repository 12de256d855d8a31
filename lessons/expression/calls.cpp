// What stands in a call: values, buffers, settings, stages, changes, fields, places.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "lessons/expression/changed_frames.h"
#include "lessons/expression/parser.h"
#include "pipeline/core/text.h"
#include "pipeline/plan/needs.h"

namespace lessons {

using pipeline::inQuotes;
using Kind = Node::Kind;

Node Parser::call(std::string_view name, std::size_t at) {
    const Deeper deeper(*this);
    Node node;
    node.kind = Kind::Call;
    node.where = placeOf(at);
    countOperators(1);
    const auto table = functionTable();
    const auto found = std::ranges::find(table, name, &Function::name);
    if (found == table.end()) {
        failUnknown(at, "function", name, namesIn(table, [](const Function& f) { return f.name; }));
        return node;
    }
    node.function = &*found;
    node.type = found->gives;
    arguments(node);
    require(")");
    if (!fieldsOf(found->takes).empty()) field(node);
    if (!m_error) checkPlace(node);
    return node;
}

void Parser::arguments(Node& node) {
    switch (node.function->takes) {
        case Takes::Number: return values(node, 1, Type::Number);
        case Takes::TwoNumbers: return values(node, 2, Type::Number);
        case Takes::Vector: return values(node, 1, Type::Vector);
        case Takes::TwoVectors: return values(node, 2, Type::Vector);
        case Takes::Choice: return choice(node);
        case Takes::Buffer:
            buffer(node, ",)");
            if (!m_error && take(",")) {
                skipBlanks();
                node.channel =
                    channel(bufferInfo(node.buffer->id).channels, node.buffer->text() + " has one value a place");
            }
            if (node.type == Type::Vector) node.size = 2;  // a place
            return;
        case Takes::Element: return element(node);
        case Takes::ElementCondition:
        case Takes::PixelCondition: return condition(node);
        case Takes::PixelField: return values(node, 2, Type::Number);
        case Takes::FragmentField: return values(node, 3, Type::Number);
        case Takes::Polygon: return values(node, 1, Type::Number);
        case Takes::Setting: return setting(node);
        case Takes::Stage: return stage(node);
        case Takes::Changes: return changed(node);
        case Takes::BufferChanges: {
            buffer(node, ";,)");
            const auto scene = changes(node, ")");
            if (!m_error) node.changed.set(index(node.buffer->id));
            return;
        }
        case Takes::AllChanges: {
            const auto scene = changes(node, ")");
            if (m_error) return;
            node.changed = pipeline::usefulBuffers(*scene);
            m_buffers |= pipeline::usefulBuffers(*m_scene);
            return;
        }
    }
}

void Parser::values(Node& node, int count, Type type) {
    for (int i = 0; i < count; ++i) {
        if (i > 0) require(",");
        node.operands.push_back(sum());
        const Node& given = node.operands.back();
        need(type, given);
        node.varies |= given.varies;
        if (!m_error && given.varies && !node.function->calculate)
            fail(given.where, fmt::format("{} is asked of one place, not of each pixel", node.function->name),
                 "numbers that are the same for every pixel");
    }
    if (m_error || type != Type::Vector) return;
    if (node.operands[0].size != node.operands.back().size)
        fail(node.operands.back().where, fmt::format("found a vector of {} numbers", node.operands.back().size),
             fmt::format("one of {}", node.operands[0].size));
    if (node.type != Type::Vector) return;
    node.size = node.operands[0].size;
    if (node.function->name == "cross" && node.size != 3)
        fail(node.operands[0].where, fmt::format("found a vector of {} numbers", node.size), "one of 3");
}

void Parser::choice(Node& node) {
    node.operands.push_back(either());
    need(Type::Truth, node.operands[0]);
    for (int i = 0; i < 2; ++i) {
        require(",");
        node.operands.push_back(either());
    }
    if (m_error) return;
    const Node &yes = node.operands[1], &no = node.operands[2];
    if (yes.type != no.type || yes.size != no.size)
        fail(no.where, "found something of another kind than before the comma", "the same kind for both");
    node.type = yes.type;
    node.size = yes.size;
    node.varies = std::ranges::any_of(node.operands, &Node::varies);
}

void Parser::buffer(Node& node, std::string_view ends) {
    std::size_t start = 0;
    const std::string_view name = takeUntil(ends, start);
    node.buffer = pipeline::findBuffer(name);
    if (!node.buffer) return fail(start, "no buffer " + inQuotes(name) + "; " + pipeline::insteadOfBuffer(name));
    if (node.buffer->light >= int(m_scene->lights.size()))
        fail(start, fmt::format("no buffer {}: this scene has {}", inQuotes(name),
                                pipeline::plural(std::int64_t(m_scene->lights.size()), "light")));
    m_buffers.set(index(node.buffer->id));
}

int Parser::channel(int channels, const std::string& otherwise) {
    const std::size_t start = m_at;
    while (m_at < m_text.size() && std::isalnum(static_cast<unsigned char>(m_text[m_at]))) ++m_at;
    const std::string_view text = m_text.substr(start, m_at - start);
    const auto letter = text.size() == 1 ? kChannelLetters.find(text[0]) : text.npos;
    if (letter == text.npos) {
        fail(start, "found " + inQuotes(text), "a channel: r, g, b, x, y, z, 0, 1 or 2");
        return 0;
    }
    const int found = int(letter % 3);
    if (found >= channels) fail(start, "no channel " + inQuotes(text) + ": " + otherwise);
    return found;
}

void Parser::element(Node& node) {
    buffer(node, ",)");
    if (m_error) return;
    const pipeline::BufferInfo& info = pipeline::bufferInfo(node.buffer->id);
    const bool picture = info.domain == pipeline::Domain::Pixel || info.domain == pipeline::Domain::Texel;
    require(",");
    values(node, picture ? 2 : 1, Type::Number);
    if (take(",")) {
        skipBlanks();
        node.channel = channel(info.channels, node.buffer->text() + " has one value a place");
    }
    node.size = node.channel ? 1 : info.channels;
    node.type = node.size == 1 ? Type::Number : Type::Vector;
}

void Parser::condition(Node& node) {
    const bool pixels = node.function->takes == Takes::PixelCondition;
    const auto outside = std::exchange(m_elements, Elements{pixels, {}});
    node.operands.push_back(either());
    need(Type::Truth, node.operands[0]);
    if (!m_error && !m_elements->like && !m_elements->pixels)
        fail(node.operands[0].where, "found no buffer", "a comparison such as overdraw > 1");
    if (pixels) wantDrawn();
    m_elements = outside;
}

void Parser::setting(Node& node) {
    std::size_t start = 0;
    const std::string_view key = takeUntil(",)", start);
    const auto found = pipeline::findSetting(*m_scene, key);
    if (!found) return fail(start, found.errors().front().found, found.errors().front().expected);
    node.setting = *found;
    node.type = found->setting->choices.empty() ? Type::Number : Type::Words;
}

void Parser::stage(Node& node) {
    std::size_t start = 0;
    const std::string_view name = takeUntil(",)", start);
    node.stage = pipeline::findStage(name);
    if (!node.stage)
        failUnknown(start, "stage", name,
                    namesIn(pipeline::kStages, [](pipeline::StageId s) { return pipeline::stageInfo(s).name; }));
}

// "KEY=VALUE, KEY=VALUE" up to `end`, and the scene after them.
pipeline::Result<pipeline::Scene> Parser::changes(Node& node, std::string_view end) {
    if (node.buffer) require(";");
    const std::size_t first = m_at;
    const std::string ends = fmt::format(",{}", end);
    do {
        std::size_t start = 0;
        const std::string_view text = takeUntil(ends, start);
        const std::size_t sign = text.find('=');
        const auto isBlank = [](char c) { return c == ' ' || c == '\t'; };
        std::string change(text);
        std::erase_if(change, isBlank);
        if (sign == text.npos) fail(start, "found " + inQuotes(text), "KEY=VALUE");
        node.changes.push_back(std::move(change));
    } while (!m_error && take(","));
    auto scene = withChanges(*m_scene, node.changes);
    if (!scene) fail(first, scene.errors().front().found, scene.errors().front().expected);
    return scene;
}

// The expression is read in the scene as changed, and asks the frame of that scene for its buffers.
void Parser::changed(Node& node) {
    auto scene = changes(node, ";");
    require(";");
    if (m_error) return;
    m_changedScenes.push_back(std::move(scene).value());
    const auto outside = std::exchange(m_scene, &m_changedScenes.back());
    const pipeline::BufferSet buffers = std::exchange(m_buffers, {});
    const auto elements = std::exchange(m_elements, std::nullopt);
    node.operands.push_back(either());
    m_scene = outside;
    node.changed = std::exchange(m_buffers, buffers);
    m_elements = elements;
    node.type = node.operands[0].type;
    node.size = node.operands[0].size;
}

void Parser::field(Node& node) {
    require(".");
    if (m_error) return;
    const std::size_t start = m_at;
    while (m_at < m_text.size() && (std::isalpha(static_cast<unsigned char>(m_text[m_at])) || m_text[m_at] == '_'))
        ++m_at;
    node.word = m_text.substr(start, m_at - start);
    const auto fields = fieldsOf(node.function->takes);
    if (std::ranges::find(fields, node.word) == fields.end())
        fail(start, std::string(node.function->name) + " has no " + inQuotes(node.word) + "; " +
                        pipeline::insteadOf(node.word, namesIn(fields, [](std::string_view f) { return f; })));
    if (node.word == "comparison" || node.word == "verdict") node.type = Type::Words;
}

// A place that is written as a number is checked here; a computed one when it is evaluated.
void Parser::checkPlace(const Node& node) {
    const auto check = [&](const Node& operand, double count, const char* what) {
        if (operand.kind != Kind::Number || m_error) return;
        if (operand.number >= 0 && operand.number < count && operand.number == std::trunc(operand.number)) return;
        fail(operand.where, "found " + pipeline::shortestText(operand.number),
             std::string(what) + " from 0 to " + pipeline::shortestText(count - 1));
    };
    double vertices = 0, polygons = 0;
    for (const pipeline::Object& object : m_scene->objects) {
        vertices += double(object.mesh->positions.size());
        polygons += double(object.mesh->polygonCount());
    }
    const auto checkPixel = [&] {
        check(node.operands[0], m_scene->settings.width, "x");
        check(node.operands[1], m_scene->settings.height, "y");
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

}  // namespace lessons
