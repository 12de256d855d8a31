#include "app/talk/talk_equation.h"

#include <QHBoxLayout>
#include <QLabel>

#include "app/document/document.h"
#include "app/frames/pixel_inspection.h"
#include "app/inspector/math_view.h"
#include "app/look/number_format.h"
#include "app/widgets/follow_theme.h"
#include "lessons/pages/talk_words.h"

namespace app {

TalkEquation::TalkEquation(Document& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_math(new MathView(this)),
      m_value(new QLabel(this)),
      m_swatch(new QLabel(this)) {
    auto* columns = spaced(new QHBoxLayout(this), {}, 12);
    m_math->setBaseSize(20.8);  // 38 px in 1080 lines
    m_math->setFocusPolicy(Qt::NoFocus);
    m_swatch->setFrameShape(QFrame::Box);
    columns->addWidget(m_math, 1);
    columns->addWidget(m_value, 0, Qt::AlignVCenter);
    columns->addWidget(m_swatch, 0, Qt::AlignVCenter);
    connect(&document.inspection(), &PixelInspection::changed, this, &TalkEquation::showPixel);
    connect(&document.pointing(), &Pointing::channelChanged, this, &TalkEquation::showPixel);
    connect(&NumberStyle::current(), &NumberStyle::changed, this, &TalkEquation::showPixel);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_value->setFont(theme.mono(13));
        m_swatch->setFixedSize(theme.px(64), theme.px(64));
        showPixel();
    });
}

void TalkEquation::setWanted(bool wanted) {
    m_isWanted = wanted;
    showPixel();
}

void TalkEquation::showPixel() {
    const auto& inspected = m_document.inspection().newest();
    const bool shows = inspected && inspected->report.covered && inspected->frame->buffer({pipeline::BufferId::Color});
    setVisible(shows && m_isWanted);
    if (!shows) return;
    const pipeline::PixelReport& report = inspected->report;
    const pipeline::Scene& scene = inspected->frame->scene();
    m_math->setLines(lessons::shortEquation(equation(scene, report, m_document.pointing().channel(), chosenNumbers())),
                     true);
    const auto& c = report.color;
    // A font set while the row is hidden does not outlive a style sheet that comes meanwhile.
    m_value->setFont(Theme::current().mono(13));
    m_value->setText(tr("frame buffer\n%1 %2 %3").arg(int(c.r)).arg(int(c.g)).arg(int(c.b)));
    m_value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    QPixmap swatch(m_swatch->size());
    swatch.fill(QColor(c.r, c.g, c.b));
    m_swatch->setPixmap(swatch);
}

}  // namespace app
