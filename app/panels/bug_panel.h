#pragma once
#include <QWidget>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/core/background_job.h"
#include "lessons/wrong_picture.h"

class QBoxLayout;
class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPlainTextEdit;
class QPushButton;
class QRadioButton;
class QSpinBox;

namespace app {

class BufferCanvas;
class BugBox;
class MathView;

// The wrong picture: a game in a window of its own. Somebody looks at buffers and pixels of a frame with a planted error,
// marks the first wrong stage, and names the cause. It can be played by the keys alone, and from its texts alone.
class BugPanel : public QWidget {
    Q_OBJECT
public:
    explicit BugPanel(QWidget* parent = nullptr);
    ~BugPanel() override;

    // As many pictures as there are in a round; the same seed gives the same ones.
    void begin(std::uint64_t seed, std::size_t number = 0);
    // Null until the frames are there.
    const lessons::WrongPicture* game() const { return m_game.get(); }
    bool busy() const { return m_job.busy(); }
    std::uint64_t seed() const { return m_seed; }
    std::size_t number() const { return m_number; }  // of this picture, from 0

    void look(const pipeline::BufferName& buffer);
    void look(glm::ivec2 pixel);
    void mark(int box);    // the one that accuse() is about
    void accuse();         // in the phase of stages
    void name(int cause);  // chosen for nameCause()
    void nameCause();      // in the phase of causes
    void giveHint();
    void next();           // once it is over
    QString said() const;  // what was said last: to a look, a mark, a cause, a hint, or the reveal

signals:
    void lessonAsked(const QString& lesson, const QString& heading);

protected:
    void showEvent(QShowEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    // bug_panel_parts.cpp: what it is made of
    QWidget* makeBoxes();
    QWidget* makePictures();
    QWidget* makeCard();
    void addShortcuts();
    QLabel* makeLabel(const char* name, double size, int weight, QWidget* parent);
    // bug_panel.cpp: the game
    void run(std::function<QString(lessons::WrongPicture&)> work, std::function<void(const QString&)> done);
    void take(std::shared_ptr<lessons::WrongPicture> game);
    void say(const QString& text);
    void showState();
    void showStageBuffer(int stage);
    void pressPrimary();
    void moveCursor(QPoint by);
    void lookAtText();
    // bug_panel_show.cpp: pictures
    void showPicture();
    void showBuffer(const pipeline::BufferName& buffer);
    void showReveal();
    void fillBuffers();
    void moveWipe(double by);

    BackgroundJob m_job;
    std::shared_ptr<lessons::WrongPicture> m_game;
    std::uint64_t m_seed = 0;
    std::size_t m_number = 0;
    QString m_error;  // why there is no picture
    int m_marked = -1, m_cause = -1, m_total = 0, m_solved = 0;
    std::optional<glm::ivec2> m_cursor, m_lookedAt;
    std::optional<pipeline::BufferName> m_buffer;  // that was opened last
    QString m_verdict;                             // to the last mark or cause
    double m_share = 0.5;

    std::array<BugBox*, lessons::kBoxes> m_boxes{};
    BufferCanvas *m_picture, *m_opened;
    QComboBox* m_buffers;
    QLabel *m_heading, *m_what, *m_count, *m_stageWords, *m_causeWords, *m_foot, *m_wrongName, *m_rightName, *m_fix;
    QListWidget* m_looks;
    QPlainTextEdit* m_text;
    QLineEdit *m_pixel, *m_seedField;
    QWidget *m_stagePart, *m_causePart, *m_overPart;
    std::array<QRadioButton*, 5> m_causes{};
    QPushButton *m_accuse, *m_hint, *m_nameCause, *m_next, *m_lesson;
    MathView *m_wrongEquation, *m_rightEquation;
};

}  // namespace app
