#include "app/look/theme.h"

#include <QApplication>
#include <algorithm>
#include <cmath>

#include "app/look/style_sheet.h"

namespace app {

namespace {

QFont font(const QStringList& families, double pixels, int weight) {
    QFont font;
    font.setFamilies(families);
    font.setPixelSize(std::max(1, int(std::lround(pixels))));
    font.setWeight(QFont::Weight(weight));
    return font;
}

}  // namespace

thread_local const Theme::Look* Theme::s_worn = nullptr;

Theme& Theme::current() {
    static Theme theme;
    return theme;
}

void Theme::set(ThemeId id) {
    m_id = id;
    apply();
}

void Theme::setScale(double scale) {
    m_scales[std::size_t(m_id)] = std::clamp(std::round(scale * 20) / 20, kLeastScale, kMostScale);
    apply();
}

void Theme::apply() {
    if (qApp) {
        qApp->setPalette(palette());
        qApp->setFont(text());
        qApp->setStyleSheet(styleSheet());
    }
    emit changed();
}

const ThemeColors& Theme::colors(ThemeId id) {
    // clang-format off
    static const ThemeColors dark{
        .bg = 0x15171B, .surface = 0x1C1F24, .raised = 0x262A31, .hover = 0x31363F, .view = 0x101215,
        .hatch = 0x2B3038, .line = 0x353A43, .outline = 0x707986, .text = 0xE9EBEE, .text2 = 0xB4BBC6,
        .text3 = 0x929AA6, .accent = 0x7FB2FF, .fill = 0x2C67CF, .onFill = 0xFFFFFF, .tint = 0x22304A,
        .run = 0x62D39B, .reused = 0x9DB2CF, .leftOut = 0x929AA6, .failed = 0xFF857C, .warn = 0xF3C14B,
        .focus = 0x9CC4FF, .N = 0x8FDDFF, .L = 0xFFD98C, .V = 0x44A590, .R = 0xF07426, .H = 0x9D83F8};
    static const ThemeColors light{
        .bg = 0xE9ECEF, .surface = 0xF8F9FA, .raised = 0xFFFFFF, .hover = 0xE3E8EE, .view = 0xFFFFFF,
        .hatch = 0xE4E7EB, .line = 0xD0D5DC, .outline = 0x828A95, .text = 0x171A1F, .text2 = 0x4A525D,
        .text3 = 0x5E6672, .accent = 0x1B57BD, .fill = 0x1F5FCC, .onFill = 0xFFFFFF, .tint = 0xDDE8FA,
        .run = 0x137244, .reused = 0x47607F, .leftOut = 0x5E6672, .failed = 0xB3261E, .warn = 0x7A5200,
        .focus = 0x1F5FCC, .N = 0x174C72, .L = 0x7A6718, .V = 0x137C71, .R = 0x7A0C12, .H = 0x7A47DC};
    static const ThemeColors projector{
        .bg = 0xFFFFFF, .surface = 0xFFFFFF, .raised = 0xF6F7F9, .hover = 0xE2E7ED, .view = 0xFFFFFF,
        .hatch = 0xE9ECEF, .line = 0xA3AAB4, .outline = 0x5B636E, .text = 0x000000u, .text2 = 0x23282E,
        .text3 = 0x434A53, .accent = 0x0A3A8C, .fill = 0x0A3A8C, .onFill = 0xFFFFFF, .tint = 0xDCE6F7,
        .run = 0x0A5229, .reused = 0x2A3F5C, .leftOut = 0x434A53, .failed = 0x861212, .warn = 0x573A00,
        .focus = 0x0A3A8C, .N = 0x14557E, .L = 0x575402, .V = 0x0A3516, .R = 0x7E393F, .H = 0x3C093E};
    // clang-format on
    switch (id) {
        case ThemeId::Dark: return dark;
        case ThemeId::Light: return light;
        case ThemeId::Projector: return projector;
    }
    return light;
}

QColor Theme::vector(pipeline::VectorCode code) const {
    const ThemeColors& c = colors();
    switch (code) {
        case pipeline::VectorCode::None: return c.text;
        case pipeline::VectorCode::N: return c.N;
        case pipeline::VectorCode::L: return c.L;
        case pipeline::VectorCode::V: return c.V;
        case pipeline::VectorCode::R: return c.R;
        case pipeline::VectorCode::H: return c.H;
    }
    return c.text;
}

QList<qreal> Theme::dash(pipeline::VectorCode code) {
    switch (code) {
        case pipeline::VectorCode::None:
        case pipeline::VectorCode::N: return {};
        case pipeline::VectorCode::L: return {4, 1.7};
        case pipeline::VectorCode::V: return {4, 1.25, 1, 1.25};
        case pipeline::VectorCode::R: return {1.7, 1.25};
        case pipeline::VectorCode::H: return {0.5, 1.25};
    }
    return {};
}

int Theme::px(double logicalPixels) const { return int(std::lround(logicalPixels * scale())); }

QFont Theme::text(double size, int weight) const { return font({"Inter", "DejaVu Sans"}, size * scale(), weight); }

QFont Theme::mono(double size) const {
    QFont mono = font({"JetBrains Mono", "DejaVu Sans Mono"}, size * scale(), 400);
    // Shaping is what makes "->" an arrow; a number or a name is read letter by letter.
    mono.setStyleStrategy(QFont::PreferNoShaping);
    return mono;
}

QFont Theme::formula(double size) const { return font({"STIX", "DejaVu Serif"}, size * scale(), 400); }

QPalette Theme::palette() const {
    const ThemeColors& c = colors();
    QPalette palette(c.raised, c.surface);
    palette.setColor(QPalette::Window, c.bg);
    palette.setColor(QPalette::WindowText, c.text);
    palette.setColor(QPalette::Base, c.raised);
    palette.setColor(QPalette::AlternateBase, c.surface);
    palette.setColor(QPalette::Text, c.text);
    palette.setColor(QPalette::Button, c.raised);
    palette.setColor(QPalette::ButtonText, c.text);
    palette.setColor(QPalette::BrightText, c.onFill);
    palette.setColor(QPalette::PlaceholderText, c.text3);
    palette.setColor(QPalette::Highlight, c.tint);
    palette.setColor(QPalette::HighlightedText, c.text);
    palette.setColor(QPalette::ToolTipBase, c.raised);
    palette.setColor(QPalette::ToolTipText, c.text);
    palette.setColor(QPalette::Link, c.accent);
    palette.setColor(QPalette::LinkVisited, c.accent);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, c.text3);
    return palette;
}

QString Theme::styleSheet() const {
    return app::styleSheet(colors(), [this](double v) { return px(v); });
}

}  // namespace app
