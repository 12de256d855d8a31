#include "app/desktop/session.h"

#include "app/core/document.h"

namespace app {

Session::Session(Document& document, const QString& folder, std::function<std::optional<WindowState>()> state,
                 QObject* parent)
    : QObject(parent), m_file(folder), m_state(std::move(state)) {
    m_soon.setSingleShot(true);
    m_soon.setInterval(3000);
    connect(&m_soon, &QTimer::timeout, this, [this] { save(); });
    const auto later = [this] { m_soon.start(); };
    connect(&document, &Document::sceneOpened, this, later);
    connect(&document, &Document::sceneChanged, this, later);
    connect(&document, &Document::stageChanged, this, later);
    connect(&document, &Document::pixelChanged, this, later);
    connect(&document, &Document::channelChanged, this, later);
    connect(&document.stepper(), &Stepper::changed, this, later);
    // A first frame has come of it: that scene does not end the program.
    connect(&document, &Document::frameReady, this, [this] { m_file.settle(); });
}

void Session::begin() {
    if (!m_state()) m_file.settle();
}

void Session::save(bool withChanges) {
    m_soon.stop();
    if (!SessionFile::isWanted()) return m_file.remove();
    auto state = m_state();
    if (!state) return m_file.remove();
    if (!withChanges) state->set.clear(), state->sceneText.clear();
    m_file.write(*state);
}

}  // namespace app
