#pragma once
#include <QAbstractListModel>
#include <QString>
#include <QTimer>
#include <map>

#include "lessons/state/cue_list.h"

namespace app {

// The cues of a talk, one row each, and their file. Changes are written to the file a moment later, unless somebody
// else has written to it since.
class CueModel : public QAbstractListModel {
    Q_OBJECT
public:
    // The cue's place in words; whether it is current; its number with its caption, which an audience reads.
    enum Role { PlaceRole = Qt::UserRole, CurrentRole, CaptionRole };

    // file: the list's file until another one is opened; it need not exist. If it cannot be read, it is kept: the list
    // then begins empty in a new file beside it, and unread() gives the reason.
    explicit CueModel(const QString& file, QObject* parent = nullptr);
    ~CueModel() override;

    const pipeline::Errors& unread() const { return m_unread; }
    const lessons::CueList& list() const { return m_list; }
    const QString& file() const { return m_file; }
    std::filesystem::path folder() const;  // scene names are relative to it
    int size() const { return int(m_list.cues.size()); }
    const lessons::Cue& cue(int i) const { return m_list.cues[std::size_t(i)]; }
    int current() const { return m_current; }  // the last cue shown; -1: none
    const lessons::Cue* currentCue() const { return m_current < 0 ? nullptr : &cue(m_current); }
    void setCurrent(int i);

    // If the file cannot be read, or the old list cannot be written, the old list stays. notRead() or notWritten()
    // gives the reason.
    bool open(const QString& file);
    bool readAgain();  // the same; unwritten changes are discarded
    // Continues in that file, with scene names relative to its folder. If it cannot be written, nothing changes, and
    // notWritten() gives the reason.
    bool saveAs(const QString& file);
    bool write();  // writes changes now; the same
    bool isUnsaved() const { return m_list != m_written; }
    void clear();  // an empty list in the first file; the same
    void setMinutes(int minutes);

    // By hands, on each choice of a cue that asks; kept as long as the program runs.
    std::vector<int> votes(int i) const;
    void setVotes(int i, int choice, int votes);

    int add(lessons::Cue cue);  // after the current one, with a free name; returns its row and makes it current
    void setState(int i, const lessons::WindowState& state);
    bool rename(int i, const QString& name);  // not to an empty name or the name of another cue
    void setCaption(int i, const QString& caption);
    void setNote(int i, const QString& note);
    void move(int from, int to);  // to: its row afterwards
    void remove(int i);
    bool canPutBack() const { return m_removed.has_value(); }
    void putBack();  // the last removed cue

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    bool moveRows(const QModelIndex& from, int row, int count, const QModelIndex& to, int child) override;

signals:
    void changed();  // the list, its file, or the current cue
    void votesChanged();
    void notRead(const pipeline::Errors& errors);
    void putAside(const QString& file);  // the program's own list, when a new one was begun
    void notWritten(const QString& file, const pipeline::Errors& errors);

private:
    void writeSoon() { m_soon.start(); }
    pipeline::Errors read(const QString& file);
    bool isAsRead() const;
    bool writeTo(const QString& file, const lessons::CueList& list);
    void tell(int i);

    QString m_ownFile, m_file;
    pipeline::Errors m_unread;
    lessons::CueList m_list;
    int m_current = -1;
    QTimer m_soon;
    std::map<std::string, std::vector<int>> m_votes;  // by the cue's name
    std::optional<std::pair<int, lessons::Cue>> m_removed;
    std::string m_text;  // of the file, with edits by hand; m_written is the list in it
    lessons::CueList m_written;
};

}  // namespace app
