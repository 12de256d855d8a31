#pragma once
#include <QFrame>
#include <functional>
#include <optional>

class QLabel;
class QScrollArea;

namespace app {

// One lesson as the start page shows it.
struct StartLesson {
    QString name, title, text;  // name: what opens it
    int page = 0, pages = 0;    // page 0: not begun
    int minutes = 0;            // 0: not known
    std::optional<std::size_t> lecture = {};

    bool isDone() const { return page >= pages; }
    bool isBegun() const { return page > 0 && !isDone(); }
};

class LessonRow;

// The lessons of a lecture in the order in which they are done: a mark for what is done, else a number and minutes; the
// one to go on with is lit. The arrows move, and Tab leaves.
class StartLessons : public QFrame {
    Q_OBJECT
public:
    explicit StartLessons(QWidget* parent);

    void setLessons(const std::vector<StartLesson>& lessons);
    // Shows those that are wanted. Whether there is any.
    bool choose(const std::function<bool(const LessonRow& row)>& isWanted);
    void setColumns(int columns);  // 1 or 2
    int wantedHeight(int width) const;
    const QList<LessonRow*>& shown() const { return m_shown; }

signals:
    void chosen(const QString& name);

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();
    int rowsHeight(int width) const;
    int headHeight() const;
    void focus(LessonRow* row);

    QLabel *m_title, *m_done;
    QScrollArea* m_area;
    QWidget* m_list;
    QList<LessonRow*> m_rows, m_shown;
    LessonRow* m_next = nullptr;  // to go on with
    int m_columns = 1;
};

}  // namespace app
