#pragma once
#include <QColor>
#include <QFont>
#include <QObject>
#include <QPalette>
#include <array>

#include "pipeline/inspect/formula.h"

namespace app {

enum class ThemeId { Dark, Light, Projector };

// The colours of one theme, with the names of the design's table.
struct ThemeColors {
    QColor bg, surface, raised, hover, view, hatch, line, outline, text, text2, text3, accent, fill, onFill, tint, run,
        reused, leftOut, failed, warn, focus;
    QColor N, L, V, R, H;
};

// The current theme and its text size: one object for the program, not passed around because every painter needs it.
// Widgets repaint on changed(). Other threads use a look of their own.
class Theme : public QObject {
    Q_OBJECT
public:
    static Theme& current();

    struct Look {
        ThemeId id;
        double scale;
        bool operator==(const Look&) const = default;
    };
    Look look() const { return s_worn ? *s_worn : Look{m_id, m_scales[std::size_t(m_id)]}; }
    ThemeId id() const { return look().id; }
    void set(ThemeId id);
    // The largest scale suits 3840 × 2160 pixels on a screen without scaling: 2 % of the height is 44 pixels for a
    // letter of 12.
    static constexpr double kLeastScale = 0.85, kMostScale = 4;
    // Within these limits. Each theme keeps its own scale; the projector's starts at 1.25.
    double scale() const { return look().scale; }
    void setScale(double scale);  // clamped, in steps of 0.05
    // Sets palette, font and style sheet of the application, and emits changed(). set and setScale call it too;
    // otherwise call it once at the start.
    void apply();

    const ThemeColors& colors() const { return colors(id()); }
    static const ThemeColors& colors(ThemeId id);
    QColor vector(pipeline::VectorCode code) const;  // text colour for VectorCode::None
    // The dash of a vector's shaft and of its underline, in pen widths; empty for a solid line.
    static QList<qreal> dash(pipeline::VectorCode code);

    int px(double logicalPixels) const;                    // scaled and rounded
    QFont text(double size = 13, int weight = 400) const;  // Inter
    QFont mono(double size = 13) const;                    // JetBrains Mono, ligatures off
    QFont formula(double size = 18) const;                 // STIX
    QPalette palette() const;
    QString styleSheet() const;

signals:
    void changed();

private:
    friend class WornLook;
    Theme() = default;
    static thread_local const Look* s_worn;  // null in the window's own thread
    ThemeId m_id = ThemeId::Light;
    std::array<double, 3> m_scales{1.0, 1.0, 1.25};
};

}  // namespace app
