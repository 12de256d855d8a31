#pragma once
#include <string>
#include <vector>

#include "pipeline/export/figure/figure.h"

struct _cairo;

namespace pipeline {

// Where the parts of a figure are, in pt from its top left corner.
struct FigureLayout {
    double width = 0, height = 0;
    double edge = 0;                      // between parts
    double left = 0, top = 0, pixel = 0;  // of the picture; a pixel's side
    int columns = 0, rows = 0;            // drawn
    glm::ivec2 first{0};                  // column and row drawn at the top left
    double pictureWidth() const { return pixel * columns; }
    double pictureHeight() const { return pixel * rows; }
    struct Entry {
        double value;
        std::string text;
    };
    std::vector<Entry> scale;  // of the bar, from the top; of names one each
    bool isOfNames = false;
    std::size_t namesLeftOut = 0;  // for lack of room
    double barLeft = 0, barWidth = 0, barHeight = 0;
    std::string unit;
    std::vector<std::string> caption;  // its lines
    double lineHeight = 0, captionTop = 0;
};

// `metrics` measures text; it is not drawn to.
FigureLayout layOut(const Figure& figure, _cairo* metrics);
// A value of the buffer as text: all channels, "NaN", "+∞".
std::string valueText(const AnyBuffer& buffer, glm::ivec2 at);

void setLetters(_cairo* context, const Figure& figure, bool bold = false);
double widthOf(_cairo* context, const std::string& text);

}  // namespace pipeline
