#include "app/talk/cue_model.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>

#include "app/document/document_state.h"
#include "app/jobs/write_file.h"
#include "app/look/shown_name.h"
#include "app/look/text.h"
#include "lessons/state/cue_list.h"
#include "lessons/state/cue_text.h"
#include "lessons/state/state_scene.h"

namespace app {

namespace fs = std::filesystem;

namespace {

// "talk 2.cues" beside "talk.cues".
QString freeFile(const QString& file) {
    const QFileInfo info(file);
    for (int i = 2;; ++i) {
        const QString name = QStringLiteral("%1 %2.%3").arg(info.completeBaseName()).arg(i).arg(info.suffix());
        if (const QString free = info.dir().filePath(name); !QFileInfo::exists(free)) return free;
    }
}

}  // namespace

CueModel::CueModel(const QString& file, QObject* parent) : QAbstractListModel(parent), m_ownFile(file), m_file(file) {
    m_soon.setSingleShot(true);
    m_soon.setInterval(500);
    connect(&m_soon, &QTimer::timeout, this, &CueModel::write);
    if (QFileInfo::exists(file)) m_unread = read(file);
    if (!m_unread.empty()) m_ownFile = m_file = freeFile(file);
}

CueModel::~CueModel() {
    blockSignals(true);  // who would tell of it may be gone
    if (m_soon.isActive()) write();
}

fs::path CueModel::folder() const { return QFileInfo(m_file).absolutePath().toStdString(); }

void CueModel::setCurrent(int i) {
    if (i < -1 || i >= size() || i == m_current) return;
    const int before = std::exchange(m_current, i);
    for (const int row : {before, i})
        if (row >= 0) tell(row);
    emit changed();
}

void CueModel::tell(int i) { emit dataChanged(index(i), index(i)); }

std::vector<int> CueModel::votes(int i) const {
    const lessons::Cue& asks = cue(i);
    std::vector<int> votes;
    if (const auto known = m_votes.find(asks.name); known != m_votes.end()) votes = known->second;
    votes.resize(asks.ask ? asks.ask->choices.size() : 0);
    return votes;
}

void CueModel::setVotes(int i, int choice, int number) {
    std::vector<int> votes = this->votes(i);
    votes.at(std::size_t(choice)) = number;
    m_votes[cue(i).name] = std::move(votes);
    emit votesChanged();
}

bool CueModel::open(const QString& file) {
    if (isUnsaved() && !write()) return false;
    const auto errors = read(file);
    if (!errors.empty()) emit notRead(errors);
    return errors.empty();
}

bool CueModel::readAgain() {
    const std::string shown = m_current < 0 ? std::string() : cue(m_current).name;
    const auto errors = read(m_file);
    if (!errors.empty()) {
        emit notRead(errors);
        return false;
    }
    const auto again = std::ranges::find(m_list.cues, shown, &lessons::Cue::name);
    if (again != m_list.cues.end()) setCurrent(int(again - m_list.cues.begin()));
    return true;
}

pipeline::Errors CueModel::read(const QString& file) {
    const auto text = lessons::readCueText(file.toStdString());
    const auto list =
        text ? lessons::readCues(*text, file.toStdString()) : pipeline::Result<lessons::CueList>(text.errors());
    if (!list) return list.errors();
    m_soon.stop();
    beginResetModel();
    m_list = m_written = *list;
    m_text = *text;
    m_file = QFileInfo(file).absoluteFilePath();
    m_current = -1;
    m_removed.reset();
    endResetModel();
    emit changed();
    return {};
}

bool CueModel::saveAs(const QString& file) {
    const fs::path from = folder(), to = QFileInfo(file).absolutePath().toStdString();
    lessons::CueList moved = m_list;
    for (lessons::Cue& cue : moved.cues)
        if (!cue.state.scene.empty())
            cue.state.scene = lessons::sceneName(lessons::sceneFile(cue.state.scene, from), to);
    if (!writeTo(QFileInfo(file).absoluteFilePath(), moved)) return false;
    m_list = std::move(moved);
    m_file = QFileInfo(file).absoluteFilePath();
    m_soon.stop();
    emit changed();
    return true;
}

// The cues that were in the own list stay, in a file beside it.
void CueModel::clear() {
    if (isUnsaved() && !write()) return;
    const auto own = lessons::readCueFile(m_ownFile.toStdString());
    if (QFileInfo::exists(m_ownFile) && !(own && own->cues.empty())) {
        const QString aside = freeFile(m_ownFile);
        if (!QFile::rename(m_ownFile, aside))
            return emit notWritten(aside, {{{m_ownFile.toStdString(), 0, 0}, "could not be renamed", {}}});
        emit putAside(aside);
    }
    beginResetModel();
    m_list = m_written = {};
    m_text.clear();
    m_file = m_ownFile;
    m_current = -1;
    m_removed.reset();
    endResetModel();
    writeTo(m_file, m_list);
    emit changed();
}

bool CueModel::write() {
    m_soon.stop();
    if (isAsRead()) return writeTo(m_file, m_list);
    emit notWritten(m_file, {{{m_file.toStdString(), 0, 0},
                              "someone else has written to it; read the list again, or save it under another name",
                              {}}});
    return false;
}

// Or written. A file that is gone has nothing to lose.
bool CueModel::isAsRead() const {
    if (!QFileInfo::exists(m_file)) return true;
    const auto text = lessons::readCueText(m_file.toStdString());
    return text && *text == m_text;
}

bool CueModel::writeTo(const QString& file, const lessons::CueList& list) {
    QDir().mkpath(QFileInfo(file).path());
    const std::string text = cueText(list, m_text, m_written);
    if (const auto errors = writeFile(file, text); !errors.empty()) {
        emit notWritten(file, errors);
        return false;
    }
    m_text = text, m_written = list;
    return true;
}

void CueModel::setMinutes(int minutes) {
    m_list.minutes = std::clamp(minutes, 1, 600);
    writeSoon();
    emit changed();
}

int CueModel::add(lessons::Cue cue) {
    const int row = m_current + 1;
    cue.name = freeName(m_list, cue.name);
    beginInsertRows({}, row, row);
    m_list.cues.insert(m_list.cues.begin() + row, std::move(cue));
    endInsertRows();
    setCurrent(row);
    writeSoon();
    return row;
}

void CueModel::setState(int i, const lessons::WindowState& state) {
    m_list.cues[std::size_t(i)].state = state;
    writeSoon();
    tell(i);
    emit changed();
}

bool CueModel::rename(int i, const QString& name) {
    const std::string wanted = name.trimmed().toStdString();
    if (wanted.empty()) return false;
    for (int k = 0; k < size(); ++k)
        if (k != i && cue(k).name == wanted) return false;
    m_list.cues[std::size_t(i)].name = wanted;
    writeSoon();
    tell(i);
    emit changed();
    return true;
}

void CueModel::setCaption(int i, const QString& caption) {
    m_list.cues[std::size_t(i)].caption = caption.toStdString();
    writeSoon();
    emit changed();
}

void CueModel::setNote(int i, const QString& note) {
    m_list.cues[std::size_t(i)].note = note.toStdString();
    writeSoon();
    emit changed();
}

void CueModel::move(int from, int to) {
    if (from == to || from < 0 || to < 0 || from >= size() || to >= size()) return;
    moveRows({}, from, 1, {}, to > from ? to + 1 : to);
}

bool CueModel::moveRows(const QModelIndex&, int row, int count, const QModelIndex&, int child) {
    if (count != 1 || row < 0 || row >= size() || child < 0 || child > size()) return false;
    if (!beginMoveRows({}, row, row, {}, child)) return false;
    const auto begin = m_list.cues.begin();
    const int to = child > row ? child - 1 : child;
    if (to > row)
        std::rotate(begin + row, begin + row + 1, begin + to + 1);
    else
        std::rotate(begin + to, begin + row, begin + row + 1);
    if (m_current == row)
        m_current = to;
    else if (m_current > row && m_current <= to)
        --m_current;
    else if (m_current < row && m_current >= to)
        ++m_current;
    endMoveRows();
    writeSoon();
    emit changed();
    return true;
}

void CueModel::remove(int i) {
    if (i < 0 || i >= size()) return;
    beginRemoveRows({}, i, i);
    m_removed.emplace(i, cue(i));
    m_list.cues.erase(m_list.cues.begin() + i);
    // PgDn then leads to the cue that comes next.
    if (m_current >= i) --m_current;
    endRemoveRows();
    if (m_current >= 0) tell(m_current);
    writeSoon();
    emit changed();
}

void CueModel::putBack() {
    if (!m_removed) return;
    auto [row, cue] = *std::exchange(m_removed, std::nullopt);
    row = std::min(row, size());
    cue.name = freeName(m_list, cue.name);
    beginInsertRows({}, row, row);
    m_list.cues.insert(m_list.cues.begin() + row, std::move(cue));
    if (m_current >= row) ++m_current;
    endInsertRows();
    writeSoon();
    emit changed();
}

int CueModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : size(); }

QVariant CueModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= size()) return {};
    const lessons::Cue& one = cue(index.row());
    switch (role) {
        case Qt::DisplayRole: return QStringLiteral("%1  %2").arg(index.row() + 1).arg(onOneLine(one.name));
        case CaptionRole:
            return QStringLiteral("%1  %2")
                .arg(index.row() + 1)
                .arg(onOneLine(one.caption.empty() ? one.name : one.caption));
        case Qt::EditRole: return toQString(one.name);
        case Qt::ToolTipRole:
        case PlaceRole: return placeText(one.state);
        case CurrentRole: return index.row() == m_current;
        case Qt::AccessibleTextRole: {
            const QString text =
                tr("Cue %1, %2, %3").arg(index.row() + 1).arg(onOneLine(one.name), placeText(one.state));
            return index.row() == m_current ? text + tr(", on show") : text;
        }
        default: return {};
    }
}

bool CueModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    return role == Qt::EditRole && index.isValid() && rename(index.row(), value.toString());
}

Qt::ItemFlags CueModel::flags(const QModelIndex& index) const {
    // Dropped between rows, never onto one.
    if (!index.isValid()) return Qt::ItemIsDropEnabled;
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemIsDragEnabled;
}

}  // namespace app
