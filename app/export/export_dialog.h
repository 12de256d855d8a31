#pragma once
#include "app/document/changed_settings.h"
#include "app/document/document.h"
#include "app/document/export_plan.h"
#include "app/widgets/job_dialog.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace app {

class ExportFormats;
class ExportList;

// Chooses buffers, formats, a folder and the picture's size, says what that writes and which
// command line would do the same, and writes it with progress and cancel.
class ExportDialog : public JobDialog {
    Q_OBJECT
public:
    explicit ExportDialog(Document& document, QWidget* parent = nullptr);

    // What pictures carry beside the scene, as TOML.
    void setState(std::string state) { m_state = std::move(state); }
    void setShown(std::vector<pipeline::BufferName> buffers);  // in the window's views
    void choose(const pipeline::BufferName& buffer);           // this one alone
    // Offers pictures of the 3D views too: who writes them, with the vectors of a pixel where one is picked, and their
    // names.
    using WriteViews = std::function<pipeline::Result<std::vector<std::filesystem::path>>(
        const pipeline::Frame& frame, std::optional<glm::ivec2> pixel, const std::filesystem::path& folder)>;
    void setViews(WriteViews write, QStringList files);
    pipeline::ExportRequest request() const;

private:
    QWidget* makeChoices();
    QWidget* makeFields();
    void showFrame();
    QString chooseTarget() override;
    void showOrder() override;
    void start() override;
    std::shared_ptr<const pipeline::Scene> sceneToExport() const;

    Document& m_document;
    ChangedSettings m_changes;
    QWidget* m_choices;
    QPushButton* m_onlyShown;
    ExportList* m_buffers;
    ExportFormats* m_formats;
    QLineEdit *m_width, *m_height;
    QCheckBox* m_views;
    QLabel *m_total, *m_files;
    WriteViews m_writeViews;
    QStringList m_viewFiles;
    std::string m_state;
    std::vector<pipeline::BufferName> m_shown;
};

}  // namespace app
