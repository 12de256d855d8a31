#pragma once
#include <cairo.h>

#include <memory>
#include <string>

#include "pipeline/buffers/buffer2d.h"
#include "pipeline/steps/algorithm.h"

namespace pipeline {

// A strip of words below a film's picture, light on dark.
class FilmText {
public:
    FilmText(int width, int height);

    enum class Face : unsigned char { Words, Code, BoldCode };
    void setFace(Face face, double size);  // pixels
    double widthOf(const std::string& text) const;
    // base: of the line, from the strip's top. grey: 0 to 1.
    void write(double x, double base, const std::string& text, double grey = 0.92);
    void fill(int top, int height, double grey);
    void copyTo(Buffer2D<Color8>& picture, int top) const;

private:
    struct Close {
        void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
        void operator()(cairo_t* context) const { cairo_destroy(context); }
    };
    int m_width, m_height;
    std::unique_ptr<cairo_surface_t, Close> m_surface;
    std::unique_ptr<cairo_t, Close> m_context;
};

// The algorithm of a step as such a strip, `lines` lines high; without a state empty.
int algorithmStripHeight(std::size_t lines);
void drawAlgorithmStrip(const std::optional<AlgorithmState>& state, std::size_t lines, int top,
                        Buffer2D<Color8>& picture);

}  // namespace pipeline
