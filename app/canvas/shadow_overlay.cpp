#include "app/canvas/shadow_overlay.h"

#include <QMenu>

#include "app/frames/derived_buffers.h"
#include "app/look/numbers.h"
#include "app/look/text.h"
#include "app/look/theme.h"
#include "pipeline/buffers/palette.h"

namespace app {

using pipeline::BufferId;
using pipeline::ShadowVerdict;

namespace {

pipeline::Color8 colorOf(std::size_t verdict) {
    return pipeline::paletteStops(pipeline::Palette::ShadowVerdict)[verdict];
}

// Acne is striped and leaks are dotted: they are told apart without colour.
bool isMarked(ShadowVerdict verdict, int x, int y) {
    if (verdict == ShadowVerdict::Acne) return (x + y) % 3 == 0;
    if (verdict == ShadowVerdict::Leak) return x % 3 == 0 && y % 3 == 0;
    return false;
}

}  // namespace

ShadowOverlay::ShadowOverlay(Document& document, QObject* parent) : QObject(parent), m_document(document) {
    connect(&document, &Document::sceneOpened, this, [this] { setLight(std::nullopt); });
    connect(&document.derived(), &DerivedBuffers::changed, this, [this](const pipeline::BufferName& which) {
        if (m_light && which == name()) emit changed();
    });
}

void ShadowOverlay::setLight(std::optional<std::size_t> light) {
    m_light = light;
    m_document.derived().want(this, light ? std::vector{name()} : std::vector<pipeline::BufferName>());
    emit changed();
}

void ShadowOverlay::cancel() {
    if (DerivedJob* job = m_light ? m_document.derived().find(name()) : nullptr) job->cancel();
    setLight(std::nullopt);
}

void ShadowOverlay::fillMenu(QMenu& menu, const QString& whyNot) {
    if (!m_document.hasScene()) return;
    const pipeline::Scene& scene = m_document.scene();
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        QAction* action = menu.addAction(tr("Shadow verdict, light %1").arg(k));
        const QString why = whyNot.isEmpty() ? toQString(whyNoShadowVerdicts(scene, k)) : whyNot;
        action->setCheckable(true);
        action->setChecked(m_light == k);
        action->setEnabled(why.isEmpty() || m_light == k);
        action->setToolTip(why.isEmpty() ? tr("The shadow factor against exact rays: lit, shadowed, acne, leak.")
                                         : why);
        connect(action, &QAction::toggled, this,
                [this, k](bool on) { setLight(on ? std::optional(k) : std::nullopt); });
    }
}

std::shared_ptr<const pipeline::ShadowVerdicts> ShadowOverlay::verdicts() const {
    const lessons::DerivedBuffer* made = m_light ? m_document.derived().made(name()) : nullptr;
    return made ? made->verdicts : nullptr;
}

QString ShadowOverlay::notice() const {
    if (!m_light) return {};
    const DerivedJob* job = m_document.derived().find(name());
    QString rays;
    if (job && (job->busy() || !verdicts())) rays = m_document.derived().whyNot(name()).toHtmlEscaped();
    if (job && job->busy() && !rays.isEmpty()) rays += QStringLiteral(" <a href='cancel'>%1</a>").arg(tr("Cancel"));
    if (!verdicts()) return rays;
    const QString found = tr("shadow of light %1 against rays").arg(*m_light) + "<br>" + sharesText(*verdicts());
    return rays.isEmpty() ? found : found + "<br>" + rays;
}

QImage verdictPicture(const pipeline::ShadowVerdicts& verdicts, int alpha) {
    const auto& map = verdicts.verdicts;
    QImage image(map.size.x, map.size.y, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < map.size.y; ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < map.size.x; ++x) {
            const std::int32_t value = map.at({x, y});
            line[x] = 0;
            if (value < 0) continue;
            const pipeline::Color8 c = colorOf(std::size_t(value));
            line[x] = isMarked(ShadowVerdict(value), x, y) ? qRgb(c.r / 3, c.g / 3, c.b / 3)
                                                           : qPremultiply(qRgba(c.r, c.g, c.b, alpha));
        }
    }
    return image;
}

QString sharesText(const pipeline::ShadowVerdicts& verdicts) {
    QStringList parts;
    for (std::size_t v = 0; v < pipeline::kShadowVerdictCount; ++v) {
        const pipeline::Color8 color = colorOf(v);
        const bool isLight = color.r > 230;  // nearly white: an outline
        parts << QStringLiteral("<span style='color:%1'>%2</span> %3 %4 %")
                     .arg(isLight ? Theme::current().colors().text2.name() : QColor(color.r, color.g, color.b).name(),
                          isLight ? "□" : "■", toQString(pipeline::shadowVerdictTable()[v].name),
                          number(verdicts.percent(ShadowVerdict(v)), 2));
    }
    return parts.mid(0, 2).join(' ') + "<br>" + parts.mid(2).join(' ');
}

}  // namespace app
