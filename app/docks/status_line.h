#pragma once
#include <QStatusBar>

#include "app/document/document.h"

class QLabel;
class QPushButton;

namespace app {

class ElidedLabel;
class SceneOpener;

// Left the last event in a sentence, and what is being opened and computed; right the pixel under the cursor, remarks about the scene,
// whether the frame contains NaN, the error against double precision, and how many threads compute.
class StatusLine : public QStatusBar {
    Q_OBJECT
public:
    StatusLine(Document& document, const SceneOpener& opener, QWidget* parent = nullptr);

    void say(const QString& sentence);
    // Leaves out what tells of the computation, but for NaN.
    void setQuiet(bool quiet);

signals:
    void cancelAsked();  // the opening

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void showHovered();
    void showCheck();
    void showRemarks();
    void makeRoom(bool anew);  // for the sentence: hides what other parts of the window show too

    Document& m_document;
    bool m_isQuiet = false;
    ElidedLabel* m_sentence;
    QLabel* m_hovered;
    QPushButton* m_turn;  // turns a model whose up axis was guessed
    QLabel* m_remarks;
    QLabel* m_nan;
    QLabel* m_error;
    QLabel* m_threads;
};

// "268, 281  polygon 2  37 93 167": what the frame has at a pixel.
QString pixelText(const pipeline::Frame& frame, glm::ivec2 pixel);

}  // namespace app
