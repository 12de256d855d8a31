#include "app/compare/other_side.h"

#include "app/document/renderer_check.h"
#include "app/frames/derived_buffers.h"
#include "app/frames/picture_file.h"
#include "app/look/text.h"

namespace app {

using pipeline::AnyBuffer;
using pipeline::BufferId;
using pipeline::BufferName;
using pipeline::FramePtr;
using SourceKind = OtherSource::Kind;

OtherSide::OtherSide(Document& document, QObject* parent) : QObject(parent), m_document(document) {
    observeWork();
    connect(&m_other, &OtherFrame::ready, this, &OtherSide::changed);
    connect(&m_derived, &DerivedJob::changed, this, &OtherSide::changed, Qt::QueuedConnection);
}

void OtherSide::observeWork() {
    m_document.work().add(
        this, tr("the B of a comparison"),
        [this] {
            m_other.cancel(), m_derived.cancel();
            QMetaObject::invokeMethod(this, &OtherSide::changed, Qt::QueuedConnection);
        },
        [this] {
            m_other.retry(), m_derived.retry();
            emit changed();
        });
    connect(&m_other, &OtherFrame::busyChanged, this, &OtherSide::tellWork);
    connect(&m_derived, &DerivedJob::changed, this, &OtherSide::tellWork);
}

void OtherSide::tellWork() {
    m_document.work().setBusy(this, busy());
    emit workChanged();
}

void OtherSide::forget() {
    m_file.reset();
    m_other.forget();
    m_derived.forget();
}

void OtherSide::addTo(ShowRequest& request, const std::optional<OtherSource>& source) {
    m_why.clear();
    m_frame.reset();
    if (!source) {
        m_document.frames().want(this, {});
        m_document.derived().want(this, {});
        return;
    }
    if (auto b = find(*source, request.frame, request.mix.value_or(request.buffer)))
        request.other = {*source, m_frame ? m_frame : request.frame, *std::move(b)};
}

std::optional<AnyBuffer> OtherSide::find(const OtherSource& source, const FramePtr& frame, const AnyBuffer& a) {
    const auto name = otherBuffer(source, a.name, frame->scene());
    const bool isOwn = source.kind == SourceKind::Buffer || source.kind == SourceKind::PreviousStage;
    const bool isDerived = name && pipeline::isDerived(name->id);
    m_document.frames().want(this, isOwn && name && !isDerived ? pipeline::setOf({name->id}) : pipeline::BufferSet());
    m_document.derived().want(this, isOwn && isDerived ? std::vector{*name} : std::vector<BufferName>());
    if (source.kind == SourceKind::Mine) {
        auto mine = m_document.renderer().buffer(a);
        if (!mine) m_why = m_document.renderer().whyNo(a.name);
        return mine;
    }
    if (source.kind == SourceKind::File) return readFile(source.file, a);
    const ScenePtr scene = m_scene.of(source, frame->sharedScene(), m_document.history().sceneBefore());
    if (!name || !scene) {
        m_why =
            source.kind == SourceKind::Before ? tr("Nothing has been changed yet.") : tr("This scene has no such B.");
        return {};
    }
    if (!isOwn) {
        pipeline::BufferSet wanted = frame->wanted() | pipeline::setOf({BufferId::PolygonId, BufferId::Overdraw});
        if (!isDerived) wanted.set(index(name->id));
        m_other.request(scene, wanted);
    }
    m_frame = isOwn ? frame : m_other.frame();
    if (isDerived) return findDerived(*name, isOwn);
    const auto found = m_frame ? m_frame->buffer(*name) : std::nullopt;
    if (!found) m_why = m_frame && !m_other.busy() ? toQString(m_frame->whyAbsent(*name)) : whyNotYet();
    return found;
}

std::optional<AnyBuffer> OtherSide::readFile(const QString& file, const AnyBuffer& a) {
    if (m_file && m_file->name == a.name) return m_file;
    auto read = readPicture(file, a);
    if (!read) {
        m_why = toQString(format(read.errors()));
        return {};
    }
    m_file = std::move(read).value();
    return m_file;
}

std::optional<AnyBuffer> OtherSide::findDerived(const BufferName& name, bool isOwn) {
    DerivedBuffers& derived = m_document.derived();
    if (isOwn) {
        const lessons::DerivedBuffer* made = derived.made(name);
        if (!made) m_why = derived.whyNot(name);
        return made ? std::optional(made->buffer) : std::nullopt;
    }
    if (m_frame) m_derived.ask(m_frame, name, derived.recipe());
    if (m_derived.made()) return m_derived.made()->buffer;
    m_why = m_derived.why().isEmpty() ? whyNotYet() : m_derived.why();
    return {};
}

QString OtherSide::whyNotYet() const {
    return m_other.wasCancelled() ? tr("B was stopped.") : tr("B is being computed.");
}

QString OtherSide::remark() const {
    if (m_frame != m_other.frame()) return {};
    return (m_other.busy() ? tr(" (B follows)") : QString()) +
           (m_other.wasCancelled() ? tr(" (B is of before)") : QString());
}

}  // namespace app
