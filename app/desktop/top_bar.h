#pragma once
#include <QWidget>

class QLabel;

namespace app {

class Actions;
class Document;
class StageStrip;

// The top of the window: menus, the scene's name in the middle and the command field; below them the stages.
class TopBar : public QWidget {
    Q_OBJECT
public:
    TopBar(Document& document, Actions& actions, QWidget* parent);

    QLabel& title() const { return *m_title; }
    StageStrip& strip() const { return *m_strip; }

private:
    QLabel* m_title;
    StageStrip* m_strip;
};

}  // namespace app
