#include "app/desktop/shown_state.h"

#include "app/docks/window_layout.h"
#include "app/document/document_state.h"
#include "app/views/view_area.h"
#include "app/widgets/error_list.h"
#include "lessons/state/state_scene.h"

namespace app {

ShownState::ShownState(Document& document, ViewArea& views, const WindowLayout& layout, ErrorList& errors,
                       QObject* parent)
    : QObject(parent), m_document(document), m_views(views), m_layout(layout), m_errors(errors) {}

bool ShownState::hasScene() const { return m_layout.showsScene(); }

std::optional<lessons::WindowState> ShownState::now(const std::filesystem::path& folder) const {
    if (!hasScene()) return {};
    auto state = stateOf(m_document, folder);
    if (!state) return {};  // a scene too large to be kept
    lessons::WindowState whole = std::move(state).value();
    m_views.fill(whole);
    nameFilesFrom(whole, folder);
    return whole;
}

void ShownState::lookAt(const lessons::WindowState& state) {
    if (const pipeline::Errors errors = m_views.lookAt(state); !errors.empty())
        m_errors.report(tr("Not all of it could be shown."), errors);
}

void ShownState::showPlace(const lessons::WindowState& state) {
    app::showPlace(m_document, state);
    lookAt(state);
}

void ShownState::showBuffers(const std::vector<pipeline::BufferName>& buffers) { m_views.showBuffers(buffers); }

StepLooks ShownState::looksTo(const lessons::WindowState& next) {
    const auto now = this->now();
    if (!now) return {};
    const auto show = [this](const lessons::WindowState& state) { return [this, state] { showPlace(state); }; };
    return {show(*now), show(next)};
}

}  // namespace app
