#pragma once
#include <QAbstractListModel>
#include <QString>
#include <QTimer>

#include "lessons/state/cue_list.h"

namespace app {

// The cues of a talk: a row a cue, and the file that they are in. What is changed is written to the
// file a moment later, unless someone else has written to it since.
class CueModel : public QAbstractListModel {
    Q_OBJECT
public:
    enum Role { PlaceRole = Qt::UserRole, CurrentRole };  // where the cue stands, in words; bool

    // file: where the list is until another one is opened; need not be there. One that cannot be read stays as it is:
    // then the list begins empty in a file of a free name beside it, and unread() says why.
    explicit CueModel(const QString& file, QObject* parent = nullptr);
    ~CueModel() override;

    const pipeline::Errors& unread() const { return m_unread; }
    const lessons::CueList& list() const { return m_list; }
    const QString& file() const { return m_file; }
    std::filesystem::path folder() const;  // from which scenes are named
    int size() const { return int(m_list.cues.size()); }
    const lessons::Cue& cue(int i) const { return m_list.cues[std::size_t(i)]; }
    int current() const { return m_current; }  // the cue shown last; -1: none
    const lessons::Cue* currentCue() const { return m_current < 0 ? nullptr : &cue(m_current); }
    void setCurrent(int i);

    // When the file cannot be read, or the list before cannot be written, that one stays; notRead() or notWritten() tells
    // why.
    bool open(const QString& file);
    bool readAgain();  // likewise; what has not been written is given up
    // And goes on there; scenes are named from its folder. When it cannot be written nothing changes, and notWritten()
    // tells why.
    bool saveAs(const QString& file);
    bool write();  // now, what has been changed; likewise
    bool isUnsaved() const { return m_list != m_written; }
    void clear();  // an empty list in the file of the beginning; likewise
    void setMinutes(int minutes);

    int add(lessons::Cue cue);  // after the current one, under a free name; gives its row and makes it current
    void setState(int i, const lessons::WindowState& state);
    bool rename(int i, const QString& name);  // not to nothing, nor to the name of another
    void setCaption(int i, const QString& caption);
    void setNote(int i, const QString& note);
    void move(int from, int to);  // to: its row afterwards
    void remove(int i);
    bool canPutBack() const { return m_removed.has_value(); }
    void putBack();  // what was removed last

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    bool moveRows(const QModelIndex& from, int row, int count, const QModelIndex& to, int child) override;

signals:
    void changed();  // the list, its file, or which cue is current
    void notRead(const pipeline::Errors& errors);
    void putAside(const QString& file);  // the own list, when a new one began
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
    std::optional<std::pair<int, lessons::Cue>> m_removed;
    std::string m_text;  // of the file, with what someone has written into it by hand; m_written is the list in it
    lessons::CueList m_written;
};

}  // namespace app
