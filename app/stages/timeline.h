#pragma once
#include <array>

#include <QWidget>

#include "app/document/document.h"

class QAction;
class QComboBox;
class QLabel;
class QToolButton;

namespace app {

class Segmented;
class StepBar;

// The frame as a film: transport, what a step is, the scrubber, where it stands in words, and the speed.
class Timeline : public QWidget {
    Q_OBJECT
public:
    // The window's actions for the five buttons; their keys and the reasons why they are disabled come with them.
    struct Transport {
        QAction *first, *back, *play, *next, *last;
    };
    Timeline(Document& document, const Transport& transport, QWidget* parent = nullptr);

    void setCompact(bool compact);  // 46 high with the level as a list; else 56
    StepBar& bar() { return *m_bar; }
    QString words() const;  // where the frame stands

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fitWords();
    void show();
    QToolButton* addButton(QAction* action, const char* name, const char* icon);

    Document& m_document;
    std::array<QToolButton*, 5> m_buttons;
    QLabel* m_by;
    Segmented* m_levels;
    QComboBox* m_levelList;
    StepBar* m_bar;
    QLabel* m_words;
    QComboBox* m_speed;
    bool m_compact = false;
};

}  // namespace app
