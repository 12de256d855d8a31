#include "app/lesson/lesson_run.h"

#include <algorithm>
#include <cassert>

#include "app/document/document_state.h"
#include "app/document/hand.h"
#include "app/look/text.h"
#include "lessons/state/state_scene.h"
#include "pipeline/run/runner.h"
#include "pipeline/scene/settings_table.h"

namespace app {

using lessons::Page;

namespace {

pipeline::FramePtr frameOf(const lessons::Half& half, pipeline::FrameRequest request, const std::stop_token& stop,
                           const pipeline::FramePtr& before) {
    request.stop = stop;
    return runFrame(std::make_shared<const pipeline::Scene>(half.state.scene), request, before);
}

// The frames that texts and mistakes compare with are computed here too, so that judging an answer finds them.
PageTexts textsOf(const Page& page, const std::stop_token& stop) {
    PageTexts texts;
    texts.changed = std::make_shared<lessons::ChangedFrames>();
    texts.frames.first = frameOf(page.first, requestFor(page), stop, {});
    if (!texts.frames.first) return texts;
    const lessons::Context context{*texts.frames.first, texts.changed.get(), nullptr, stop};
    texts.text = filled(page.first.text, context, texts.errors);
    if (page.question) {
        texts.question = filled(page.question->text, context, texts.errors);
        for (const lessons::Prose* row : rowsOf(*page.question))
            texts.options.push_back(filled(*row, context, texts.errors));
        for (const lessons::Expression* expression : expressionsOf(*page.question))
            static_cast<void>(evaluate(*expression, context));
    }
    if (!page.then) return texts;
    texts.frames.then = frameOf(*page.then, requestForThen(page), stop, texts.frames.first);
    if (!texts.frames.then) return texts;
    texts.then = filled(page.then->text, {*texts.frames.then, texts.changed.get(), nullptr, stop}, texts.errors);
    return texts;
}

}  // namespace

double fullPoints(const Page& page) { return page.question ? page.question->points : 0; }

double pointsOf(const Page& page, const lessons::Progress& progress) {
    return page.question ? lessons::Attempt(*page.question, progress).points() : 0;
}

LessonRun::LessonRun(Document& document, QObject* parent) : QObject(parent), m_document(document) {}

void LessonRun::open(const lessons::Lesson& lesson, int page) {
    m_lesson = &lesson;
    goTo(page);
}

void LessonRun::close() {
    m_lesson = nullptr;
    m_attempt.reset();
    m_texts.reset();
    m_job.forget();
    m_document.frames().want(this, {});
    m_document.setHidden({});
    m_document.hand().letGo();
    emit pageChanged();
}

bool LessonRun::turn(int by) {
    if (by > 0 && !isSettled()) return false;
    goTo(m_page + by);
    return true;
}

void LessonRun::goTo(int page) {
    if (!m_lesson || page < 0 || page > pageCount()) return;
    m_page = page;
    m_texts.reset();
    m_attempt.reset();
    m_job.forget();
    m_since.start();
    if (!isAtEnd() && current().question) m_attempt.emplace(*current().question, progress(page));
    m_document.setHidden(isAtEnd() ? lessons::Hidden() : hiddenOn(current(), isSettled()));
    emit pageChanged();
    if (isAtEnd()) return m_document.hand().letGo();
    setWindow();
    fill();
}

const lessons::Half& LessonRun::half() const {
    return current().then && isSettled() ? *current().then : current().first;
}

void LessonRun::setWindow() {
    const lessons::PageState& state = half().state;
    const bool isOpen =
        m_document.hasScene() && m_document.kept().file.isEmpty() && m_document.scene().file == state.scene.file;
    if (isOpen)
        m_document.showState(state.scene);
    else
        m_document.setScene(state.scene);
    lessons::WindowState window = state.window;
    findFilesFrom(window, folderOf(*m_lesson, current()));
    showPlace(m_document, window);
    // Texts and other questions have frames of their own.
    const auto* until = m_attempt ? std::get_if<lessons::UntilQuestion>(&current().question->kind) : nullptr;
    pipeline::BufferSet wanted = buffersOf(half().held);
    if (until && !isSettled()) wanted |= requestFor(current()).wanted;
    m_document.frames().want(this, wanted);
    const bool keepsFigure = current().first.held.figure || (current().then && current().then->held.figure);
    m_document.hand().take({half(), until ? until->free : std::vector<std::string>(), keepsFigure, isSettled()});
    emit showViews(window);
}

void LessonRun::fill() {
    m_job.ask([page = current()](const BackgroundJob::Control& control) { return textsOf(page, control.stop); },
              [this](const PageTexts& texts) {
                  if (!texts.frames.first || (current().then && !texts.frames.then)) return;  // stopped
                  m_texts = texts;
                  if (!texts.errors.empty()) emit failed(texts.errors);
                  emit filled();
              });
}

bool LessonRun::isElsewhere() const {
    if (!m_lesson || isAtEnd() || !m_document.hasScene()) return false;
    const pipeline::Scene &mine = m_document.scene(), &page = half().state.scene;
    const std::vector<pipeline::SettingRef> settings = settingsOf(mine);
    return settings.size() != settingsOf(page).size() ||
           std::ranges::any_of(settings, [&](const pipeline::SettingRef& ref) {
               return ref.get(mine) != ref.get(page) && !m_document.hand().isHeld(ref.key());
           });
}

lessons::Context LessonRun::context() const {
    assert(m_texts);
    return {*m_texts->frames.first, m_texts->changed.get(), nullptr, {}};
}

std::optional<lessons::Gauge> LessonRun::gauge() const {
    const auto* until = m_attempt ? std::get_if<lessons::UntilQuestion>(&current().question->kind) : nullptr;
    const pipeline::FramePtr& frame = m_document.frames().whole();
    if (!until || !frame) return {};
    const auto gauge = gaugeOf(*until, {.frame = *frame});
    return gauge ? *gauge : std::nullopt;
}

pipeline::Result<lessons::Verdict> LessonRun::check(const lessons::Given& given) {
    assert(m_attempt && m_texts && !m_attempt->isSettled());
    const bool isReaders = std::holds_alternative<lessons::UntilQuestion>(current().question->kind);
    if (isReaders && (!m_document.frames().whole() || m_document.frames().whole()->scene() != m_document.scene()))
        return lessons::Verdict{lessons::Mark::Again, {}, {}, tr("The picture is being computed.").toStdString()};
    lessons::Context context{isReaders ? *m_document.frames().whole() : *m_texts->frames.first,
                             isReaders ? nullptr : m_texts->changed.get(),
                             nullptr,
                             {}};
    auto verdict = m_attempt->check(given, context, double(m_since.elapsed()) / 1000);
    if (verdict && verdict->mark != lessons::Mark::Again) keep();
    return verdict;
}

pipeline::Result<std::string> LessonRun::hint() {
    auto text = m_attempt->nextHint(context());
    if (text) keep();
    return text;
}

void LessonRun::showMe() {
    m_attempt->showMe();
    keep();
}

void LessonRun::keep() {
    m_results.keep(*m_lesson, current(), m_attempt->progress());
    if (isSettled()) {
        m_document.setHidden({});
        if (current().then) setWindow();
    }
    emit changed();
}

lessons::Progress LessonRun::progress(int page) const {
    const Page& one = m_lesson->pages[std::size_t(page)];
    return m_results.progress(toQString(m_lesson->name), toQString(one.heading));
}

double LessonRun::points(int page) const { return app::pointsOf(m_lesson->pages[std::size_t(page)], progress(page)); }

double LessonRun::pointsSoFar() const {
    double sum = 0;
    for (int page = 0; page < pageCount(); ++page) sum += points(page);
    return sum;
}

double LessonRun::pointsOf() const {
    double sum = 0;
    for (int page = 0; page < pageCount(); ++page)
        if (progress(page).outcome != lessons::Progress::Outcome::Open)
            sum += fullPoints(m_lesson->pages[std::size_t(page)]);
    return sum;
}

}  // namespace app
