#pragma once
#include <QTextBrowser>
#include <QTimer>

namespace app {

// The manual's pages: links lead from one to the next, pictures are as wide as the window at most.
class ManualPage : public QTextBrowser {
    Q_OBJECT
public:
    explicit ManualPage(QWidget* parent);

    void scrollToHeading(const QString& name);  // "in-a-file": as a link has it

protected:
    QVariant loadResource(int type, const QUrl& name) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QTimer m_reload;
};

// The manual in a window of its own, at the page of what one is at.
class ManualWindow : public QWidget {
    Q_OBJECT
public:
    explicit ManualWindow(QWidget* parent);

    void open(const QString& page);  // "pixel.md"
    ManualPage* page() { return m_page; }

private:
    ManualPage* m_page;
};

// What a link to this heading has after its #.
QString headingName(const QString& heading);
// The page about the part of the window that a widget stands in.
QString manualPageOf(const QWidget* widget);

}  // namespace app
