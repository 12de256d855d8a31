#include "app/frames/frame_pacing.h"

namespace app {

FramePacing::FramePacing(QObject* parent) : QObject(parent) {
    constexpr int kRestMilliseconds = 200;
    m_moving.setSingleShot(true);
    m_moving.setInterval(kRestMilliseconds);
    connect(&m_moving, &QTimer::timeout, this, &FramePacing::rested);
    m_held.setSingleShot(true);
    connect(&m_held, &QTimer::timeout, this, &FramePacing::due);
}

void FramePacing::setLive(bool live) {
    m_live = live;
    if (live) return m_moving.start();
    m_moving.stop();
}

void FramePacing::hold(const QObject* who, bool holds) {
    if (holds)
        m_holding.insert(who);
    else
        m_holding.erase(who);
    if (m_holding.empty() && m_held.isActive()) m_held.start(0);
}

bool FramePacing::waits(bool computes) {
    constexpr qint64 kLongest = 1000 / 60;  // milliseconds
    if (!m_live) return false;
    if (computes) return true;
    if (m_holding.empty() || m_sinceRequest.hasExpired(kLongest)) return false;
    m_held.start(int(kLongest - m_sinceRequest.elapsed()));
    return true;
}

void FramePacing::dueNow() { m_held.start(0); }

void FramePacing::takeTurn() { m_held.stop(); }

void FramePacing::countFromHere() { m_sinceRequest.start(); }

}  // namespace app
