// A ViewTree as text, and back.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "lessons/state/view_tree.h"
#include "pipeline/core/text.h"

namespace lessons {

using Kind = ViewTree::Kind;
using pipeline::Error;

namespace {

constexpr int kDeepest = 16, kMostWeight = 1000000;

class Parser {
public:
    explicit Parser(std::string_view text) : m_text(text) {}

    pipeline::Result<ViewTree> whole() {
        ViewTree tree = list(0);
        if (m_expected.empty() && !peek().empty()) expect("| or /, or the end");
        if (m_expected.empty() && m_buffers + m_spaces > int(kMostViews))
            expect(fmt::format("at most {} views", kMostViews));
        if (m_expected.empty()) return tree;
        return Error{{}, "arrangement is " + pipeline::inQuotes(m_text), m_expected};
    }

private:
    // The next word or sign, without taking it; empty at the end.
    std::string_view peek() const {
        std::size_t begin = m_at, end = 0;
        while (begin < m_text.size() && m_text[begin] == ' ') ++begin;
        const auto isWord = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); };
        for (end = begin; end < m_text.size() && isWord(m_text[end]);) ++end;
        return m_text.substr(begin, end == begin ? (begin < m_text.size() ? 1 : 0) : end - begin);
    }
    std::string_view take() {
        const std::string_view word = peek();
        m_at = std::size_t(word.data() - m_text.data()) + word.size();
        return word;
    }
    void expect(std::string what) {
        if (m_expected.empty()) m_expected = std::move(what);
    }

    ViewTree list(int depth) {
        ViewTree first = part(depth);
        const std::string_view sign = peek();
        if (sign != "|" && sign != "/") {
            first.weight = 1;  // beside nothing
            return first;
        }
        ViewTree all{sign == "|" ? Kind::Row : Kind::Column, {}, 1, {}};
        add(all, std::move(first));
        while (m_expected.empty() && peek() == sign) {
            take();
            add(all, part(depth));
        }
        if (peek() == "|" || peek() == "/") expect("parentheses where | and / meet");
        return all;
    }
    // (buffer | buffer) | 3d is one row.
    void add(ViewTree& all, ViewTree part) {
        if (part.kind == all.kind && part.kind != Kind::Leaf) expect("no parentheses around a row within a row");
        all.parts.push_back(std::move(part));
    }
    ViewTree part(int depth) {
        int weight = 1;
        std::string_view word = take();
        if (!word.empty() && word[0] >= '1' && word[0] <= '9' && peek() == ":") {
            const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), weight);
            if (error != std::errc() || end != word.data() + word.size() || weight > kMostWeight)
                expect(fmt::format("a weight from 1 to {}", kMostWeight));
            take();
            word = take();
        }
        ViewTree made;
        if (word == "buffer")
            made.leaf = {ViewLeaf::Kind::Buffer, m_buffers++};
        else if (word == "3d")
            made.leaf = {ViewLeaf::Kind::Space, m_spaces++};
        else if (word == "(" && depth < kDeepest) {
            made = list(depth + 1);
            if (take() != ")") expect("a closing parenthesis");
        } else
            expect("a name, or buffer and 3d with | and / between them");
        made.weight = weight;
        return made;
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    int m_buffers = 0, m_spaces = 0;
    std::string m_expected;  // of the first thing that is wrong
};

std::string write(const ViewTree& tree) {
    if (tree.kind == Kind::Leaf) return tree.leaf.kind == ViewLeaf::Kind::Buffer ? "buffer" : "3d";
    const auto isOther = [&](const ViewTree& part) { return part.weight != tree.parts.front().weight; };
    const bool weighs = std::ranges::any_of(tree.parts, isOther);
    std::string words;
    for (const ViewTree& part : tree.parts) {
        if (!words.empty()) words += tree.kind == Kind::Row ? " | " : " / ";
        if (weighs) words += fmt::format("{}: ", part.weight);
        words += part.kind == Kind::Leaf ? write(part) : fmt::format("({})", write(part));
    }
    return words;
}

}  // namespace

std::string text(const ViewTree& tree) { return write(tree); }

pipeline::Result<ViewTree> parseViewTree(std::string_view text) { return Parser(text).whole(); }

}  // namespace lessons
