#pragma once
#include <QDialog>
#include <atomic>
#include <memory>

#include "app/export/slide_picture.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace app {

// A picture for a slide: what of the window, how large, on what ground; with a preview.
class SlideDialog : public QDialog {
    Q_OBJECT
public:
    // state: what the window shows; goes into the file.
    SlideDialog(const Document& document, ViewArea& views, lessons::WindowState state, QWidget* parent = nullptr);

    SlideRequest request() const;
    void save(const QString& file);  // writes on a worker thread; the dialog shows the result
    bool isWorking() const { return m_job.busy(); }
    QString message() const;
    void reject() override;  // cancels what is being made, and stays to say so; else closes

private:
    QWidget* makeFields();
    void preview();
    struct Made {
        QImage image;
        pipeline::Errors errors;
    };
    // finish(made, decided) on the job's thread, done(made) here, where there are no errors.
    void make(std::function<void(Made&, std::atomic<bool>&)> finish, std::function<void(const Made&)> done);
    void showWork();
    void choose();
    void copy();

    const Document& m_document;
    ViewArea& m_views;
    lessons::WindowState m_state;
    QComboBox *m_what, *m_sizes;
    QSpinBox *m_width, *m_height;
    QCheckBox *m_transparent, *m_caption, *m_marks;
    QLabel *m_picture, *m_message;
    QPushButton *m_save, *m_copy, *m_close;
    QProgressBar* m_progress;
    bool m_ready = false;
    // Of the newest job. Set once, by whichever comes first: the write begins, or the user cancels.
    std::shared_ptr<std::atomic<bool>> m_decided;
    BackgroundJob m_job;
};

}  // namespace app
