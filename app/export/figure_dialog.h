#pragma once
#include <QDialog>
#include <functional>

#include "app/document/changed_settings.h"
#include "app/export/figure_order.h"
#include "app/jobs/background_job.h"
#include "app/widgets/job_bar.h"

namespace app {

class FigureFields;
class FigurePreview;

// A figure for a text: what it shows and how large it is, with the figure itself as it is printed. Saved, or copied as
// SVG and as a picture.
class FigureDialog : public QDialog {
    Q_OBJECT
public:
    // first: the buffer to begin with, its part in view and its range.
    FigureDialog(Document& document, const FigureOrder& first, QWidget* parent = nullptr);

    void save(const QString& file);  // away from the window; the dialog says what came of it
    QString message() const { return m_foot->message(); }
    void reject() override;  // cancels what is being made, and stays to say so; else closes

private:
    // What the figure is made of, or why there is none.
    struct Parts {
        pipeline::FramePtr frame;
        FigureOrder order;
        std::optional<pipeline::AnyBuffer> buffer = {};
        std::string meaning = {};
        QString whyNot = {};
    };
    Parts parts() const;
    void follow();  // the order: asks for its buffer
    void preview();
    void choose();
    void copy();
    // Makes it in these formats away from the window, then done(files) here.
    void write(std::vector<pipeline::FigureFormat> formats, std::function<void(const std::vector<std::string>&)> done);

    Document& m_document;
    ChangedSettings m_changes;
    FigureFields* m_fields;
    FigurePreview* m_preview;
    JobBar* m_foot;
    QString m_file;  // saved last
    BackgroundJob m_writing;
};

}  // namespace app
