#pragma once
#include <QDialog>

#include "app/core/changed_settings.h"
#include "app/core/document.h"
#include "app/core/export_plan.h"
#include "app/panels/tab_order.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace app {

class ExportFormats;
class ExportJob;
class ExportList;
class JobFoot;

// Chooses buffers, formats, a folder and the picture's size, says what that writes and which
// command line would do the same, and writes it with progress and cancel.
class ExportDialog : public QDialog {
    Q_OBJECT
public:
    explicit ExportDialog(Document& document, QWidget* parent = nullptr);

    // What pictures carry beside the scene, as TOML.
    void setState(std::string state) { m_state = std::move(state); }
    void setShown(std::vector<pipeline::BufferName> buffers);  // in the window's views
    void choose(const pipeline::BufferName& buffer);           // this one alone
    pipeline::ExportRequest request() const;

protected:
    bool focusNextPrevChild(bool next) override { return focusNext(*this, next) || QDialog::focusNextPrevChild(next); }

private:
    QWidget* makeChoices();
    QWidget* makeTarget();
    void showFrame();
    void showSummary();
    std::shared_ptr<const pipeline::Scene> sceneToExport() const;
    void start();
    void finish(const QString& sentence, bool done);

    Document& m_document;
    ChangedSettings m_changes;
    QWidget* m_choices;
    QPushButton* m_onlyShown;
    ExportList* m_buffers;
    ExportFormats* m_formats;
    QLineEdit* m_folder;
    QLineEdit *m_width, *m_height;
    QLabel *m_total, *m_files;
    JobFoot* m_foot;
    ExportJob* m_job = nullptr;
    QString m_written;  // where the job's files go, whatever the field says meanwhile
    std::string m_state;
    std::vector<pipeline::BufferName> m_shown;
};

}  // namespace app
