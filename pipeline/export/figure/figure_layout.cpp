#include "pipeline/export/figure/figure_layout.h"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "pipeline/buffers/verdict.h"
#include "pipeline/core/printable.h"

namespace pipeline {
namespace {

constexpr double kPointsPerMm = 72 / 25.4;
constexpr int kScaleSteps = 4;  // five numbers beside the bar

bool hasBar(const Figure& figure) {
    const Palette palette = figure.buffer.info->palette;
    return figure.hasBar && palette != Palette::Color && palette != Palette::Direction;
}

std::string nameOfValue(Palette palette, int value) {
    constexpr std::array kShadow{"lit", "shadowed", "acne", "leak"};
    const auto known = [&](std::size_t count) { return value >= 0 && std::size_t(value) < count; };
    if (palette == Palette::Verdict && known(kVerdictCount)) return std::string(name(Verdict(value)));
    if (palette == Palette::ShadowVerdict && known(kShadow.size())) return kShadow[std::size_t(value)];
    if (palette == Palette::Truth) return value == 0 ? "false" : "true";
    return std::to_string(value);
}

std::vector<FigureLayout::Entry> namesOf(const Figure& figure, const FigureLayout& layout) {
    std::set<int> values;
    for (int y = 0; y < layout.rows; ++y)
        for (int x = 0; x < layout.columns; ++x) {
            const std::size_t column = std::size_t(layout.first.x + x), row = std::size_t(layout.first.y + y);
            if (figure.seen && figure.seen->value(column, row) < 0) continue;
            const double value = figure.buffer.value(column, row);
            if (value >= 0) values.insert(int(value));
        }
    std::vector<FigureLayout::Entry> entries;
    for (const int value : values) entries.push_back({double(value), nameOfValue(figure.buffer.info->palette, value)});
    return entries;
}

// Enough digits to tell neighbours apart, and two more where there is room for them.
std::vector<FigureLayout::Entry> numbersOf(PaletteRange range) {
    const double step = std::abs(range.last - range.first) / kScaleSteps;
    const double largest = std::max(std::abs(range.first), std::abs(range.last));
    const bool isPlain = largest < 1e6 && step >= 1e-4;
    const int decimals = step > 0 && isPlain ? std::max(0, 1 - int(std::floor(std::log10(step)))) : 0;
    std::vector<FigureLayout::Entry> entries;
    for (int i = 0; i <= kScaleSteps; ++i) {
        const double t = double(i) / kScaleSteps;
        const double value = (1 - t) * range.first + t * range.last;
        entries.push_back({value, isPlain ? fmt::format("{:.{}f}", value, decimals) : fmt::format("{:.4g}", value)});
    }
    if (step == 0) entries.resize(1);
    return entries;
}

// Lines as wide as the figure; a word that is wider is cut.
std::vector<std::string> wrapped(cairo_t* metrics, const std::string& text, double width) {
    std::vector<std::string> lines(1);
    const auto put = [&](const std::string& piece) {
        if (widthOf(metrics, lines.back() + piece) <= width) return lines.back() += piece, true;
        return false;
    };
    std::string word;
    const auto end = [&] {
        const bool begins = lines.back().empty();
        if (word.empty() || put(begins ? word : ' ' + word)) return word.clear();
        if (!begins) lines.emplace_back();
        for (std::string_view rest = word; !rest.empty();) {
            const std::string letter(rest.substr(0, std::max<std::size_t>(1, printableLength(rest))));
            if (!put(letter)) lines.push_back(letter);
            rest.remove_prefix(letter.size());
        }
        word.clear();
    };
    for (const char letter : escaped(text, "\n")) {
        if (letter != ' ' && letter != '\n') {
            word += letter;
            continue;
        }
        end();
        if (letter == '\n') lines.emplace_back();
    }
    end();
    return lines;
}

}  // namespace

void setLetters(cairo_t* context, const Figure& figure, bool bold) {
    cairo_select_font_face(context, "Inter", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, figure.letters);
}

double widthOf(cairo_t* context, const std::string& text) {
    cairo_text_extents_t extents;
    cairo_text_extents(context, text.c_str(), &extents);
    return extents.x_advance;
}

std::string valueText(const AnyBuffer& buffer, glm::ivec2 at) {
    std::string text;
    for (int c = 0; c < buffer.channels(); ++c) {
        const double value = buffer.value(std::size_t(at.x), std::size_t(at.y), c);
        if (c > 0) text += ", ";
        if (std::isnan(value))
            text += "NaN";
        else if (std::isinf(value))
            text += value > 0 ? "+∞" : "−∞";
        else
            text += fmt::format("{:.5g}", value);
    }
    return text;
}

FigureLayout layOut(const Figure& figure, cairo_t* metrics) {
    FigureLayout layout;
    const double em = figure.letters;
    layout.width = figure.width * kPointsPerMm;
    layout.edge = 0.6 * em, layout.lineHeight = 1.35 * em;
    layout.left = layout.top = layout.edge;
    layout.columns = int(figure.buffer.columns()), layout.rows = int(figure.buffer.rows());
    if (figure.part) {
        layout.first = figure.part->first;
        layout.columns = figure.part->last.x - figure.part->first.x + 1;
        layout.rows = figure.part->last.y - figure.part->first.y + 1;
    }
    setLetters(metrics, figure);
    double beside = 0;
    if (hasBar(figure)) {
        layout.isOfNames = isOfNames(*figure.buffer.info);
        layout.scale = layout.isOfNames ? namesOf(figure, layout) : numbersOf(figure.range);
        layout.unit = figure.buffer.info->unit;
        layout.barWidth = 1.2 * em;
        double widest = 0;
        for (const auto& entry : layout.scale) widest = std::max(widest, widthOf(metrics, entry.text));
        beside = std::max(layout.barWidth + 0.5 * em + widest, layout.unit.empty() ? 0 : widthOf(metrics, layout.unit));
        beside += layout.edge;
    }
    layout.pixel = (layout.width - 2 * layout.edge - beside) / layout.columns;
    const double height = layout.pictureHeight();
    layout.barLeft = layout.left + layout.pictureWidth() + layout.edge;
    layout.barHeight = height - (layout.unit.empty() ? 0 : 1.6 * em);
    if (layout.isOfNames) {
        const auto room = std::size_t(std::max(1.0, std::floor(layout.barHeight / (1.6 * em))));
        if (layout.scale.size() > room) {
            layout.namesLeftOut = layout.scale.size() - (room - 1);
            layout.scale.resize(room - 1);
        }
    }
    layout.captionTop = layout.top + height + layout.edge;
    layout.height = layout.captionTop;
    if (!figure.caption.empty()) {
        layout.caption = wrapped(metrics, figure.caption, layout.width - 2 * layout.edge);
        layout.height += layout.lineHeight * double(layout.caption.size()) + layout.edge;
    }
    return layout;
}

}  // namespace pipeline
