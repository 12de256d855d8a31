#pragma once
#include <QColor>

// Colour science for the tests of the tokens, written from the standards alone.
namespace test {

// WCAG 2.1, relative luminance and contrast ratio, 1 to 21.
double luminance(const QColor& color);
double contrast(const QColor& a, const QColor& b);

// Colour vision, simulated in linear RGB with the matrices for severity 1 of G. M. Machado,
// M. M. Oliveira, L. A. F. Fernandes, "A Physiologically-based Model for Simulation of Color
// Vision Deficiency", IEEE TVCG 15 (2009).
enum class Vision { Normal, Protan, Deutan, Tritan };

// CIEDE2000 colour difference of two sRGB colours (D65, 2 degrees) as that vision sees them.
double deltaE00(const QColor& a, const QColor& b, Vision vision);

}  // namespace test
