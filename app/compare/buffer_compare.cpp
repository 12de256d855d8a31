#include "app/compare/buffer_compare.h"

#include <algorithm>

#include "app/canvas/buffer_canvas.h"
#include "app/document/changed_settings.h"
#include "app/document/renderer_check.h"
#include "app/frames/derived_buffers.h"
#include "app/look/text.h"
#include "lessons/state/state_text.h"

namespace app {

using pipeline::BufferName;
using pipeline::Domain;
using SourceKind = OtherSource::Kind;

BufferCompare::BufferCompare(Document& document, BufferCanvas* canvas, QWidget* window)
    : QObject(window),
      m_document(document),
      m_canvas(canvas),
      m_bar(new CompareBar(window)),
      m_other(document, this),
      m_sides(this),
      m_difference(this) {
    m_bar->hide();
    connect(&m_sides, &SideSwitch::turned, this, [this] { m_canvas->setWipe(wipe()); });
    connect(&m_canvas->input(), &CanvasInput::wiped, &m_sides, &SideSwitch::setShare);
    connect(m_bar, &CompareBar::offerTaken, this, [this] {
        DifferenceJob& job = m_difference.job();
        job.wasCancelled() ? job.retry() : job.cancel();
    });
    connect(m_bar, &CompareBar::modeChosen, this, [this](CompareMode mode) {
        if (mode != this->mode()) setMode(mode);
    });
    connect(m_bar, &CompareBar::metricChosen, this, [this](pipeline::DifferenceMetric metric) {
        m_difference.setMetric(metric);
        emit changed();
    });
    connect(m_bar, &CompareBar::worstChosen, this, &BufferCompare::goToWorst);
    connect(m_bar, &CompareBar::stagesChosen, this, &BufferCompare::stagesChosen);
    connect(m_bar, &CompareBar::closed, this, [this] { compareWith(std::nullopt); });

    connect(this, &BufferCompare::changed, &m_other, &OtherSide::tellWork);
    connect(&m_other, &OtherSide::changed, this, &BufferCompare::changed);
    connect(&m_other, &OtherSide::workChanged, this, &BufferCompare::busyChanged);
    connect(&m_difference.job(), &DifferenceJob::ready, this, &BufferCompare::changed);
    connect(&m_difference.job(), &DifferenceJob::progressed, this, &BufferCompare::tell);
    connect(&m_difference.showing(), &ShowJob::ready, this, &BufferCompare::changed);
    connect(&m_difference.showing(), &ShowJob::busyChanged, this, &BufferCompare::busyChanged);
    connect(&m_document.derived(), &DerivedBuffers::changed, this, [this](const BufferName& name) {
        if (m_source && m_source->kind == SourceKind::Buffer && m_source->buffer == name) emit changed();
    });
    connect(&m_document, &Document::sceneOpened, this, [this] {
        if (!isMine()) compareWith(std::nullopt);
    });
    connect(&m_document.renderer(), &RendererCheck::compared, this, [this] {
        if (isMine()) emit changed();
    });
}

void BufferCompare::compareWith(std::optional<OtherSource> source) {
    m_source = std::move(source);
    m_difference.range().reset();
    m_other.forget();
    m_goesToWorst = false;
    m_bar->show(m_source.has_value());
    if (!m_source)
        setMode(CompareMode::A);
    else if (mode() == CompareMode::A)
        setMode(CompareMode::Wipe);
    else
        emit changed();
}

void BufferCompare::setMode(CompareMode mode) {
    m_sides.setMode(mode);
    m_bar->setMode(this->mode());
    emit changed();
}

void BufferCompare::holdOther(bool held) {
    if (!m_source || !m_sides.holdOther(held)) return;
    mode() == CompareMode::Difference ? emit changed() : m_canvas->setWipe(wipe());
}

void BufferCompare::holdPrevious(bool held) {
    if (m_sides.holdPrevious(held)) emit changed();
}

std::optional<OtherSource> BufferCompare::current() const {
    return m_sides.holdsPrevious() ? OtherSource{.kind = SourceKind::PreviousStage} : m_source;
}

void BufferCompare::addOther(ShowRequest& request) {
    const auto source = current();
    if (source) m_difference.forgetOtherThan(request.mix.value_or(request.buffer).name);
    m_other.addTo(request, source);
}

ShownBuffer BufferCompare::show(const ShowAnswer& answer) {
    const ShownBuffer& a = answer.shown;
    m_difference.begin(a.buffer, a.look.channel);
    const auto source = current();
    if (!source) {
        m_difference.forgetPicture();
        m_canvas->setOther({}, {});
        return a;
    }
    const bool hasCome = answer.other && answer.request.other->source == *source;
    if (m_other.why().isEmpty() && !hasCome) m_other.giveUp(tr("B is being computed."));
    const ShownOther* other = m_other.why().isEmpty() ? &*answer.other : nullptr;
    nameSides(*source, answer, other);
    if (other) {
        m_difference.find(*other);
        if (!other->whyNotComparable.empty())
            m_other.giveUp(source->kind == SourceKind::PreviousStage
                               ? tr("The two stages leave different things: look from one to the other.")
                               : toQString(other->whyNotComparable));
    }
    m_bar->setMetric(m_difference.metric());
    if (m_bar->isBare() && !m_other.why().isEmpty()) m_nameB += ": " + m_other.why();
    tell();
    if (m_difference.found() && m_goesToWorst)
        QMetaObject::invokeMethod(this, &BufferCompare::goToWorst, Qt::QueuedConnection);
    std::shared_ptr<const ShowAnswer> difference;  // null where none is to be seen, or none has come yet
    if (showsDifference() && !m_sides.isHeld())
        difference = m_difference.picture(answer.request.frame);
    else
        m_difference.forgetPicture();
    if (difference) {
        ShownBuffer shown = difference->shown;
        shown.notice.clear();
        shown.empty.clear();
        const QString sides = m_bar->isBare() ? tr("A  %1,  B  %2") : QStringLiteral("%1,  %2");
        Wipe names;
        names.nameA = m_difference.formula() + ",  " + sides.arg(m_nameA, m_nameB);
        m_canvas->setOther({}, names);
        return shown;
    }
    if (other && other->shown && other->shown->content.size == a.content.size)
        m_canvas->setOther(other->shown->content, wipe());
    else
        m_canvas->setOther({}, wipe());
    return a;
}

Wipe BufferCompare::wipe() const {
    Wipe wipe = m_sides.wipe();
    wipe.nameA = m_nameA, wipe.nameB = m_nameB;
    return wipe;
}

void BufferCompare::nameSides(const OtherSource& source, const ShowAnswer& answer, const ShownOther* other) {
    const bool isBare = m_bar->isBare();
    m_nameA = (isBare ? QString() : "A  ") + toQString(answer.shown.buffer.name.text());
    m_nameB = isBare ? QString() : "B  ";
    if (other && source.kind != SourceKind::Buffer) m_nameB += toQString(other->buffer.name.text()) + ", ";
    m_nameB += nameOf(source);
    if (other) nameDifference(source, answer.request.frame->scene(), answer.request.other->frame->scene());
}

// Where the two scenes differ in one setting, each side says which value it has.
void BufferCompare::nameDifference(const OtherSource& source, const pipeline::Scene& a, const pipeline::Scene& b) {
    const auto differing = differingSettings(a, b);
    const bool isSetting = source.kind == SourceKind::Setting;
    if (m_bar->isBare() && (isSetting || differing.size() == 1)) {
        const pipeline::SettingRef setting = isSetting ? source.setting : differing[0];
        m_nameA = captionOf(setting, a), m_nameB = captionOf(setting, b);
        return;
    }
    if (differing.size() != 1) return;
    const auto valueIn = [&](const pipeline::Scene& scene) {
        return nameOf({.kind = SourceKind::Setting, .setting = differing[0], .value = differing[0].get(scene)});
    };
    m_nameA += ", " + valueIn(a);
    if (source.kind == SourceKind::Before) m_nameB += ", " + valueIn(b);
}

void BufferCompare::tell() {
    const auto& found = m_difference.found();
    const DifferenceJob& job = m_difference.job();
    const bool isOnItsWay = !found && m_other.why().isEmpty();
    const bool isCancelled = isOnItsWay && job.wasCancelled();
    const QString waits = isCancelled ? tr("The difference was cancelled.")
                                      : tr("The difference is being computed, %1 %.").arg(int(100 * job.share()));
    m_bar->setOffer(isCancelled                ? CompareBar::Offer::Compute
                    : isOnItsWay && job.busy() ? CompareBar::Offer::Cancel
                                               : CompareBar::Offer::Nothing);
    const QString whyNot = isOnItsWay ? waits : m_other.why();
    QString whyNoWorst;
    if (!found)
        whyNoWorst = whyNot;
    else if (!found->worst)
        whyNoWorst = tr("The two are the same.");
    else if (found->values.info->domain == Domain::Texel)
        whyNoWorst = tr("A texel of a shadow buffer cannot be picked.");
    m_bar->setFinding(found ? findingText(*found) + m_other.remark() : whyNot, whyNoWorst);
}

std::optional<lessons::BufferShown::Compared> BufferCompare::state() const {
    if (!m_source || m_source->kind == SourceKind::Mine) return {};
    OtherSource source = *m_source;
    const auto change = m_document.history().lastChange();
    if (source.kind == SourceKind::Before && change)
        source = {.kind = SourceKind::Setting, .setting = change->setting, .value = change->before};
    const auto& metric = pipeline::metricTable()[std::size_t(m_difference.metric())];
    lessons::BufferShown::Compared state{keyOf(source), std::string(lessons::kCompareModes[std::size_t(mode())]),
                                         m_sides.share(), std::string(metric.name)};
    if (const auto& range = m_difference.range()) state.range = {range->first, range->last};
    return state;
}

pipeline::Errors BufferCompare::lookAt(const std::optional<lessons::BufferShown::Compared>& state) {
    if (!state || !m_document.hasScene()) {
        compareWith(std::nullopt);
        return {};
    }
    const auto source = sourceNamed(state->with, m_document.scene());
    if (!source) {
        compareWith(std::nullopt);
        return source.errors();
    }
    for (const pipeline::MetricInfo& metric : pipeline::metricTable())
        if (metric.name == state->metric) m_difference.setMetric(metric.id);
    m_sides.setShare(state->wipe);
    compareWith(*source);
    if (state->range && (*state->range)[0] != (*state->range)[1])
        m_difference.range() = pipeline::PaletteRange{(*state->range)[0], (*state->range)[1]};
    const auto mode = std::ranges::find(lessons::kCompareModes, state->mode);
    m_sides.setMode(CompareMode::A);
    setMode(mode == lessons::kCompareModes.end() ? CompareMode::Wipe
                                                 : CompareMode(mode - lessons::kCompareModes.begin()));
    return {};
}

void BufferCompare::goToWorst() {
    const auto& found = m_difference.found();
    m_goesToWorst = !found;
    if (!found || !found->worst) return;
    const std::size_t worst = *found->worst;
    const auto columns = found->values.columns();
    Pointing& pointing = m_document.pointing();
    switch (found->values.info->domain) {
        case Domain::Pixel: return pointing.pick(glm::ivec2(worst % columns, worst / columns));
        case Domain::Polygon: return pointing.select(lessons::Selection{lessons::Selection::Kind::Polygon, worst});
        case Domain::Vertex: return pointing.select(lessons::Selection{lessons::Selection::Kind::Vertex, worst});
        case Domain::Texel: break;
    }
}

}  // namespace app
