#include "app/document/hand.h"

#include <algorithm>
#include <utility>

#include "app/document/document.h"
#include "app/look/text.h"

namespace app {

using pipeline::Hold;

Hand::Hand(Document& document) : m_document(document) {
    connect(&document, &Document::sceneChanged, this, [this] {
        if (!holds().empty()) emit changed();
    });
    connect(&document, &Document::sceneOpened, this, &Hand::letGo);
    connect(&document.frames(), &FrameFeed::frameReady, this, &Hand::follow);
}

void Hand::take(const Page& page) {
    m_start.reset();
    m_page = page;
    m_played = m_hasFrame = false;
    m_shown.clear();
    emit taken();
    follow();
}

void Hand::letGo() {
    static const Page kNothing;
    if (!isEmpty()) take(kNothing);
}

std::optional<pipeline::HoldPlace> Hand::placeOf(std::size_t hold) const {
    if (holds()[hold].kind == Hold::Kind::Eye) return {};
    return pipeline::placeOf(m_document.scene(), holds()[hold]);
}

std::optional<pipeline::HoldPlace> Hand::ownPlaceOf(std::size_t hold) const {
    const pipeline::Scene& own = m_page.half.state.scene;
    if (valuesOf(own, holds()[hold]) == valuesOf(m_document.scene(), holds()[hold])) return {};
    return pipeline::placeOf(own, holds()[hold]);
}

QString Hand::words(std::size_t hold) const { return toQString(wordsOf(m_document.scene(), holds()[hold])); }

double Hand::value(std::size_t hold) const { return valuesOf(m_document.scene(), holds()[hold]).front().second; }

bool Hand::allows(std::string_view beginning) const {
    const auto begins = [&](const std::string& key) { return key.starts_with(beginning); };
    return holds().empty() || std::ranges::any_of(m_page.free, begins) ||
           std::ranges::any_of(holds(), [&](const Hold& hold) { return std::ranges::any_of(hold.keys, begins); });
}

bool Hand::isHeld(std::string_view key) const {
    return std::ranges::any_of(holds(),
                               [&](const Hold& hold) { return std::ranges::find(hold.keys, key) != hold.keys.end(); });
}

std::optional<std::size_t> Hand::holdOfObject(std::size_t object) const {
    const auto found =
        std::ranges::find_if(holds(), [&](const Hold& hold) { return movesObject(hold) && hold.index == object; });
    if (found == holds().end()) return {};
    return std::size_t(found - holds().begin());
}

std::optional<std::size_t> Hand::holdOfEye() const {
    const auto found = std::ranges::find(holds(), Hold::Kind::Eye, &Hold::kind);
    if (found == holds().end()) return {};
    return std::size_t(found - holds().begin());
}

void Hand::begin(std::size_t hold, glm::dvec2 at) {
    m_start = m_document.sharedScene();
    m_dragged = hold;
    m_from = at;
}

void Hand::moveTo(glm::dvec2 at, bool coarse) {
    if (m_start) set(valuesAt(*m_start, holds()[m_dragged], m_from, at, coarse), Moves::Live);
}

void Hand::end() {
    if (!m_start) return;
    set(valuesOf(m_document.scene(), holds()[m_dragged]), Moves::Done);
    m_start.reset();
}

void Hand::cancel() {
    if (!m_start) return;
    set(valuesOf(*m_start, holds()[m_dragged]), Moves::Done);
    m_start.reset();
}

void Hand::nudge(std::size_t hold, glm::ivec2 by, bool coarse) {
    m_dragged = hold;
    set(nudged(m_document.scene(), holds()[hold], by, coarse), Moves::Done);
}

void Hand::restore(std::size_t hold) {
    m_dragged = hold;
    set(valuesOf(m_page.half.state.scene, holds()[hold]), Moves::Done);
}

void Hand::set(const pipeline::Assignments& assignments, Moves moves) {
    auto scene = withSettings(m_document.scene(), pipeline::toText(assignments));
    if (!scene || !checkScene(*scene).empty()) return;
    m_document.edit(std::move(scene).value(), tr("move %1").arg(toQString(holds()[m_dragged].name)),
                    moves == Moves::Live ? Document::Change::Live : Document::Change::Done);
}

void Hand::follow() {
    const pipeline::FramePtr& frame = m_document.frames().whole();
    if (!frame || isEmpty()) return;
    m_hasFrame = m_hasFrame || frame->sharedScene() == m_document.sharedScene();  // not of the page before
    if (!m_hasFrame) return;
    const lessons::Context context{.frame = *frame};
    if (!held().shows.empty()) {
        const auto text = filled(held().shows, context);
        m_shown = text ? toQString(*text).simplified() : QString();  // a value that is not finite has no words
    }
    if (held().play && !m_played) {
        const auto ended = evaluate(held().play->until, context);
        m_played = ended && ended->numbers[0] == 1;
    }
    emit changed();
}

}  // namespace app
