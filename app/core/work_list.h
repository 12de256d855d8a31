#pragma once
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <functional>
#include <vector>

namespace app {

// What is computed and drawn beside the window for what it shows. Once that takes long it is told, can be given up, so
// that what is on show stays, and gone on with.
class WorkList : public QObject {
    Q_OBJECT
public:
    explicit WorkList(QObject* parent = nullptr);

    // name: "the frame". cancel stops it, resume begins it again. Forgotten with `who`.
    void add(const QObject* who, const QString& name, std::function<void()> cancel, std::function<void()> resume);
    void setBusy(const QObject* who, bool busy);  // newer work is no longer stopped
    QStringList running() const;                  // nothing until it takes long
    QStringList stopped() const;
    bool isStopped(const QObject* who) const;
    void cancel();
    void resume();
    void forgetStopped();  // what is on show is of something else

signals:
    void changed();

private:
    struct Work {
        const QObject* who;
        QString name;
        std::function<void()> cancel, resume;
        bool busy = false, stopped = false;
    };
    QStringList names(bool Work::*state) const;

    std::vector<Work> m_works;
    QTimer m_slow;  // runs until what is busy takes long
};

}  // namespace app
