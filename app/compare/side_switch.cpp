#include "app/compare/side_switch.h"

#include <utility>

namespace app {

SideSwitch::SideSwitch(QObject* parent) : QObject(parent) {
    m_blink.setInterval(700);  // well below three flashes a second
    connect(&m_blink, &QTimer::timeout, this, [this] {
        m_blinksToB = !m_blinksToB;
        emit turned();
    });
}

void SideSwitch::setMode(CompareMode mode) {
    m_mode = mode == m_mode ? CompareMode::A : mode;
    m_blinksToB = false;
    m_mode == CompareMode::Blink ? m_blink.start() : m_blink.stop();
}

void SideSwitch::setShare(double share) {
    m_share = share;
    emit turned();
}

bool SideSwitch::holdOther(bool held) { return std::exchange(m_holdsOther, held) != held; }
bool SideSwitch::holdPrevious(bool held) { return std::exchange(m_holdsPrevious, held) != held; }

Wipe SideSwitch::wipe() const {
    Wipe wipe;
    if (isHeld() || m_mode == CompareMode::B || (m_mode == CompareMode::Blink && m_blinksToB))
        wipe.share = 0;
    else if (m_mode == CompareMode::Wipe)
        wipe.share = m_share, wipe.hasHandle = true;
    return wipe;
}

}  // namespace app
