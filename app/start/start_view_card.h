#pragma once
#include <QFrame>
#include <vector>

#include "app/start/start_button.h"
#include "app/start/start_order.h"

class QLabel;
class QPushButton;

namespace app {

// Where somebody stands in a lecture's talk.
struct StartTalk {
    int cues = 0, minutes = 0;
    int cue = 0;  // shown last, from 1; 0: not begun
};

// The first card of a lecture: pictures that open their scenes, a button that opens all of them, and one that starts
// the lecture's talk. If there is no height for pictures, one line.
class StartViewCard : public QFrame {
    Q_OBJECT
public:
    StartViewCard(const StartLecture& lecture, QWidget* parent);

    const StartView& view() const { return m_view; }
    QString words() const;  // that a filter finds it by
    void setPicture(std::size_t part, const ScenePicture& picture);
    void setTalk(const StartTalk& talk);
    void setPictureHeight(int height);  // 0: none
    int wantedHeight() const;
    void press() const;  // opens the pictures

signals:
    void opened();
    void sceneChosen(const std::string& name);
    void talkAsked();
    void leftDown();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    class Picture;
    void place();

    StartView m_view;
    std::vector<Picture*> m_pictures;
    QLabel *m_title, *m_talkTitle, *m_talkPlace;
    QPushButton *m_open, *m_talk;
    int m_pictureHeight = 1;
};

}  // namespace app
