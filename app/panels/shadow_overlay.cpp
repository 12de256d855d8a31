#include "app/panels/shadow_overlay.h"

#include <QMenu>

#include "app/core/numbers.h"
#include "app/core/text.h"
#include "app/core/theme.h"

namespace app {

using pipeline::BufferId;
using pipeline::ShadowVerdict;

namespace {

constexpr int kAlpha = 225;  // of 255

// Acne is striped and leaks are dotted: they are told apart without colour.
bool isMarked(ShadowVerdict verdict, int x, int y) {
    if (verdict == ShadowVerdict::Acne) return (x + y) % 3 == 0;
    if (verdict == ShadowVerdict::Leak) return x % 3 == 0 && y % 3 == 0;
    return false;
}

}  // namespace

ShadowOverlay::ShadowOverlay(Document& document, QObject* parent) : QObject(parent), m_document(document) {
    connect(&document, &Document::frameReady, this, &ShadowOverlay::refresh);
    connect(&document, &Document::sceneOpened, this, [this] { setLight(std::nullopt); });
    connect(&m_job, &BackgroundJob::progressed, this, [this](double share) {
        m_share = share;
        emit changed();
    });
}

void ShadowOverlay::setLight(std::optional<std::size_t> light) {
    m_light = light;
    m_job.forget();
    m_scene.reset();
    m_exact.reset();
    m_verdicts.reset();
    m_document.want(this, light ? pipeline::setOf({BufferId::Shadow}) : pipeline::BufferSet());
    refresh();
    emit changed();
}

void ShadowOverlay::refresh() {
    const pipeline::FramePtr frame = m_document.frame();
    if (!m_light || !frame) return;
    m_why = toQString(whyNoShadowVerdicts(frame->scene(), *m_light));
    if (!m_why.isEmpty()) {
        m_job.forget();
        m_scene.reset();
        m_exact.reset();
        m_verdicts.reset();
        return emit changed();
    }
    // The newest rays that were asked for still hold, whether they have come or not.
    if (m_scene && haveSameRays(*m_scene, frame->scene())) return judge();
    m_scene = frame->sharedScene();
    m_share = 0;
    m_exact.reset();
    m_verdicts.reset();  // of other surfaces, or another light
    m_job.ask(
        [scene = m_scene, light = *m_light](const BackgroundJob::Control& control) {
            return exactShadows(*scene, light, 0, control.stop, control.progress);
        },
        [this](const std::optional<pipeline::ExactShadows>& exact) {
            m_exact = exact;
            judge();
        });
    emit changed();
}

void ShadowOverlay::judge() {
    const pipeline::FramePtr frame = m_document.frame();
    if (!m_exact || !frame || m_exact->light != m_light) return;
    if (auto verdicts = judgeShadows(*frame, *m_exact)) m_verdicts = std::move(verdicts);
    emit changed();
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

QImage ShadowOverlay::image() const {
    if (!m_light || !m_verdicts) return {};
    const auto& map = m_verdicts->verdicts;
    QImage image(map.size.x, map.size.y, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < map.size.y; ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < map.size.x; ++x) {
            const std::int32_t value = map.at({x, y});
            line[x] = 0;
            if (value < 0) continue;
            const pipeline::Color8 c = pipeline::shadowVerdictTable()[std::size_t(value)].color;
            line[x] = isMarked(ShadowVerdict(value), x, y) ? qRgb(c.r / 3, c.g / 3, c.b / 3)
                                                           : qPremultiply(qRgba(c.r, c.g, c.b, kAlpha));
        }
    }
    return image;
}

QString ShadowOverlay::notice() const {
    if (!m_light) return {};
    if (!m_why.isEmpty()) return m_why;
    const QString cancel = QStringLiteral(" <a href='cancel'>%1</a>").arg(tr("Cancel"));
    const QString rays =
        busy() ? tr("rays to light %1: %2 %").arg(*m_light).arg(int(100 * m_share)) + cancel : QString();
    if (!m_verdicts) return rays;
    QStringList parts;
    for (std::size_t v = 0; v < pipeline::kShadowVerdictCount; ++v) {
        const pipeline::ShadowVerdictInfo& info = pipeline::shadowVerdictTable()[v];
        // What is nearly white is an outline.
        const bool isLight = info.color.r > 230;
        parts << QStringLiteral("<span style='color:%1'>%2</span> %3 %4 %")
                     .arg(isLight ? Theme::current().colors().text2.name()
                                  : QColor(info.color.r, info.color.g, info.color.b).name(),
                          isLight ? "□" : "■", toQString(info.name), number(m_verdicts->percent(ShadowVerdict(v)), 2));
    }
    const QString found = tr("shadow of light %1 against rays").arg(*m_light) + "<br>" + parts.mid(0, 2).join(' ') +
                          "<br>" + parts.mid(2).join(' ');
    return rays.isEmpty() ? found : found + "<br>" + rays;
}

}  // namespace app
