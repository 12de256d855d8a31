#include "app/document/renderer_check.h"

#include <QFileInfo>
#include <QTime>
#include <atomic>

#include "app/jobs/work_list.h"
#include "app/look/shown_name.h"
#include "app/look/text.h"
#include "pipeline/plan/memory_limit.h"

namespace app {

namespace foreign = pipeline::foreign;
using ReportResult = pipeline::Result<foreign::Report>;

namespace {

constexpr int kSceneRest = 300;  // milliseconds

}  // namespace

// What is the same from one comparison of a scene to the next.
struct RendererCheck::Kept {
    std::shared_ptr<const pipeline::Scene> scene;
    std::shared_ptr<const foreign::Reference> reference;
};

struct RendererCheck::Progress {
    std::atomic<std::size_t> done{0}, all{0};
};

RendererCheck::RendererCheck(WorkList& work) {
    m_soon.setSingleShot(true);
    m_soon.setInterval(0);
    connect(&m_soon, &QTimer::timeout, this, &RendererCheck::compare);
    connect(&m_watch, &RendererWatch::changed, this, &RendererCheck::readAgain);
    work.add(
        this, tr("the comparison with your renderer"), [this] { cancel(); }, [this] { readAgain(); });
    connect(&m_job, &BackgroundJob::busyChanged, this, [this, &work](bool busy) {
        work.setBusy(this, busy);
        if (!busy) m_work = Work::None;
        emit changed();
    });
    connect(&m_job, &BackgroundJob::progressed, this, &RendererCheck::changed);
}

RendererCheck::~RendererCheck() = default;

void RendererCheck::setScene(ScenePtr scene) {
    m_scene = std::move(scene);
    m_soon.setInterval(kSceneRest);  // a slider may go on
    compareSoon();
}

void RendererCheck::open(const QStringList& paths) {
    m_paths.clear();
    for (const QString& path : paths) m_paths += QFileInfo(path).absoluteFilePath();
    m_byHand.clear();
    m_report.reset();
    m_buffers.clear();
    m_errors.clear();
    m_readAt.clear();
    m_watch.setPaths(m_paths);
    emit opened();
    m_soon.setInterval(0);
    compareSoon();
    emit changed();
}

void RendererCheck::close() {
    m_job.forget();
    m_soon.stop();
    m_kept.reset();
    m_paths.clear();
    m_report.reset();
    m_buffers.clear();
    m_errors.clear();
    m_watch.setPaths({});
    emit compared();
    emit changed();
}

QString RendererCheck::name() const {
    if (m_paths.size() > 1) return tr("%1 files").arg(m_paths.size());
    if (m_paths.isEmpty()) return {};
    return shownName(m_paths.front()) + (QFileInfo(m_paths.front()).isDir() ? "/" : "");
}

void RendererCheck::setFollowed(bool followed) {
    m_followed = followed;
    emit changed();
    if (followed && std::exchange(m_missed, false)) compareSoon();
}

void RendererCheck::setGiven(int hints) {
    if (std::exchange(m_given, hints) != hints) emit changed();
}

void RendererCheck::readAgain() {
    m_soon.setInterval(0);
    compareSoon();
}

void RendererCheck::cancel() {
    if (!m_job.busy()) return;
    m_job.forget();
    m_cancelled = true;
    emit changed();
}

void RendererCheck::state(const std::string& key, const std::string& value) {
    if (value.empty() ? !m_byHand.erase(key) : std::exchange(m_byHand[key], value) == value) return;
    readAgain();
}

std::pair<std::size_t, std::size_t> RendererCheck::tried() const {
    return m_progress ? std::pair(m_progress->done.load(), m_progress->all.load())
                      : std::pair<std::size_t, std::size_t>();
}

void RendererCheck::compareSoon() {
    if (!isOpen() || !m_scene) return;
    m_missed = !m_followed;
    if (m_followed) m_soon.start();
}

void RendererCheck::compare() {
    if (!isOpen() || !m_scene) return;
    m_cancelled = false;
    m_watch.take();
    if (!m_kept || *m_kept->scene != *m_scene) {
        m_kept = std::make_shared<Kept>();
        m_kept->scene = m_scene;
    }
    ask(false);
}

void RendererCheck::ask(bool names) {
    m_work = names ? Work::Names : Work::Stages;
    m_progress = std::make_shared<Progress>();
    std::vector<std::string> paths;
    for (const QString& path : m_paths) paths.push_back(path.toStdString());
    m_job.ask(
        [kept = m_kept, progress = m_progress, paths, name = name().toStdString(), byHand = m_byHand,
         names](const BackgroundJob::Control& control) -> std::shared_ptr<const ReportResult> {
            const auto give = [](ReportResult result) {
                return std::make_shared<const ReportResult>(std::move(result));
            };
            foreign::CompareOptions options;
            options.known = names;
            options.stop = control.stop;
            options.progress = [&](std::string_view, std::size_t done, std::size_t all) {
                progress->done = done, progress->all = all;
                control.progress(all == 0 ? 0 : double(done) / double(all));
            };
            if (!kept->reference) {
                if (const auto errors = checkSceneAndMemory(*foreign::referenceScene(*kept->scene)); !errors.empty())
                    return give(errors);
                auto reference = foreign::makeReference(*kept->scene, {}, control.stop);
                if (!reference) return give(pipeline::Error{{}, "cancelled", {}});
                kept->reference = std::make_shared<const foreign::Reference>(std::move(*reference));
            }
            foreign::HandedIn in = foreign::readHandedIn(paths, *kept->reference->frame, control.stop);
            if (!byHand.empty()) in.conventions = foreign::withStated(in.conventions, byHand);
            if (in.conventionsName.empty()) in.conventionsName = "mine.toml";
            return give(compareRenderer(*kept->scene, kept->reference, std::move(in), name, options));
        },
        [this, names](const std::shared_ptr<const ReportResult>& result) { take(result, names); });
    emit changed();
}

void RendererCheck::take(const std::shared_ptr<const ReportResult>& result, bool names) {
    m_readAt = QTime::currentTime().toString(QStringLiteral("HH:mm:ss"));
    m_errors = *result ? pipeline::Errors() : result->errors();
    m_report = *result ? ReportPtr(result, &result->value()) : nullptr;
    m_buffers.clear();
    m_work = Work::None;
    m_watch.follow();
    emit compared();
    if (m_report && !names && !m_report->agrees()) return ask(true);
    emit changed();
}

std::optional<pipeline::AnyBuffer> RendererCheck::buffer(const pipeline::AnyBuffer& like) const {
    if (!m_report) return {};
    const std::string name = like.name.text() + like.dtype();
    if (const auto made = m_buffers.find(name); made != m_buffers.end()) return made->second;
    auto made = handedBuffer(*m_report, like);
    if (made) m_buffers.emplace(name, *made);
    return made;
}

QString RendererCheck::whyNo(const pipeline::BufferName& buffer) const {
    if (!isOpen()) return tr("Choose the folder of your renderer first: File, Check my renderer.");
    if (!m_report)
        return m_work == Work::None ? tr("The files could not be compared.") : tr("Your files are being read.");
    return tr("Your renderer has handed in no %1.").arg(toQString(buffer.text()));
}

}  // namespace app
