#pragma once
#include <QWidget>
#include <array>
#include <memory>

#include "app/frames/frame_worker.h"
#include "pipeline/check/case.h"

class QLabel;

namespace app {

class PictureFrame;

// A case's scene rendered by the naive form and by ours, side by side, with the number of differing pixels. If no
// setting of the stages is the naive form, only ours. The pictures are rendered in the background, always for the
// latest request.
class CheckPictures : public QWidget {
    Q_OBJECT
public:
    explicit CheckPictures(QWidget* parent = nullptr);
    ~CheckPictures() override;

    // scene: the case's, as the knob has it; null where the case has none, which shows nothing.
    void setScene(const pipeline::check::Case& which, std::shared_ptr<const pipeline::Scene> scene);
    bool complete() const;  // every picture asked for is there

private:
    enum Form { Naive, Ours, kForms };
    void take(Form form, pipeline::FramePtr frame, long ticket);
    void compare();

    std::array<PictureFrame*, kForms> m_frames;
    QLabel* m_difference;
    std::array<QString, kForms> m_captions;
    std::array<long, kForms> m_tickets{};  // of what is wanted; 0: nothing
    std::array<pipeline::FramePtr, kForms> m_shown;
    std::array<std::unique_ptr<FrameWorker>, kForms> m_workers;  // last: they call the rest
};

}  // namespace app
