#pragma once
#include "app/document/changed_settings.h"
#include "app/document/document.h"
#include "app/export/film_job.h"
#include "app/widgets/job_dialog.h"

class QCheckBox;
class QComboBox;
class QSpinBox;

namespace app {

// A film of a buffer's build-up, step by step: which buffer, what a step is, how many pictures, and where it goes. Written
// with progress and cancel.
class FilmDialog : public JobDialog {
    Q_OBJECT
public:
    // buffer: the one that it offers first, where that has pixels.
    FilmDialog(Document& document, const pipeline::BufferName& buffer, QWidget* parent = nullptr);

    FilmOrder order() const;

private:
    QWidget* makeFields(const pipeline::BufferName& buffer);
    QString chooseTarget() override;
    void showOrder() override;
    void start() override;

    Document& m_document;
    ChangedSettings m_changes;
    QComboBox *m_buffer, *m_level, *m_end;
    QSpinBox *m_pictures, *m_milliseconds;
    QCheckBox *m_captions, *m_algorithm;
    std::filesystem::path m_mayReplace;  // what is there: it was asked for
};

}  // namespace app
