#pragma once
#include <QObject>
#include <functional>
#include <map>

class QKeyEvent;
class QWidget;

namespace app {

class AskPanel;
class PenLayer;
class Stepper;
class TalkCaption;
class TalkHint;
class TalkWork;
class ViewArea;

// What the keys of a talk act on.
struct TalkParts {
    QWidget& talk;  // their window
    Stepper& stepper;
    ViewArea& views;
    AskPanel& ask;
    TalkCaption& caption;
    TalkHint& hint;
    TalkWork& work;
    PenLayer& pen;
};

// The keys of a talk. Each key that is pressed is shown in the caption.
class TalkKeys : public QObject {
    Q_OBJECT
public:
    explicit TalkKeys(const TalkParts& parts);

    bool take(int key);  // false where it does nothing here

signals:
    void left();
    void swapAsked();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void escape();
    bool clearPen();
    bool wants(int key) const;
    void showKey(const QKeyEvent& key);

    TalkParts m_parts;
    std::map<int, std::function<void()>> m_runs;  // by key
};

}  // namespace app
