#pragma once
#include <QPushButton>
#include <functional>

#include "app/jobs/background_job.h"
#include "lessons/lesson.h"

namespace app {

// Writes a lesson as a handout: asks where to, and goes on beside the window.
class HandoutButton : public QPushButton {
    Q_OBJECT
public:
    // lesson: asked for when it is pressed; may give null.
    HandoutButton(std::function<const lessons::Lesson*()> lesson, QWidget* parent);

signals:
    void written(const QString& sentence);
    void failed(const QString& sentence, const pipeline::Errors& errors);

private:
    void write();

    std::function<const lessons::Lesson*()> m_lesson;
    BackgroundJob m_job;
};

}  // namespace app
