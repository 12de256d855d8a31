#pragma once
#include <QWidget>

class QLabel;
class QMenuBar;

namespace app {

class Document;
class StageStrip;

// The top of the window: menus, the scene's name in the middle and the command field; below them the stages.
class TopBar : public QWidget {
    Q_OBJECT
public:
    TopBar(Document& document, QWidget* parent);

    QMenuBar& menus() const { return *m_menus; }
    QLabel& title() const { return *m_title; }
    StageStrip& strip() const { return *m_strip; }

signals:
    void commandAsked();

private:
    QMenuBar* m_menus;
    QLabel* m_title;
    StageStrip* m_strip;
};

}  // namespace app
