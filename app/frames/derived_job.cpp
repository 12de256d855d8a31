#include "app/frames/derived_job.h"

#include "app/look/text.h"

namespace app {

using pipeline::BufferId;

namespace {

bool castsRays(const pipeline::BufferName& name) { return name.id == BufferId::ShadowVerdict; }

}  // namespace

DerivedJob::DerivedJob(QObject* parent)
    : QObject(parent), m_rays(std::make_shared<std::shared_ptr<const lessons::KnownRays>>()) {
    connect(&m_job, &BackgroundJob::progressed, this, [this](double share) {
        m_share = share;
        emit changed();
    });
}

void DerivedJob::ask(const pipeline::FramePtr& frame, const pipeline::BufferName& name,
                     const lessons::DerivedRecipe& recipe) {
    Question question{frame, name, recipe};
    if (question == m_asked) return;
    // What shows another thing is worse than nothing.
    const bool sameThing = m_asked && m_asked->name == name && m_asked->recipe.text == recipe.text;
    const bool sameRays = sameThing && (!castsRays(name) || haveSameRays(m_asked->frame->scene(), frame->scene()));
    if (!sameThing || (castsRays(name) && !sameRays)) m_made.reset();
    if (m_cancelled && sameRays) {
        m_asked = std::move(question);
        return;
    }
    m_asked = std::move(question);
    m_cancelled = false;
    if (!sameRays) m_job.forget(), m_share = 0;
    start();
}

void DerivedJob::start() {
    const Question& q = *m_asked;
    const auto needed = buffersFor(q.name, q.recipe, q.frame->scene());
    if (!needed) return refuse(toQString(needed.errors().front().found), needed.errors());
    m_errors.clear();
    m_why.clear();
    if ((*needed & ~(q.frame->wanted() | q.frame->made())).any()) return emit changed();  // another frame is on its way
    m_job.ask(
        [q, cell = m_rays](const BackgroundJob::Control& control) {
            auto made =
                derive(q.name, q.recipe, *q.frame, {.stop = control.stop, .progress = control.progress, .rays = *cell});
            if (made && made->rays) *cell = made->rays;
            return made;
        },
        [this](const pipeline::Result<lessons::DerivedBuffer>& made) {
            if (!made) return refuse(toQString(made.errors().front().found));
            m_made = *made;
            emit changed();
        },
        BackgroundJob::Running::Finish);
    emit changed();
}

void DerivedJob::refuse(const QString& why, pipeline::Errors errors) {
    m_made.reset();
    m_why = why;
    m_errors = std::move(errors);
    emit changed();
}

void DerivedJob::cancel() {
    if (!busy()) return;
    m_job.forget();
    m_cancelled = true;
    m_share = 0;
    m_why = tr("Cancelled.");
    emit changed();
}

void DerivedJob::retry() {
    if (!m_cancelled) return;
    m_cancelled = false;
    start();
}

void DerivedJob::forget() {
    m_job.forget();
    m_asked.reset();
    m_made.reset();
    m_why.clear();
    m_errors.clear();
    m_cancelled = false;
    m_share = 0;
}

}  // namespace app
