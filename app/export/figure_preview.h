#pragma once
#include <QWidget>
#include <functional>

#include "app/jobs/background_job.h"
#include "pipeline/export/figure/figure.h"

class QLabel;

namespace app {

// A figure as it is printed, as large as the room allows, with its size in mm.
class FigurePreview : public QWidget {
    Q_OBJECT
public:
    explicit FigurePreview(QWidget* parent = nullptr);

    // Makes the figure away from the window; the one before stays until then.
    void ask(std::function<pipeline::Figure()> make);
    void showWords(const QString& words);  // in place of a figure

signals:
    void made(const pipeline::Figure& figure);
    void refused(const QString& why);
    void roomChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Made;
    void take(const Made& made);
    QSize room() const;  // in pixels of the screen

    QLabel *m_picture, *m_size;
    BackgroundJob m_job;
};

}  // namespace app
