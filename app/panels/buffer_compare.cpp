#include "app/panels/buffer_compare.h"

#include "app/core/derived_buffers.h"
#include "app/core/picture_file.h"
#include "app/core/renderer_check.h"
#include "app/core/text.h"
#include "app/panels/buffer_canvas.h"

namespace app {

using pipeline::AnyBuffer;
using pipeline::BufferId;
using pipeline::BufferName;
using pipeline::Domain;
using pipeline::FramePtr;
using Kind = OtherSource::Kind;

BufferCompare::BufferCompare(Document& document, BufferCanvas* canvas, QWidget* window)
    : QObject(window), m_document(document), m_canvas(canvas), m_bar(new CompareBar(window)) {
    m_bar->hide();
    m_blink.setInterval(700);  // well below three flashes a second
    connect(&m_blink, &QTimer::timeout, this, [this] {
        m_blinksToB = !m_blinksToB;
        m_canvas->setWipe(wipe());
    });
    connect(m_canvas, &BufferCanvas::wiped, this, [this](double share) {
        m_share = share;
        m_canvas->setWipe(wipe());
    });
    observeWork();
    connect(&m_other, &OtherFrame::ready, this, &BufferCompare::changed);
    connect(&m_derived, &DerivedJob::changed, this, &BufferCompare::changed, Qt::QueuedConnection);
    connect(&m_document.derived(), &DerivedBuffers::changed, this, [this](const BufferName& name) {
        if (m_source && m_source->kind == Kind::Buffer && m_source->buffer == name) emit changed();
    });
    connect(&m_difference, &DifferenceJob::ready, this, &BufferCompare::changed);
    connect(&m_difference, &DifferenceJob::progressed, this, &BufferCompare::tell);
    connect(&m_showing, &ShowJob::ready, this, &BufferCompare::changed);
    connect(&m_showing, &ShowJob::busyChanged, this, &BufferCompare::busyChanged);
    connect(m_bar, &CompareBar::offerTaken, this,
            [this] { m_difference.wasCancelled() ? m_difference.retry() : m_difference.cancel(); });
    connect(m_bar, &CompareBar::modeChosen, this, [this](CompareMode mode) {
        if (mode != m_mode) setMode(mode);
    });
    connect(m_bar, &CompareBar::metricChosen, this, &BufferCompare::setMetric);
    connect(m_bar, &CompareBar::worstChosen, this, &BufferCompare::goToWorst);
    connect(m_bar, &CompareBar::stagesChosen, this, &BufferCompare::stagesChosen);
    connect(m_bar, &CompareBar::closed, this, [this] { compareWith(std::nullopt); });
    connect(&m_document, &Document::sceneOpened, this, [this] {
        if (!isMine()) compareWith(std::nullopt);
    });
    connect(&m_document.renderer(), &RendererCheck::compared, this, [this] {
        if (isMine()) emit changed();
    });
}

void BufferCompare::compareWith(std::optional<OtherSource> source) {
    m_source = std::move(source);
    m_range.reset();
    m_file.reset();
    m_other.forget();
    m_derived.forget();
    m_goesToWorst = false;
    m_bar->show(m_source.has_value());
    if (!m_source)
        setMode(CompareMode::A);
    else if (m_mode == CompareMode::A)
        setMode(CompareMode::Wipe);
    else
        emit changed();
}

void BufferCompare::setMode(CompareMode mode) {
    m_mode = mode == m_mode ? CompareMode::A : mode;
    m_blinksToB = false;
    m_mode == CompareMode::Blink ? m_blink.start() : m_blink.stop();
    m_bar->setMode(m_mode);
    emit changed();
}

void BufferCompare::setMetric(pipeline::DifferenceMetric metric) {
    m_metric = metric;
    m_range.reset();
    emit changed();
}

void BufferCompare::holdOther(bool held) {
    if (!m_source || held == m_holdsOther) return;
    m_holdsOther = held;
    m_mode == CompareMode::Difference ? emit changed() : m_canvas->setWipe(wipe());
}

void BufferCompare::holdPrevious(bool held) {
    if (held == m_holdsPrevious) return;
    m_holdsPrevious = held;
    emit changed();
}

std::optional<OtherSource> BufferCompare::current() const {
    return m_holdsPrevious ? OtherSource{.kind = Kind::PreviousStage} : m_source;
}

std::optional<AnyBuffer> BufferCompare::findOther(const FramePtr& frame, const AnyBuffer& a) {
    const OtherSource source = *current();
    const auto name = otherBuffer(source, a.name, frame->scene());
    const bool isOwn = source.kind == Kind::Buffer || source.kind == Kind::PreviousStage;
    const bool isDerived = name && pipeline::isDerived(name->id);
    m_document.frames().want(this, isOwn && name && !isDerived ? pipeline::setOf({name->id}) : pipeline::BufferSet());
    m_document.derived().want(this, isOwn && isDerived ? std::vector{*name} : std::vector<BufferName>());
    if (source.kind == Kind::Mine) {
        auto mine = m_document.renderer().buffer(a);
        if (!mine) m_why = m_document.renderer().whyNo(a.name);
        return mine;
    }
    if (source.kind == Kind::File) {
        if (m_file && m_file->name == a.name) return m_file;
        auto read = readPicture(source.file, a);
        if (!read) {
            m_why = toQString(format(read.errors()));
            return {};
        }
        m_file = std::move(read).value();
        return m_file;
    }
    const ScenePtr scene = m_otherScene.of(source, frame->sharedScene(), m_document.history().sceneBefore());
    if (!name || !scene) {
        m_why = source.kind == Kind::Before ? tr("Nothing has been changed yet.") : tr("This scene has no such B.");
        return {};
    }
    if (!isOwn) {
        pipeline::BufferSet wanted = frame->wanted() | pipeline::setOf({BufferId::PolygonId, BufferId::Overdraw});
        if (!isDerived) wanted.set(index(name->id));
        m_other.request(scene, wanted);
    }
    m_frameB = isOwn ? frame : m_other.frame();
    if (isDerived) return findDerived(*name, isOwn);
    const auto found = m_frameB ? m_frameB->buffer(*name) : std::nullopt;
    if (!found) m_why = m_frameB && !m_other.busy() ? toQString(m_frameB->whyAbsent(*name)) : whyNotYet();
    return found;
}

std::optional<AnyBuffer> BufferCompare::findDerived(const BufferName& name, bool isOwn) {
    DerivedBuffers& derived = m_document.derived();
    if (isOwn) {
        const lessons::DerivedBuffer* made = derived.made(name);
        if (!made) m_why = derived.whyNot(name);
        return made ? std::optional(made->buffer) : std::nullopt;
    }
    if (m_frameB) m_derived.ask(m_frameB, name, derived.recipe());
    if (m_derived.made()) return m_derived.made()->buffer;
    m_why = m_derived.why().isEmpty() ? whyNotYet() : m_derived.why();
    return {};
}

void BufferCompare::addOther(ShowRequest& request) {
    m_why.clear();
    m_frameB.reset();
    const auto source = current();
    if (!source) {
        m_document.frames().want(this, {});
        m_document.derived().want(this, {});
        return;
    }
    const AnyBuffer a = request.mix.value_or(request.buffer);
    if (m_a && m_a->name != a.name) m_found.reset();  // it is of what was on show before
    if (auto b = findOther(request.frame, a))
        request.other = {*source, m_frameB ? m_frameB : request.frame, *std::move(b)};
}

ShownBuffer BufferCompare::show(const ShowAnswer& answer) {
    const ShownBuffer& a = answer.shown;
    m_found.reset();
    m_b.reset();
    m_a = a.buffer;
    m_channel = a.look.channel;
    const auto source = current();
    if (!source) {
        forgetDifference();
        m_canvas->setOther({}, {});
        return a;
    }
    const bool hasCome = answer.other && answer.request.other->source == *source;
    if (m_why.isEmpty() && !hasCome) m_why = tr("B is being computed.");
    const ShownOther* other = m_why.isEmpty() ? &*answer.other : nullptr;
    const bool isBare = m_bar->isBare();
    m_nameA = (isBare ? QString() : "A  ") + toQString(a.buffer.name.text());
    m_nameB = isBare ? QString() : "B  ";
    if (other && source->kind != Kind::Buffer) m_nameB += toQString(other->buffer.name.text()) + ", ";
    m_nameB += nameOf(*source);
    if (other) nameDifference(answer.request.frame->scene(), answer.request.other->frame->scene());
    if (other) {
        m_b = other->buffer;
        if (other->whyNotComparable.empty())
            m_found = m_difference.answer({a.buffer, *m_b, index(m_channel), m_metric, other->drawnA, other->drawnB});
        else
            m_why = source->kind == Kind::PreviousStage
                        ? tr("The two stages leave different things: look from one to the other.")
                        : toQString(other->whyNotComparable);
    }
    m_bar->setMetric(m_metric);
    if (isBare && !m_why.isEmpty()) m_nameB += ": " + m_why;
    tell();
    if (m_found && m_goesToWorst) QMetaObject::invokeMethod(this, &BufferCompare::goToWorst, Qt::QueuedConnection);
    if (const auto difference = shownDifference(answer.request.frame)) {
        ShownBuffer shown = difference->shown;
        shown.notice.clear();
        shown.empty.clear();
        Wipe names;
        names.nameA = differenceName();
        m_canvas->setOther({}, names);
        return shown;
    }
    if (other && other->shown && other->shown->content.size == a.content.size)
        m_canvas->setOther(other->shown->content, wipe());
    else
        m_canvas->setOther({}, wipe());
    return a;
}

std::shared_ptr<const ShowAnswer> BufferCompare::shownDifference(const FramePtr& frame) {
    if (!showsDifference() || m_holdsOther || m_holdsPrevious) {
        forgetDifference();
        return {};
    }
    if (!m_difference.busy()) m_foundFrame = frame;
    ShowRequest request{.frame = m_foundFrame, .buffer = m_found->values};
    request.range = m_range;
    request.drawn = std::make_shared<const std::vector<bool>>(m_found->drawn);
    return m_showing.answer(request);
}

void BufferCompare::forgetDifference() {
    m_showing.forget();
    m_foundFrame.reset();
}

Wipe BufferCompare::wipe() const {
    Wipe wipe{1, false, m_nameA, m_nameB};
    if (m_holdsOther || m_holdsPrevious || m_mode == CompareMode::B || (m_mode == CompareMode::Blink && m_blinksToB))
        wipe.share = 0;
    else if (m_mode == CompareMode::Wipe)
        wipe.share = m_share, wipe.hasHandle = true;
    return wipe;
}

}  // namespace app
