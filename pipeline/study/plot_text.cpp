#include "pipeline/study/plot_text.h"

#include "pipeline/study/plot.h"

namespace pipeline {

std::string elided(const std::string& text, double size, double width) {
    if (textWidth(text, size) <= width) return text;
    std::string cut = text;
    do {
        while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xC0u) == 0x80u) cut.pop_back();
        if (!cut.empty()) cut.pop_back();
        while (!cut.empty() && (cut.back() == ' ' || cut.back() == ',')) cut.pop_back();
    } while (!cut.empty() && textWidth(cut + "\u2026", size) > width);
    return cut + "\u2026";
}

std::vector<std::string> wrapped(const std::string& text, double size, double width, std::size_t most) {
    std::vector<std::string> lines;
    std::size_t at = 0;
    while (at < text.size()) {
        std::size_t end = text.size();
        if (lines.size() + 1 < most)
            while (end != std::string::npos && end > at && textWidth(text.substr(at, end - at), size) > width)
                end = text.rfind(' ', end - 1);
        if (end == std::string::npos || end <= at) end = std::min(text.find(' ', at), text.size());
        if (lines.size() + 1 == most) end = text.size();
        lines.push_back(elided(text.substr(at, end - at), size, width));
        at = end + 1;
    }
    return lines;
}

}  // namespace pipeline
