#include "app/document/session_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QSettings>
#include <QStandardPaths>
#include <utility>

#include "app/jobs/write_file.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/formats/toml/toml_scene.h"

namespace app {

SessionFile::SessionFile(const QString& folder)
    : m_file(QDir(folder).filePath("session.toml")),
      m_tried(QDir(folder).filePath("session.trying.toml")),
      m_previous(QDir(folder).filePath("session.previous.toml")) {}

QString SessionFile::usualFolder() { return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation); }
bool SessionFile::isWanted() { return QSettings().value("session/restore", true).toBool(); }
void SessionFile::setWanted(bool wanted) { QSettings().setValue("session/restore", wanted); }

QString SessionFile::setAside(const QString& file) {
    const QString aside = QFileInfo(m_file).dir().filePath("session.broken.toml");
    QFile::remove(aside);
    return QFile::rename(file, aside) ? aside : file;
}

SessionFile::Left SessionFile::leave() {
    if (!QFile::exists(m_tried)) return {};
    const QString aside = setAside(m_tried);
    QFile::remove(m_file);
    return {{}, {{{}, "the program ended while it restored the last session"}}, aside};
}

SessionFile::Left SessionFile::take() {
    if (const Left ended = leave(); !ended.errors.empty()) return ended;
    if (!QFile::exists(m_file)) return {};
    const auto text = pipeline::readFile(m_file.toStdString(), pipeline::kMaxTomlBytes);
    const auto state =
        text ? lessons::readState(*text, m_file.toStdString()) : pipeline::Result<lessons::WindowState>(text.errors());
    if (!state) return {{}, state.errors(), setAside(m_file)};
    QFile::rename(m_file, m_tried);
    return {*state, {}, {}};
}

bool SessionFile::isTried() const { return QFile::exists(m_tried); }

void SessionFile::settle() { QFile::remove(m_tried); }

void SessionFile::giveBack() {
    if (!QFile::exists(m_tried)) return;
    QFile::remove(m_file);
    QFile::rename(m_tried, m_file);
}

// The last run's may hold changes that were saved nowhere else.
void SessionFile::keepPrevious() {
    if (std::exchange(m_isOwn, true) || !QFile::exists(m_file)) return;
    QFile::remove(m_previous);
    QFile::rename(m_file, m_previous);
}

bool SessionFile::write(const lessons::WindowState& state) {
    keepPrevious();
    QDir().mkpath(QFileInfo(m_file).path());
    return writeFile(m_file, toToml(state)).empty();
}

void SessionFile::remove() {
    keepPrevious();
    QFile::remove(m_file);
}

}  // namespace app
