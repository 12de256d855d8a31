#pragma once
#include <QButtonGroup>
#include <QWidget>

namespace app {

// One of a few choices, side by side: all are seen, one is filled.
class Segmented : public QWidget {
    Q_OBJECT
public:
    explicit Segmented(const QStringList& choices, QWidget* parent = nullptr);

    // The width that these choices need side by side.
    static int widthFor(const QStringList& choices);

    void setCurrent(int choice);  // says nothing
    int current() const { return m_group.checkedId(); }

signals:
    void chosen(int choice);  // by the user

private:
    QButtonGroup m_group;
};

}  // namespace app
