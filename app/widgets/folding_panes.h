#pragma once
#include <QList>
#include <QWidget>

class QSplitter;

namespace app {

class Segmented;

// Parts of a window side by side. Where the window is narrower than their least widths together, one at a time, chosen
// by its name above.
class FoldingPanes : public QWidget {
    Q_OBJECT
public:
    // The first is in front where they are folded; their names are the choices.
    FoldingPanes(const QList<QWidget*>& panes, const QStringList& names, QWidget* parent);

    bool isFolded() const { return m_isFolded; }
    void bringToFront(int pane);           // where they are folded
    void setWishes(const QList<int>& px);  // widths where there is room, in pixels of the theme
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fold();

    QList<QWidget*> m_panes;
    QSplitter* m_splitter;
    Segmented* m_names;
    int m_front = 0;
    bool m_isFolded = false;
};

}  // namespace app
