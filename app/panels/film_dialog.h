#pragma once
#include <QDialog>

#include "app/core/changed_settings.h"
#include "app/core/document.h"
#include "app/core/film_job.h"
#include "app/panels/tab_order.h"

class QCheckBox;
class QComboBox;
class QLineEdit;
class QSpinBox;

namespace app {

class JobFoot;

// A film of a buffer's build-up, step by step: which buffer, what a step is, how many pictures, and where it goes. Written
// with progress and cancel.
class FilmDialog : public QDialog {
    Q_OBJECT
public:
    // buffer: the one that it offers first, where that has pixels.
    FilmDialog(Document& document, const pipeline::BufferName& buffer, QWidget* parent = nullptr);

    FilmOrder order() const;
    QString message() const;

protected:
    bool focusNextPrevChild(bool next) override { return focusNext(*this, next) || QDialog::focusNextPrevChild(next); }

private:
    QWidget* makeFields(const pipeline::BufferName& buffer);
    void showOrder();
    void chooseTarget();
    void start();
    void finish(const QString& sentence, bool done);

    Document& m_document;
    ChangedSettings m_changes;
    QComboBox *m_buffer, *m_level, *m_end;
    QSpinBox *m_pictures, *m_milliseconds;
    QCheckBox* m_captions;
    QLineEdit* m_target;
    JobFoot* m_foot;
    FilmJob* m_job = nullptr;
    QString m_written;  // where the job's film goes, whatever the field says meanwhile
};

}  // namespace app
