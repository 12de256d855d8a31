#pragma once
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <functional>
#include <vector>

namespace app {

// The background work for what the window shows. Work that takes long is listed. It can be stopped, so that the old
// picture stays, and continued later.
class WorkList : public QObject {
    Q_OBJECT
public:
    explicit WorkList(QObject* parent = nullptr);

    // name: "the frame". cancel stops the work, resume starts it again. Forgotten when `who` is deleted.
    void add(const QObject* who, const QString& name, std::function<void()> cancel, std::function<void()> resume);
    void setBusy(const QObject* who, bool busy);  // newer work counts as not stopped
    QStringList running() const;                  // empty until it takes long
    QStringList stopped() const;
    bool isStopped(const QObject* who) const;
    void cancel();
    void resume();
    void forgetStopped();  // the window shows something else now

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
    QTimer m_slow;  // runs until busy work counts as long
};

}  // namespace app
