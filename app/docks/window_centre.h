#pragma once
#include <QWidget>

class QLabel;
class QStackedWidget;

namespace app {

class Document;
class ErrorList;
class StartPage;
class ViewArea;

// The middle of the window: the start page or the views; above them the errors and a banner.
class WindowCentre : public QWidget {
    Q_OBJECT
public:
    WindowCentre(Document& document, QWidget* parent);

    ErrorList& errors() const { return *m_errors; }
    QLabel& banner() const { return *m_banner; }  // what a lesson asks to click; hidden without it
    QStackedWidget& pages() const { return *m_pages; }
    StartPage& start() const { return *m_start; }
    ViewArea& views() const { return *m_views; }

private:
    ErrorList* m_errors;
    QLabel* m_banner;
    QStackedWidget* m_pages;
    StartPage* m_start;
    ViewArea* m_views;
};

}  // namespace app
