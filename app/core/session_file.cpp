#include "app/core/session_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QSettings>
#include <QStandardPaths>

#include "app/core/write_file.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/formats/toml_scene.h"

namespace app {

SessionFile::SessionFile(const QString& folder)
    : m_file(QDir(folder).filePath("session.toml")), m_tried(QDir(folder).filePath("session.trying.toml")) {}

QString SessionFile::usualFolder() { return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation); }
bool SessionFile::isWanted() { return QSettings().value("session/restore", true).toBool(); }
void SessionFile::setWanted(bool wanted) { QSettings().setValue("session/restore", wanted); }

QString SessionFile::setAside(const QString& file) {
    const QString aside = QFileInfo(m_file).dir().filePath("session.broken.toml");
    QFile::remove(aside);
    return QFile::rename(file, aside) ? aside : file;
}

SessionFile::Left SessionFile::take() {
    if (QFile::exists(m_tried)) {
        const QString aside = setAside(m_tried);
        QFile::remove(m_file);
        return {{}, {{{}, "the program ended while it restored the last session"}}, aside};
    }
    if (!QFile::exists(m_file)) return {};
    const auto text = pipeline::readFile(m_file.toStdString(), pipeline::kMaxTomlBytes);
    const auto state = text ? readState(*text, m_file.toStdString()) : pipeline::Result<WindowState>(text.errors());
    if (!state) return {{}, state.errors(), setAside(m_file)};
    QFile::rename(m_file, m_tried);
    return {*state, {}, {}};
}

void SessionFile::settle() { QFile::remove(m_tried); }

bool SessionFile::giveBack() {
    if (!QFile::exists(m_tried)) return false;
    QFile::remove(m_file);
    return QFile::rename(m_tried, m_file);
}

bool SessionFile::write(const WindowState& state) {
    QDir().mkpath(QFileInfo(m_file).path());
    return writeFile(m_file, toToml(state)).empty();
}

void SessionFile::remove() { QFile::remove(m_file); }

}  // namespace app
