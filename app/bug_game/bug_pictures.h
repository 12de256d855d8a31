#pragma once
#include <QSplitter>
#include <optional>

#include <glm/glm.hpp>

#include "pipeline/buffers/buffer_table.h"

class QComboBox;

namespace app {

class BufferCanvas;
class BugRound;

// The two pictures of the game: the wrong one, and the buffer that was opened last. Once it is over, right beside wrong.
class BugPictures : public QSplitter {
    Q_OBJECT
public:
    BugPictures(BugRound& round, QWidget* parent);

    void takeKeys();  // the picture has them

signals:
    void cursorMoved(QPoint pixel);  // by the arrows, without a look

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    BufferCanvas* makeCanvas(const QString& name, const char* object);
    QWidget* makeOpened();
    void begin();
    void fillBuffers();
    void showBuffer(const pipeline::BufferName& buffer);
    void showPixel();
    void showReveal();
    void showState();
    void look(QPoint pixel);
    void moveCursor(QPoint by);
    void moveWipe(double by);

    BugRound& m_round;
    BufferCanvas *m_picture, *m_opened;
    QComboBox* m_buffers;
    std::optional<glm::ivec2> m_cursor;
    double m_share = 0.5;  // of the right picture
};

}  // namespace app
