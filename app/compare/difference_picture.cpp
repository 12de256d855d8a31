#include "app/compare/difference_picture.h"

#include "app/look/numbers.h"
#include "app/look/text.h"

namespace app {

using pipeline::AnyBuffer;

namespace {

QString placeText(const AnyBuffer& buffer, std::size_t element) {
    if (standsOnShapes(*buffer.info)) return QString::number(element);
    return QString("%1, %2").arg(element % buffer.columns()).arg(element / buffer.columns());
}

}  // namespace

QString findingText(const pipeline::BufferDifference& found) {
    static const QStringList things{"vertices", "polygons", "pixels", "texels"};
    const AnyBuffer& values = found.values;
    const QString thing = things[int(values.info->domain)];
    if (found.differing == 0) return QString("All %1 are the same.").arg(thing);
    const auto all = qint64(found.compared + found.oneSided);
    QString text = QString("%1 of %2 %3 differ").arg(count(qint64(found.differing)), count(all), thing);
    if (found.largest > 0)
        text += QString(", most by %1 at %2").arg(valueText(values, found.largest), placeText(values, *found.worst));
    if (found.oneSided > 0) text += QString(", %1 have a value on one side only").arg(count(qint64(found.oneSided)));
    return text;
}

DifferencePicture::DifferencePicture(QObject* parent) : QObject(parent) {}

void DifferencePicture::setMetric(pipeline::DifferenceMetric metric) {
    m_metric = metric;
    m_range.reset();
}

void DifferencePicture::begin(const AnyBuffer& a, lessons::ShownChannel channel) {
    m_found.reset();
    m_b.reset();
    m_a = a;
    m_channel = channel;
}

void DifferencePicture::find(const ShownOther& b) {
    m_b = b.buffer;
    if (!b.whyNotComparable.empty()) return;
    m_found = m_job.answer({*m_a, *m_b, index(m_channel), m_metric, b.drawnA, b.drawnB});
}

void DifferencePicture::forgetOtherThan(const pipeline::BufferName& a) {
    if (m_a && m_a->name != a) m_found.reset();
}

std::shared_ptr<const ShowAnswer> DifferencePicture::picture(const pipeline::FramePtr& frame) {
    if (!m_job.busy()) m_frame = frame;
    ShowRequest request{.frame = m_frame, .buffer = m_found->values};
    request.range = m_range;
    request.drawn = std::make_shared<const std::vector<bool>>(m_found->drawn);
    return m_showing.answer(request);
}

void DifferencePicture::forgetPicture() {
    m_showing.forget();
    m_frame.reset();
}

QString DifferencePicture::readout(QPoint pixel, bool isShown) const {
    if (!m_found || standsOnShapes(*m_found->values.info)) return {};
    const auto x = std::size_t(pixel.x()), y = std::size_t(pixel.y());
    const QString b = "   B " + elementText(*m_b, x, y, m_channel).join(' ');
    if (isShown) return "   A " + elementText(*m_a, x, y, m_channel).join(' ') + b;
    return b + "   A − B " + valueText(m_found->values, m_found->values.value(x, y));
}

QString DifferencePicture::formula() const {
    const pipeline::MetricInfo& metric = pipeline::metricTable()[std::size_t(m_metric)];
    return QString("%1 = %2").arg(toQString(metric.name), toQString(metric.formula));
}

}  // namespace app
