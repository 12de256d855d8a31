#include "app/desktop/session.h"

#include "app/document/document.h"

namespace app {

Session::Session(Document& document, const QString& folder, std::function<std::optional<lessons::WindowState>()> state,
                 QObject* parent)
    : QObject(parent), m_document(document), m_file(folder), m_state(std::move(state)) {
    m_soon.setSingleShot(true);
    m_soon.setInterval(3000);
    connect(&m_soon, &QTimer::timeout, this, [this] { save(); });
    connect(&document, &Document::sceneOpened, this, &Session::saveSoon);
    connect(&document, &Document::sceneChanged, this, &Session::saveSoon);
    connect(&document, &Document::stageChanged, this, &Session::saveSoon);
    connect(&document.pointing(), &Pointing::pixelChanged, this, &Session::saveSoon);
    connect(&document.pointing(), &Pointing::channelChanged, this, &Session::saveSoon);
    connect(&document.stepper(), &Stepper::changed, this, &Session::saveSoon);
    // A first frame has come of it: that scene does not end the program. One of the two files is always there.
    connect(&document.frames(), &FrameFeed::frameReady, this, [this] {
        if (m_file.isTried() && save()) m_file.settle();
    });
}

void Session::begin() {
    if (!m_state()) m_file.giveBack();
}

void Session::end(bool withChanges) {
    if (SessionFile::isWanted() && !m_state()) return m_file.giveBack();
    save(withChanges) ? m_file.settle() : m_file.giveBack();
}

void Session::forget() {
    m_soon.stop();
    m_file.remove();
}

bool Session::save(bool withChanges) {
    m_soon.stop();
    if (!SessionFile::isWanted()) {
        m_file.remove();
        return true;
    }
    auto state = m_state();
    if (!state) return false;
    if (!withChanges) state->set.clear(), state->sceneText.clear();
    const bool written = m_file.write(*state);
    // Once: it may go on for long.
    if (!written && !m_toldOfFailure)
        emit m_document.said(tr("The session is not kept: %1 could not be written.").arg(m_file.file()));
    m_toldOfFailure = !written;
    return written;
}

}  // namespace app
