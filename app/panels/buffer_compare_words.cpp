// What a comparison says, and what may be given up of it.
#include "app/panels/buffer_compare.h"

#include "app/core/pointed.h"
#include "app/core/text.h"

namespace app {

using pipeline::Domain;

void BufferCompare::observeWork() {
    WorkList& work = m_document.work();
    const auto tellWork = [this, &work] {
        work.setBusy(this, waitsForB());
        emit busyChanged(busy());
    };
    work.add(
        this, tr("the B of a comparison"),
        [this] {
            m_other.cancel(), m_derived.cancel();
            QMetaObject::invokeMethod(this, &BufferCompare::changed, Qt::QueuedConnection);
        },
        [this] {
            m_other.retry(), m_derived.retry();
            emit changed();
        });
    connect(&m_other, &OtherFrame::busyChanged, this, tellWork);
    connect(&m_derived, &DerivedJob::changed, this, tellWork);
    connect(this, &BufferCompare::changed, this, tellWork);
}

QString BufferCompare::whyNotYet() const {
    return m_other.wasCancelled() ? tr("B was stopped.") : tr("B is being computed.");
}

void BufferCompare::tell() {
    const bool isOnItsWay = !m_found && m_why.isEmpty();
    const bool isCancelled = isOnItsWay && m_difference.wasCancelled();
    const QString waits = isCancelled
                              ? tr("The difference was cancelled.")
                              : tr("The difference is being computed, %1 %.").arg(int(100 * m_difference.share()));
    m_bar->setOffer(isCancelled                         ? CompareBar::Offer::Compute
                    : isOnItsWay && m_difference.busy() ? CompareBar::Offer::Cancel
                                                        : CompareBar::Offer::Nothing);
    QString sentence = m_found ? findingText(*m_found) : isOnItsWay ? waits : m_why;
    if (m_found && m_frameB == m_other.frame() && m_other.busy()) sentence += tr(" (B follows)");
    if (m_found && m_other.wasCancelled() && m_frameB == m_other.frame()) sentence += tr(" (B is of before)");
    QString whyNoWorst;
    if (!m_found)
        whyNoWorst = isOnItsWay ? waits : m_why;
    else if (!m_found->worst)
        whyNoWorst = tr("The two are the same.");
    else if (m_found->values.info->domain == Domain::Texel)
        whyNoWorst = tr("A texel of a shadow buffer cannot be picked.");
    m_bar->setFinding(sentence, whyNoWorst);
}

// Where the two scenes differ in one setting, each side says which value it has.
void BufferCompare::nameDifference(const pipeline::Scene& a, const pipeline::Scene& b) {
    const auto differing = differingSettings(a, b);
    const auto source = *current();
    const bool isSetting = source.kind == OtherSource::Kind::Setting;
    if (m_bar->isBare() && (isSetting || differing.size() == 1)) {
        const pipeline::SettingRef setting = isSetting ? source.setting : differing[0];
        m_nameA = captionOf(setting, setting.get(a)), m_nameB = captionOf(setting, setting.get(b));
        return;
    }
    if (differing.size() != 1) return;
    const auto valueIn = [&](const pipeline::Scene& scene) {
        return nameOf({.kind = OtherSource::Kind::Setting, .setting = differing[0], .value = differing[0].get(scene)});
    };
    m_nameA += ", " + valueIn(a);
    if (current()->kind == OtherSource::Kind::Before) m_nameB += ", " + valueIn(b);
}

QString BufferCompare::differenceName() const {
    const pipeline::MetricInfo& metric = pipeline::metricTable()[std::size_t(m_metric)];
    const QString sides = m_bar->isBare() ? tr("A  %1,  B  %2") : QStringLiteral("%1,  %2");
    return QString("%1 = %2,  ").arg(toQString(metric.name), toQString(metric.formula)) + sides.arg(m_nameA, m_nameB);
}

QString BufferCompare::readout(QPoint pixel) const {
    if (!m_found || standsOnShapes(*m_found->values.info)) return {};
    const auto x = std::size_t(pixel.x()), y = std::size_t(pixel.y());
    const QString b = "   B " + elementText(*m_b, x, y, m_channel).join(' ');
    if (showsDifference()) return "   A " + elementText(*m_a, x, y, m_channel).join(' ') + b;
    return b + "   A − B " + valueText(m_found->values, m_found->values.value(x, y));
}

}  // namespace app
